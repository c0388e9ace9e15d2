# The map: below its line a method is stable on a damped spring.
call figure "boundary.svg" 640 700
set logscale xy
set xrange [0.0035:10]
set yrange [0.015:60]
set xtics ("0" 0.005, "0.01" 0.01, "0.03" 0.03, "0.1" 0.1, "0.3" 0.3, "1" 1, "3" 3, "10" 10)
set format y "%g"
set xlabel "damping ratio ζ\n " offset 0,0.4
set ylabel "longest stable ωh (rad)"
set key outside bottom center vertical maxrows 4 reverse Left
set label 2 "our spring" at 0.05,1.667 point pt 7 ps 0.9 lc rgb ink right offset 0.6,-1 textcolor rgb ink
set label 1 "no limit: implicit Euler,\nimplicit midpoint, BDF2" at 0.02,33 left textcolor rgb ink
set label 3 "new damping" at 2.2,13 right textcolor rgb "#007a58"
plot "edge_semi_implicit_euler__new_damping.tsv" using 1:2 with lines @new_damping title "new damping", \
     "edge_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "edge_runge_kutta_4.tsv" using 1:2 with lines @runge_kutta_4 title "RK4", \
     "edge_midpoint.tsv" using 1:2 with lines @midpoint title "midpoint, Heun", \
     "edge_newton.tsv" using 1:2 with lines @newton title "Newton", \
     "edge_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit Euler", \
     "edge_measured_semi_implicit_euler__new_damping.tsv" using 1:2 with points pt 6 ps 0.8 lc rgb "#009e73", \
     "edge_measured_semi_implicit_euler.tsv" using 1:2 with points pt 6 ps 0.8 lc rgb "#009e73", \
     "edge_measured_runge_kutta_4.tsv" using 1:2 with points pt 6 ps 0.8 lc rgb "#7a4a1e", \
     "edge_measured_midpoint.tsv" using 1:2 with points pt 6 ps 0.8 lc rgb "#e69f00", \
     "edge_measured_newton.tsv" using 1:2 with points pt 6 ps 0.8 lc rgb "#e0a800", \
     "edge_measured_explicit_euler.tsv" using 1:2 with points pt 6 ps 0.8 lc rgb "#d55e00", \
     "edge_undamped.tsv" every ::0::2 using (0.005):2 with points pt 4 ps 1.3 lw 1.6 lc rgb "#b15a98" title "Verlets (ζ = 0)"
unset label
unset logscale
set autoscale
set xtics autofreq
set format xy "%g"
