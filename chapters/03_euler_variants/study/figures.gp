load style

# Smaller steps: closer, and dearer.
call figure "smaller_steps.svg" 640 480
set size noratio
set autoscale
set xlabel "time t (s)\n "
set ylabel "position x (m)"
set key outside bottom center horizontal reverse Left
plot "smaller_exact.tsv" using 1:2 with lines @exact title "exact", \
     "smaller_1.tsv" using 1:2 with lines lc rgb "#d55e00" lw 2.5 dt 1 title "h", \
     "smaller_2.tsv" using 1:2 with lines lc rgb "#d55e00" lw 2.5 dt (14,5) title "h/2", \
     "smaller_4.tsv" using 1:2 with lines lc rgb "#d55e00" lw 2.5 dt (6,4) title "h/4", \
     "smaller_8.tsv" using 1:2 with lines lc rgb "#d55e00" lw 2 dt (2,3) title "h/8"

# Implicit Euler there, explicit Euler with −h back.
call figure "backwards.svg" 640 560
set size ratio -1
set xlabel "position x (m)\n " offset 0,0.4
set ylabel "velocity v / ω (m)"
set xrange [-1.15:1.15]
set yrange [-1.15:1.15]
set key outside bottom center horizontal Left reverse
plot "exact.tsv" using 1:2 with lines @exact title "exact", \
     "there.tsv" using 2:3 with lines @implicit_euler title "implicit, h", \
     "back.tsv" using 2:3 with points pt 6 ps 0.9 lw 1.6 lc rgb "#d55e00" title "explicit, −h"

# What a step makes of the unit square, and of its area.
call figure "square.svg" 640 560
set xlabel "position x (m)\n " offset 0,0.4
set ylabel "velocity v / ω (m)"
set xrange [-0.3:1.8]
set yrange [-0.8:1.3]
set key outside bottom center horizontal Left reverse
plot "square_before.tsv" using 1:2 with lines @exact title "before", \
     "square_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit", \
     "square_implicit_euler.tsv" using 1:2 with lines @implicit_euler title "implicit", \
     "square_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit"

# Powers of a complex number: turned and stretched again and again.
call figure "turn_and_stretch.svg" 640 620 690
set xrange [-2.7:2.7]
set yrange [-2.7:2.7]
@key_below
plot "powers_exact.tsv" using 1:2 with linespoints pt 7 ps 0.7 @exact title "true motion", \
     "powers_explicit_euler.tsv" using (0):(0):1:2 with vectors nohead lc rgb "#d55e00" lw 0.8, \
     "" using 1:2 with linespoints pt 7 ps 0.8 @explicit_euler title "times 1 − 0.5 i", \
     "powers_implicit_euler.tsv" using 1:2 with linespoints pt 6 ps 0.9 @implicit_euler title "divided by 1 + 0.5 i"

# Eigenvalues in the complex plane while ωh grows from 0 to 3.
call figure "eigenvalues.svg" 640 600 670
set xlabel "real part of λ"
set ylabel "imaginary part of λ"
set xrange [-3.2:2.6]
set yrange [-2.9:2.9]
set parametric
set trange [0:2*pi]
set key inside top left vertical reverse Left
set label 2 "ωh = 2" at -1.08,-0.25 right textcolor rgb "#007a59"
set label 3 "ωh = 0" at 1.12,-0.25 left textcolor rgb ink
set label 1 "unit circle" at -0.72,0.98 right textcolor rgb "#666666"
outside = narrow ? 1.5 : 1.42  # of the unit circle: there the numbers stand
@key_below
plot cos(t), sin(t) with lines lc rgb "#8a8a8a" lw 4 dt 1, \
     "eigenvalues_explicit_euler.tsv" using 2:3 with lines @explicit_euler title "explicit", \
     "" using 4:5 with lines @explicit_euler, \
     "eigenvalues_implicit_euler.tsv" using 2:3 with lines @implicit_euler title "implicit", \
     "" using 4:5 with lines @implicit_euler, \
     "eigenvalues_semi_implicit_euler.tsv" using 2:3 with lines @semi_implicit_euler title "semi-implicit", \
     "" using 4:5 with lines @semi_implicit_euler, \
     "eigenvalues_explicit_euler.tsv" every ::1::1 using 2:3 with points pt 7 ps 0.8 lc rgb ink, \
     "eigenvalues_semi_implicit_euler.tsv" every ::81::81 using 2:3 with points pt 7 ps 0.8 lc rgb "#007a59", \
     "" every 20::21::61 using 2:3 with points pt 7 ps 0.8 lc rgb "#007a59", \
     "" every 20::21::61 using (outside*$2):(outside*$3):(sprintf("%.1f", $1)) with labels textcolor rgb "#007a59"
