# The one style of every figure. A chapter's figures.gp begins with `load style`.
#
#   call figure "portraits.svg" 640 560      opens a still picture of that size
#   call animation "sweep.gif" 640 420 6     opens an animation, hundredths of a second a frame
#   plot "spring.tsv" using 2:3 @explicit_euler title "explicit Euler"
#
# A method has the same colour and dashes in every picture; the palette is that of Okabe and Ito,
# which colour-blind readers can tell apart.

# Every still picture is drawn twice: the second time narrow = 1, for phones, which show some 370 pixels of `phone`. There
# @key_below moves the key out of the picture, to below it, and scripts ask `narrow` for what else has to move.
if (!exists("narrow")) narrow = 0
phone = 480
side(share) = narrow ? share*640/phone : share  # of a picture that is 640 wide: as many pixels of the narrow one
key_below = "if (narrow) { set key outside bottom center vertical reverse Left title ' ' }"

folder = style[1:strstrt(style, "style.gp") - 1]
figure = folder . "figure.gp"
animation = folder . "animation.gp"

set encoding utf8
set macros
set datafile separator "\t"
set datafile commentschars "#"
set key autotitle columnhead
set samples 400

ink = "#333333"
soft = "#dddddd"
on_paint = "#000001"  # words on a painted cell: black on dark pages, too
set border 3 lc rgb ink lw 1
set tics nomirror out scale 0.6 textcolor rgb ink
set grid lc rgb soft lt 1 lw 0.8
set xzeroaxis lc rgb soft lt 1
set yzeroaxis lc rgb soft lt 1
set key noautotitle textcolor rgb ink

# The one table of what a method looks like. No two that stand in one picture share a colour, but for relatives, whose
# dashes differ: a method and its variant, and the two orders of a splitting. A method of springs and a way to treat the
# gyroscopic torque may share one, as they never meet. tools/live/colours.hpp has the same for the panels, and
# docs/theme/live.js their dark ones; a test holds them equal. A new colour also gets a row in dark.tsv.
exact                = "lc rgb '#8a8a8a' lw 5 dt 1"
explicit_euler       = "lc rgb '#d55e00' lw 2.5 dt 1"
implicit_euler       = "lc rgb '#0072b2' lw 2.5 dt (14,5)"
semi_implicit_euler  = "lc rgb '#009e73' lw 2.5 dt 1"
new_damping          = "lc rgb '#009e73' lw 2.5 dt (14,5)"
verlet               = "lc rgb '#b15a98' lw 2.5 dt (6,4)"
velocity_verlet      = "lc rgb '#b15a98' lw 2.5 dt 1"
constant_acceleration = "lc rgb '#808000' lw 2.5 dt (3,4)"
midpoint             = "lc rgb '#e69f00' lw 2.5 dt (10,4,3,4)"
heun                 = "lc rgb '#56b4e9' lw 2.5 dt (3,3)"
runge_kutta_4        = "lc rgb '#7a4a1e' lw 2.5 dt 1"
bdf2                 = "lc rgb '#2f4b7c' lw 2.5 dt (18,4,3,4)"
implicit_midpoint    = "lc rgb '#000000' lw 2.5 dt (8,4)"
adams_bashforth      = "lc rgb '#cc6677' lw 2.5 dt (3,4)"
sdirk_3              = "lc rgb '#882255' lw 2.5 dt 1"

# Differences (chapter 1).
forward_difference   = "lc rgb '#d55e00' lw 2.5 dt (14,5)"
backward_difference  = "lc rgb '#009e73' lw 2.5 dt (4,4)"
central_difference   = "lc rgb '#b15a98' lw 2.5 dt (10,4,3,4)"
five_point           = "lc rgb '#0072b2' lw 2.5 dt 1"

# Numbers that are no method: first, second, third quantity of a picture.
first  = "lc rgb '#0072b2' lw 2.5 dt 1"
second = "lc rgb '#d55e00' lw 2.5 dt (14,5)"
third  = "lc rgb '#009e73' lw 2.5 dt (4,4)"
fourth = "lc rgb '#b15a98' lw 2.5 dt (10,4,3,4)"
faint  = "lc rgb '#8a8a8a' lw 1.5 dt (4,4)"

# Ways to treat the gyroscopic torque.
explicit_gyroscopic  = "lc rgb '#d55e00' lw 2.5 dt 1"
no_gyroscopic        = "lc rgb '#b15a98' lw 2.5 dt (14,5)"
lagged_inertia       = "lc rgb '#e69f00' lw 2.5 dt (6,4)"
implicit_gyroscopic  = "lc rgb '#0072b2' lw 2.5 dt (10,4,3,4)"
converged_gyroscopic = "lc rgb '#56b4e9' lw 2.5 dt (3,4)"
passive_gyroscopic   = "lc rgb '#009e73' lw 2.5 dt 1"
# Steps of a whole body beyond the talk (chapter 8).
half_step_jacobian   = "lc rgb '#332288' lw 2.5 dt 1"
calm_half_step       = "lc rgb '#332288' lw 2.5 dt (3,4)"
cayley_gyroscopic    = "lc rgb '#a08400' lw 2.5 dt 1"
strang_splitting     = "lc rgb '#44aa99' lw 2.5 dt (6,4)"
ball_and_remainder_2 = "lc rgb '#882255' lw 2.5 dt (14,5)"
ball_and_remainder_4 = "lc rgb '#882255' lw 2.5 dt 1"
# What Jolt and others do. Box3D, Bullet and MuJoCo have the talk's colour, ODE the passive step's, Godot that of none.
jolt_gyroscopic      = "lc rgb '#999933' lw 2.5 dt 1"

colour_of(style) = style[1:strstrt(style, " lw") - 1]
