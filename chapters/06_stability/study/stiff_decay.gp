# A decay with hλ = −1000: who lets it die?
call figure "stiff_decay.svg" 640 760
set multiplot layout 2,1 margins side(0.17),0.97,0.25,0.98 spacing 0.02,0.05
set xrange [0:10]
set yrange [-1.15:1.15]
set ytics 0.5
set format x ""
set ylabel "y"
unset key
unset xlabel
plot "stiff_implicit_midpoint.tsv" using 1:2 with linespoints @implicit_midpoint pt 7 ps 0.6, \
     "stiff_bdf2.tsv" using 1:2 with linespoints @bdf2 pt 7 ps 0.6, \
     "stiff_implicit_euler.tsv" using 1:2 with linespoints @implicit_euler pt 7 ps 0.6
set logscale y
set yrange [1e-32:1e45]
set ytics autofreq
set ytics ("1" 1, "10^{−30}" 1e-30, "10^{−15}" 1e-15, "10^{15}" 1e15, "10^{30}" 1e30, "10^{45}" 1e45)
set format x "%g"
set xlabel "steps\n " offset 0,0.4
set ylabel "size of y" offset 2,0
set key at screen 0.55,0.075 center vertical maxrows 3 reverse Left
plot "stiff_runge_kutta_4.tsv" using 1:3 with linespoints @runge_kutta_4 pt 7 ps 0.6 title "RK4", \
     "stiff_explicit_euler.tsv" using 1:3 with linespoints @explicit_euler pt 7 ps 0.6 title "explicit Euler", \
     "stiff_implicit_midpoint.tsv" using 1:3 with linespoints @implicit_midpoint pt 7 ps 0.6 title "implicit midpoint", \
     "stiff_bdf2.tsv" using 1:3 with linespoints @bdf2 pt 7 ps 0.6 title "BDF2", \
     "stiff_implicit_euler.tsv" using 1:3 with linespoints @implicit_euler pt 7 ps 0.6 title "implicit Euler"
unset multiplot
unset logscale
set ytics autofreq
set ylabel offset 0,0
set autoscale

# Undamped swings, from slow to absurdly fast.
call figure "swings.svg" 640 520 560
set logscale xy
set xrange [0.01:1000]
set yrange [8e-4:20]
set format x "10^{%T}"
set format y "%g"
set ytics (0.001, 0.01, 0.1, 1, 10)
set xlabel "ωh (rad)\n " offset 0,0.4
set ylabel "growth of an oscillation a step"
set key outside bottom center vertical maxrows 3 reverse Left
if (narrow) { set bmargin at screen 0.3; set key at screen 0.5,0.1 center width -4 }
plot "swing_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "swing_velocity_verlet.tsv" using 1:2 with lines @verlet title "velocity Verlet", \
     "swing_runge_kutta_4.tsv" using 1:2 with lines @runge_kutta_4 title "RK4", \
     "swing_implicit_midpoint.tsv" using 1:2 with lines @implicit_midpoint title "implicit midpoint", \
     "swing_bdf2.tsv" using 1:2 with lines @bdf2 title "BDF2", \
     "swing_implicit_euler.tsv" using 1:2 with lines @implicit_euler title "implicit Euler", \
     "swing_measured_semi_implicit_euler.tsv" using 1:2 with points pt 6 ps 0.7 lc rgb "#009e73", \
     "swing_measured_runge_kutta_4.tsv" using 1:2 with points pt 6 ps 0.7 lc rgb "#7a4a1e", \
     "swing_measured_implicit_midpoint.tsv" using 1:2 with points pt 6 ps 0.7 lc rgb "#000000", \
     "swing_measured_bdf2.tsv" using 1:2 with points pt 6 ps 0.7 lc rgb "#2f4b7c", \
     "swing_measured_implicit_euler.tsv" using 1:2 with points pt 6 ps 0.7 lc rgb "#0072b2"
unset logscale
set format xy "%g"
set ytics autofreq
set autoscale
unset bmargin