unset parametric
unset label

# The magnitude: growth a step, formula and measurement.
call figure "growth.svg" 640 440
set size noratio
set xlabel "ωh (rad)"
set ylabel "growth of the amplitude a step"
set xrange [0:3]
set yrange [0:3.5]
set key inside top left vertical reverse Left
plot 1 with lines lc rgb "#8a8a8a" lw 4 dt 1, \
     "eigenvalues_explicit_euler.tsv" using 1:6 with lines @explicit_euler title "explicit", \
     "growth_explicit_euler.tsv" using 1:2 with points pt 6 ps 0.9 lc rgb "#d55e00", \
     "eigenvalues_implicit_euler.tsv" using 1:6 with lines @implicit_euler title "implicit", \
     "growth_implicit_euler.tsv" using 1:2 with points pt 6 ps 0.9 lc rgb "#0072b2", \
     "eigenvalues_semi_implicit_euler.tsv" using 1:6 with lines @semi_implicit_euler title "semi-implicit", \
     "growth_semi_implicit_euler.tsv" using 1:2 with points pt 6 ps 0.9 lc rgb "#009e73"

# With damping: the longest stable step.
call figure "damping.svg" 640 560
set xlabel "damping ratio ζ\n "
set ylabel "longest stable ωh (rad)"
set xrange [0:3]
set yrange [0:7]
set key outside bottom center vertical reverse Left
plot "damping_lines.tsv" using 1:4 with lines lc rgb "#009e73" lw 2.5 dt (14,5) title "semi-implicit, new velocity damped", \
     "damping_lines.tsv" using 1:3 with lines @semi_implicit_euler title "semi-implicit, old velocity damped", \
     "damping_lines.tsv" using 1:2 with lines @explicit_euler title "explicit", \
     "damping_points.tsv" using 1:4 with points pt 6 ps 0.9 lc rgb "#009e73", \
     "" using 1:3 with points pt 6 ps 0.9 lc rgb "#009e73", \
     "" using 1:2 with points pt 6 ps 0.9 lc rgb "#d55e00"

# Two hard dampers across each other: the energy.
call figure "dampers.svg" 640 460 500
set logscale y
set format y "10^{%T}"
set xlabel "time t (s)\n " offset 0,0.4
set ylabel "energy / energy at the start"
set xrange [0:1]
set yrange [1e-10:1e3]
set key outside bottom center horizontal reverse Left
plot 1 with lines @faint, \
     "dampers.tsv" using 1:2 with lines @exact title "exact", \
     "" using 1:3 with lines @second title "one after another", \
     "" using 1:4 with lines @first title "there and back", \
     "" using 1:5 with lines @third title "in one matrix"
unset logscale
set format y "%g"

