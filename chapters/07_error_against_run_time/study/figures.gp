load style
rooms = folder."../../chapters/07_error_against_run_time/study/"

library = "Timestep"
springs = "explicit_euler implicit_euler semi_implicit_euler verlet velocity_verlet implicit_midpoint bdf2 runge_kutta_4"
flights = "explicit_euler implicit_euler semi_implicit_euler heun implicit_midpoint runge_kutta_4"
spins = "explicit dropped one_newton_step implicit__converged passive runge_kutta_4"
slides = "explicit dropped one_newton_step passive passive__arms_of_the_start runge_kutta_4_in_the_air__passive"
time_label = "run time of four seconds of game (µs)"
error_label = "largest error (share of the scene's size)"

# On a phone the key stands below.
edge(share) = narrow ? 0.96 : share
foot = 0.32
rows = 4
beside = narrow ? "set bmargin at screen foot; set key at screen 0.5,(foot - 0.13)/2 center vertical maxrows rows reverse Left width -5" : "set key outside right top vertical"

call figure "spring.svg" 860 560 600
set rmargin at screen edge(0.73)
set xlabel time_label
set ylabel error_label
@beside samplen 2 spacing 1.1
call rooms."diagram.gp" "spring" springs "1e-7"
unset rmargin
unset bmargin

# Two panels, one above the other, and the key to their right; on a phone at the foot.
left = "set lmargin at screen 0.12; set rmargin at screen 0.7; set tmargin at screen 0.93; set bmargin at screen 0.59; set ylabel 'largest error' offset 1.5; unset xlabel; set key off"
right = "set tmargin at screen 0.46; set bmargin at screen 0.12; set xlabel 'run time (µs)'; set key at screen 0.715,0.9 left top vertical reverse Left samplen 2 spacing 1.1"
if (narrow) {
    left = "set lmargin at screen 0.21; set rmargin at screen 0.96; set tmargin at screen 0.945; set bmargin at screen 0.64; set ylabel 'largest error' offset 1.5; unset xlabel; set key off"
    right = "set tmargin at screen 0.53; set bmargin at screen 0.21; set xlabel 'run time (µs)'; set key at screen 0.5,0.065 center vertical maxrows 4 reverse Left samplen 2 width -5"
}
done = "unset multiplot; unset title; unset lmargin; unset rmargin; unset tmargin; unset bmargin"

call figure "stiff.svg" 860 800 900
set multiplot
@left
set title "a stiff spring" textcolor rgb ink
call rooms."diagram.gp" "stiff_spring" springs "1e-4"
@right
set title "two time scales"
call rooms."diagram.gp" "two_time_scales" springs "1e-4"
@done

call figure "bounces.svg" 860 800 900
set multiplot
@left
set title "a flight in air"
call rooms."diagram.gp" "drag" flights "1e-7"
@right
set title "a ball that bounces"
call rooms."diagram.gp" "bouncing_ball" flights "1e-7"
@done

call figure "spins.svg" 860 800 900
set multiplot
@left
set title "a box that tumbles"
call rooms."diagram.gp" "dzhanibekov" spins "1e-7"
@right
if (narrow) { set key maxrows 3 width -3 }
set title "a capsule in the air"
call rooms."diagram.gp" "symmetric_top" spins "1e-7"
@done

rows = 6
foot = 0.4
call figure "ice.svg" 860 480 640
set rmargin at screen edge(0.64)
set xlabel time_label
set ylabel error_label
@beside samplen 1.5 spacing 1.1
call rooms."diagram.gp" "capsule_on_plane" slides "1e-3"
unset rmargin
unset bmargin

call figure "smooth.svg" 860 800 900
set multiplot
@left
set title "a damped spring"
call rooms."diagram.gp" "damped_spring" "explicit_euler implicit_euler semi_implicit_euler semi_implicit_euler__new_damping implicit_midpoint bdf2 runge_kutta_4" "1e-7"
@right
set title "a ball on an elastic in space"
call rooms."diagram.gp" "spring_3d" springs "1e-7"
@done

# The spring once more, with other people's libraries where they were found, and in float.
rows = 10
foot = 0.47
call figure "peers.svg" 860 600 840
set rmargin at screen edge(0.66)
set xlabel time_label
set ylabel error_label
@beside samplen 2 spacing 1.1
call rooms."axes.gp" "1e-15"
set xrange [0.05:1e4]
curves = "0.1 with lines @faint notitle"
add = "stats 'spring.tsv' skip 1 using (strcol(1) eq method && strcol(2) eq who ? 2 : 1) nooutput; if (STATS_max == 2) { curves = curves . sprintf(\", 'spring.tsv' using (strcol(1) eq '%s' && strcol(2) eq '%s' && strcol(9) eq 'no' ? $6*1e6 : NaN):5 with lines %s title '%s'\", method, who, style, words) }"
method = "runge_kutta_4"
who = "Timestep"; style = runge_kutta_4; words = "RK4, Timestep"
@add
who = "Timestep, float"; style = "lc rgb '#7a4a1e' lw 2.5 dt (3,4)"; words = "RK4, Timestep in float"
@add
who = "Boost.odeint"; style = "lc rgb '#d55e00' lw 2.5 dt (10,4,3,4)"; words = "RK4, Boost.odeint"
@add
who = "SUNDIALS"; style = "lc rgb '#0072b2' lw 2.5 dt 1"; words = "RK4, SUNDIALS"
@add
method = "runge_kutta_4__doubled"; who = "GSL"; style = "lc rgb '#009e73' lw 2.5 dt 1"; words = "RK4, GSL (doubles steps)"
@add
method = "dormand_prince_5"; who = "Boost.odeint"; style = "lc rgb '#e69f00' lw 2.5 dt 1"; words = "Dormand–Prince 5, odeint"
@add
method = "dormand_prince_5__adaptive"; style = "lc rgb '#e69f00' lw 2.5 dt (6,4)"; words = "the same, adaptive"
@add
method = "prince_dormand_8__adaptive"; who = "GSL"; style = "lc rgb '#009e73' lw 2.5 dt (6,4)"; words = "Prince–Dormand 8, GSL"
@add
method = "adams__adaptive"; who = "SUNDIALS"; style = "lc rgb '#56b4e9' lw 2.5 dt (6,4)"; words = "Adams, SUNDIALS"
@add
method = "bdf__adaptive"; style = "lc rgb '#2f4b7c' lw 2.5 dt (6,4)"; words = "BDF, SUNDIALS"
@add
eval "plot " . curves

# Who falls asleep, and when?
call figure "sleeping.svg" 640 480 600
set lmargin
set rmargin
set tmargin
set bmargin
unset label
unset arrow
unset title
unset logscale
set logscale y
set xtics autofreq
set ytics autofreq
set format y "%g"
set xlabel "time (s)\n " offset 0,0.4
set ylabel "fastest in half a second (m/s)"
set xrange [0:45]
set yrange [0.03:5]
set key outside bottom center vertical maxrows (narrow ? 6 : 3) reverse Left
plot 0.05 with lines @faint title "threshold", \
     "sleep_exact.tsv" using 1:2 with lines @exact title "exact", \
     "sleep_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit", \
     "sleep_constant_acceleration.tsv" using 1:2 with lines @constant_acceleration title "constant acceleration", \
     "sleep_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit", \
     "sleep_implicit_euler.tsv" using 1:2 with lines @implicit_euler title "implicit"
