load style

# Each part of the chapter draws its own pictures.
rooms = folder."../../chapters/06_stability/study/"
load rooms."regions.gp"
load rooms."stiff_decay.gp"
load rooms."stiff.gp"
load rooms."extremes.gp"
load rooms."leave_out.gp"
load rooms."cures.gp"