# The same spring as a force and as a soft constraint: what a step multiplies by.
call figure "soft.svg" 640 460 500
set size noratio
set logscale x
set format x "%g"
set xlabel "ωh (rad)\n " offset 0,0.4
set ylabel "a step multiplies the amplitude by"
set xrange [0.05:50]
set yrange [0:2]
set key outside bottom center horizontal reverse Left
plot 1 with lines @faint, \
     "soft.tsv" using 1:2 with lines @exact title "exact", \
     "" using 1:($3 < 3 ? $3 : NaN) with lines @semi_implicit_euler title "semi-implicit", \
     "" using 1:4 with lines @implicit_euler title "soft constraint", \
     "soft_points.tsv" using 1:2 with points pt 6 ps 0.9 lc rgb "#0072b2"
unset logscale

# Energy of the three.
call figure "energy.svg" 640 440 510
set autoscale
set logscale y
set format y "%g"
set xlabel "time t (s)"
set ylabel "energy / energy at the start"
set key top left reverse Left
@key_below
plot 1 with lines @exact title "exact", \
     "energy_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit", \
     "energy_implicit_euler.tsv" using 1:2 with lines @implicit_euler title "implicit", \
     "energy_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit"
unset logscale

# A cloud of states, every ninth step.
call figure "clouds.svg" 640 600 670
set size ratio -1
set xlabel "position x (m)\n " offset 0,0.4
set ylabel "velocity v / ω (m)"
set xrange [-2.1:2.1]
set yrange [-2.1:2.1]
set key bottom left reverse Left
set label 1 "start" at 1.0,(narrow ? -0.45 : 0) center textcolor rgb ink front
set label 2 "9" at 0.5,-1.2 center textcolor rgb ink front
set label 3 "18" at -1.0,(narrow ? -0.7 : -0.6) center textcolor rgb ink front
set label 4 "27" at 0.25,1.35 center textcolor rgb ink front
set label 5 "36" at 1.55,(narrow ? -0.2 : 0) center textcolor rgb ink front
@key_below
plot "cloud_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit", \
     "cloud_implicit_euler.tsv" using 1:2 with lines @implicit_euler title "implicit", \
     "cloud_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit", \
     "cloud_explicit_euler.tsv" every :::0::0 using 1:2 with filledcurves fc rgb "#dddddd" fs solid notitle, \
     "" every :::0::0 using 1:2 with lines lc rgb ink lw 2
unset label

# Semi-implicit Euler towards its limit: a strip of portraits.
call figure "sweep.svg" 640 1180
unset label
unset xlabel
unset ylabel
unset key
set multiplot layout 4,2 margins (narrow ? 0.17 : 0.13),(narrow ? 0.97 : 0.98),0.065,0.97 spacing (narrow ? 0.13 : 0.1),0.075
wh = "0.10 0.50 1.00 1.50 1.90 1.99 2.00 2.01"  # each with the range of its axes
range = "1.6 1.6 1.6 1.6 4 12 24 24"
do for [i=1:8] {
    r = real(word(range, i))
    set xrange [-r:r]
    set yrange [-r:r]
    interval = r < 2 ? 1 : r/2
    set tics interval
    set title "ωh = ".word(wh, i) offset 0,-0.7
    set xlabel (i > 6 ? "position x (m)" : "") offset 0,0.4
    set ylabel (i % 2 ? "velocity v / ω (m)" : "") offset 1,0
    plot "exact.tsv" using 1:2 with lines lc rgb "#8a8a8a" lw 3 dt 1, \
         "sweep_".word(wh, i).".tsv" every ::::200 using 1:2 with lines lc rgb "#009e73" lw (i > 6 ? 1 : 0), \
         "" every ::::200 using 1:2 with points pt 7 ps 0.45 lc rgb "#009e73"
}
unset multiplot
set tics autofreq
unset title
set ylabel offset 0,0

