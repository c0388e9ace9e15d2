# Substeps against iterations, for as many sweeps.
call figure "substeps.svg" 640 420
set size noratio
set logscale xy
set format xy "%g"
set xlabel "sweeps over the links a frame\n " offset 0,0.4
set ylabel "too long by (%)"
set xrange [0.9:36]
set yrange [0.03:100]
set xtics (1,2,4,8,16,32)
set key outside bottom center horizontal reverse Left
plot "substeps.tsv" using 1:2 with linespoints @second pt 7 ps 0.7 title "iterations in one step", \
     "" using 1:3 with linespoints @first pt 7 ps 0.7 title "substeps of one iteration"
unset logscale
set xtics autofreq

# A kick that a method is not told of.
call figure "kick.svg" 640 420 500
set autoscale
set xlabel "time (s)\n " offset 0,0.4
set ylabel "place (m)"
set xrange [0.1:0.4]
set yrange [-0.02:0.32]
set key inside top left vertical reverse Left
@key_below
plot "kick.tsv" using 1:2 with lines @exact title "exact, and all three once told", \
     "" using 1:3 with lines @bdf2 title "BDF2", \
     "" using 1:4 with lines @adams_bashforth title "Adams–Bashforth", \
     "" using 1:5 with lines @verlet title "Verlet"

# The energy of a double pendulum in angles.
call figure "drift.svg" 640 420 500
set autoscale
set logscale y
set xlabel "minutes, at 60 frames per second\n " offset 0,0.4
set ylabel "energy over the first"
set xrange [0:10]
set yrange [0.05:20]
set key outside bottom center horizontal reverse Left
@key_below
plot "drift.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "" using 1:3 with lines @new_damping title "the same, four steps per frame", \
     "" using 1:4 with lines @runge_kutta_4 title "RK4"
unset logscale

# The longest step of a plank on one spring.
call figure "effective_mass.svg" 640 420 500
set autoscale
set xlabel "how far along the plank the spring holds it (m)\n " offset 0,0.4
set ylabel "longest stable step (ms)"
set xrange [0:1]
set yrange [0:70]
set key inside bottom left vertical reverse Left
@key_below
plot "effective_mass.tsv" using 1:3 with lines @faint title "with the mass alone", \
     "" using 1:2 with lines @semi_implicit_euler title "with the effective mass", \
     "effective_mass_points.tsv" using 1:2 with points pt 6 ps 0.9 lc rgb "#007a59" title "found by running"