# The same as a film: ωh rises slowly.
call animation "sweep.gif" 480 480 12
set size ratio -1
set xrange [-6:6]
set yrange [-6:6]
set xlabel "position x (m)\n " offset 0,0.4
set ylabel "velocity v / ω (m)"
unset key
do for [i=0:80] {
    plot "exact.tsv" every 5 using 1:2 with lines @exact, \
         "sweep_frames.tsv" index i using 2:3 with points pt 7 ps 3 lw 0.3 lc rgb "#009e73", \
         "" index i every ::1::1 using (0):(5.2):(sprintf("ωh = %.3f   %.2f steps a period", $1, 2*pi/$1)) \
            with labels textcolor rgb ink
}

# How wrong the period is.
call figure "steps_per_period.svg" 640 440
set size noratio
set key bottom right vertical
set xlabel "steps a period\n " offset 0,0.4
set ylabel "error of the period (%)"
set xrange [2:20]
set yrange [-38:4]
set object 1 rectangle from 2,-38 to pi,4 fc rgb "#d55e00" fs solid 0.18 noborder behind
set label 1 "blows up" at 2.57,-17 center rotate by 90 front textcolor rgb "#a34700"
set label 2 "at least 4" at 4.3,-26 left textcolor rgb ink
set arrow 1 from 4,-38 to 4,4 nohead lc rgb ink dt (4,4)
n(x) = 2*pi/acos(1 - (2*pi/x)**2/2)
plot sample [x=pi:20] 100*(n(x)/x - 1) with lines @semi_implicit_euler title "formula", \
     "steps_per_period.tsv" using 1:2 with points pt 7 ps 0.9 lc rgb "#007a59" title "measured"
unset object
unset label
unset arrow

# A cosine without a cosine.
call figure "sine.svg" 640 400 470
set autoscale
set xrange [0:80]
set yrange [-1.35:1.35]
set xlabel "step n"
set ylabel "position x (m)"
set key top right horizontal
@key_below
plot "sine.tsv" using 1:3 with lines @exact title "A cos(nθ + φ)", \
     "" using 1:2 with points pt 7 ps 0.6 lc rgb "#009e73" title "stepped"

# Order: the error after the run against the step.
call figure "orders.svg" 640 560
set autoscale
set logscale xy
set format xy "10^{%T}"
set xlabel "steps a period\n " offset 0,0.4
set ylabel "error after the run (m)"
set key outside bottom center horizontal reverse Left font ",15" width (narrow ? -1 : 2)
set yrange [1e-14:1]
plot "orders_explicit_euler.tsv" using 1:4 with lines @explicit_euler title "explicit Euler", \
     "orders_implicit_euler.tsv" using 1:4 with lines @implicit_euler title "implicit Euler", \
     "orders_semi_implicit_euler.tsv" using 1:4 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "orders_midpoint.tsv" using 1:4 with lines @midpoint title "midpoint", \
     "orders_heun.tsv" using 1:4 with lines @heun title "Heun", \
     "orders_implicit_midpoint.tsv" using 1:4 with lines @implicit_midpoint title "implicit midpoint", \
     "orders_bdf2.tsv" using 1:4 with lines @bdf2 title "BDF2", \
     "orders_runge_kutta_4.tsv" using 1:4 with lines @runge_kutta_4 title "RK4"

# The same for a single step.
call figure "local_orders.svg" 640 600
set key outside bottom center horizontal reverse Left font ",15" width (narrow ? -1 : 2)
set ylabel "error of one step (m)"
set yrange [1e-17:0.1]
plot "orders_explicit_euler.tsv" using 1:3 with lines @explicit_euler title "explicit Euler", \
     "orders_implicit_euler.tsv" using 1:3 with lines @implicit_euler title "implicit Euler", \
     "orders_semi_implicit_euler.tsv" using 1:3 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "orders_midpoint.tsv" using 1:3 with lines @midpoint title "midpoint", \
     "orders_heun.tsv" using 1:3 with lines @heun title "Heun", \
     "orders_implicit_midpoint.tsv" using 1:3 with lines @implicit_midpoint title "implicit midpoint", \
     "orders_bdf2.tsv" using 1:3 with lines @bdf2 title "BDF2", \
     "orders_runge_kutta_4.tsv" using 1:3 with lines @runge_kutta_4 title "RK4"

# Error against run time.
call figure "work.svg" 640 560
set xlabel "run time (µs for 20 s of one spring)\n " offset 0,0.4
set ylabel "error at the end (m)"
set xrange [0.02:2000]
set yrange [1e-10:2]
set key outside bottom center horizontal reverse Left font ",15" width (narrow ? -1 : 2)
plot "work_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit Euler", \
     "work_implicit_euler.tsv" using 1:2 with lines @implicit_euler title "implicit Euler", \
     "work_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "work_midpoint.tsv" using 1:2 with lines @midpoint title "midpoint", \
     "work_heun.tsv" using 1:2 with lines @heun title "Heun", \
     "work_implicit_midpoint.tsv" using 1:2 with lines @implicit_midpoint title "implicit midpoint", \
     "work_bdf2.tsv" using 1:2 with lines @bdf2 title "BDF2", \
     "work_runge_kutta_4.tsv" using 1:2 with lines @runge_kutta_4 title "RK4"

# Collisions: the order of every method falls to one.
call figure "bounce.svg" 640 460
set multiplot
set xrange [2e-4:6e-2]
set yrange [1e-14:1]
set xlabel "step h (s)"
set format x "10^{%T}"
set lmargin at screen 0.19
set rmargin at screen 0.56
set bmargin at screen 0.17
set tmargin at screen 0.88
set title "while it falls" textcolor rgb ink
set ylabel "mean error of the height (m)" offset 0.5,0
set label 1 "semi-implicit" at 2.4e-4,5e-4 left textcolor rgb "#007a59"
set label 2 "midpoint" at 2.4e-4,4e-7 left textcolor rgb "#9a6a00"
set label 3 "RK4" at 5e-4,3e-13 left textcolor rgb "#7a4a1e"
plot "fall_semi_implicit_euler.tsv" using 1:2 with linespoints @semi_implicit_euler pt 7 ps 0.6, \
     "fall_midpoint.tsv" using 1:2 with linespoints @midpoint pt 7 ps 0.6, \
     "fall_runge_kutta_4.tsv" using 1:2 with linespoints @runge_kutta_4 pt 7 ps 0.6
set lmargin at screen 0.59
set rmargin at screen 0.96
set title "once it has bounced"
unset ylabel
set format y ""
unset label
plot "bounce_semi_implicit_euler.tsv" using 1:2 with linespoints @semi_implicit_euler pt 7 ps 0.6, \
     "bounce_midpoint.tsv" using 1:2 with linespoints @midpoint pt 7 ps 1, \
     "bounce_runge_kutta_4.tsv" using 1:2 with linespoints @runge_kutta_4 pt 7 ps 0.5
unset multiplot
unset title
set lmargin; set rmargin; set tmargin; set bmargin
set format x "10^{%T}"
set format y "10^{%T}"

# What a step costs, as bars: each of many springs, and a pendulum.
call figure "costs.svg" 640 520
unset logscale
set format xy "%g"
set xrange [0.2:300]
set logscale x
set yrange [8.6:0.4]
set ytics nomirror scale 0
unset grid
set grid xtics lc rgb soft lt 1 lw 0.8
set xlabel "time of a step (ns)\n " offset 0,0.4
unset ylabel
set boxwidth 0.35
set style fill solid noborder
set key outside bottom center horizontal
if (narrow) { set key bottom right }
bar = 0.36
plot "costs.tsv" using (0.2):($0-bar/2):(0.2):5:($0-bar):($0):ytic(1) with boxxyerror lc rgb "#8a8a8a" title "each of 1000 springs", \
     "costs.tsv" using (0.2):($0+bar/2):(0.2):6:($0):($0+bar) with boxxyerror lc rgb "#333333" title "a pendulum"
