load style
dots = "pt 7 ps 0.9 lc rgb '#333333'"

tangent = first

# The question.

call figure "hand.svg" 560 420 490
set xlabel "time t (s)"
set ylabel "velocity (m/s)"
set xrange [0:3.2]
set yrange [-1.4:2.2]
set ytics -1,0.5,1
set key top right
@key_below
plot "hand.tsv" using 1:3 with steps lc rgb '#009e73' lw 1.5 title "two neighbouring frames", \
     "" using 1:2 with lines @exact title "exact", \
     "" using 4:5 with lines lc rgb '#b15a98' lw 2.5 title "two frames further apart"
set ytics autofreq

call figure "gap.svg" 560 420 480
set xlabel "frames from the one position to the other"
set ylabel "largest error of the velocity (m/s)"
set autoscale
set xrange [1:*]
set key top left reverse Left
@key_below
plot "gap.tsv" using 1:2 with linespoints @backward_difference pt 7 ps 0.6 title "as the velocity now", \
     "" using 1:4 with linespoints @central_difference pt 7 ps 0.6 title "as the velocity in between", \
     "" using 1:3 with lines @faint title "predicted", \
     "" using 1:5 with lines @faint

# The mathematics.

call figure "secants.svg" 560 440 510
set xlabel "x"
set ylabel "f (x)"
set autoscale
set key top left reverse Left
@key_below
plot "secants.tsv" using 1:2 with lines @exact title "f", \
     "" using 1:3 with lines @second title "chord, h = 1", \
     "" using 1:4 with lines @third title "chord, h = 1/2", \
     "" using 1:5 with lines @fourth title "chord, h = 1/4", \
     "" using 1:6 with lines @tangent title "tangent", \
     "secant_ends.tsv" using 1:2 with points @dots

call figure "line.svg" 560 380
set xlabel "x"
set ylabel "y"
set xrange [-1:4]
set yrange [0:3.2]
set key off
set arrow 1 from 1,1.5 to 3,1.5 nohead @second
set arrow 2 from 3,1.5 to 3,2.5 nohead @second
set label 1 "run h" at 2,1.25 center textcolor rgb ink
set label 2 "rise" at 3.1,1.95 textcolor rgb ink
set label 3 "y = 0.5 x + 1" at 0.15,0.7 textcolor rgb ink
set label 4 "y = 2.5" at -0.9,2.72 textcolor rgb ink
plot "line.tsv" using 1:2 with lines @first, "" using 1:3 with lines @third, \
     "line_ends.tsv" using 1:2 with points @dots
unset arrow
unset label

call figure "parabola.svg" 560 640
set multiplot layout 2,1 margins side(0.15),0.97,0.13,0.98 spacing 0,0.09
unset xlabel
set ylabel "y" offset (narrow ? 1.5 : 0),0
set xrange [-1:1]
set yrange [-0.6:1.6]
set ytics 0.5
set key top center
plot "parabola.tsv" using 1:2 with lines @exact title "y = x²", \
     "" using 1:4 with lines @tangent title "tangents", "" using 1:5 with lines @tangent, \
     "" using 1:6 with lines @tangent, "parabola_dots.tsv" using 1:2 with points @dots
set xlabel "x"
set ylabel "slope" offset 0,0
set yrange [-2.2:2.2]
set ytics 1
set key top left reverse Left
plot "parabola.tsv" using 1:3 with lines @second title "slope 2x", \
     "parabola_dots.tsv" using 1:3 with points @dots title "central differences"
unset multiplot

call figure "exponential.svg" 560 660
set multiplot layout 2,1 margins side(0.15),0.97,0.13,0.98 spacing 0,0.09
set autoscale
set ytics autofreq
unset xlabel
set ylabel "growth"
set key top left reverse Left
plot "growth.tsv" using 1:2 with lines @first title "y = e^{1.5 x}", \
     "" using 1:3 with lines @second title "its slope, 1.5 y", \
     "growth_dots.tsv" using 1:2 with points @dots title "central differences"
set xlabel "x"
set ylabel "decay"
set key bottom right noreverse Right
plot "decay.tsv" using 1:2 with lines @first title "y = e^{−1.5 x}", \
     "" using 1:3 with lines @second title "its slope, −1.5 y", \
     "decay_dots.tsv" using 1:2 with points @dots title "central differences"
unset multiplot

call figure "sine.svg" 560 420 490
set xlabel "x (rad)"
set ylabel "y"
set xrange [0:2*pi]
set yrange [-1.1:2.1]
set xtics ("0" 0, "π/2" pi/2, "π" pi, "3π/2" 3*pi/2, "2π" 2*pi)
set ytics -1,0.5,1
set key top right
@key_below
plot "sine.tsv" using 1:2 with lines @first title "sin x", \
     "" using 1:3 with lines @second title "its slope, cos x", \
     "sine_dots.tsv" using 1:2 with points @dots title "central differences"

call figure "forward_backward.svg" 560 420 490
set xlabel "time t"
set ylabel "position x"
set xrange [-0.1:1.9]
set yrange [-0.1:1.65]
set xtics ("t_1 − h" 0.2, "t_1" 0.9, "t_1 + h" 1.6)
set ytics ("x_0" sin(0.2), "x_1" sin(0.9), "x_2" sin(1.6))
set key top left reverse Left
@key_below
plot "chords.tsv" using 1:2 with lines @exact title "x(t)", \
     "" using 1:3 with lines @tangent title "tangent at t_1", \
     "" using 1:4 with lines @forward_difference title "forward difference", \
     "" using 1:5 with lines @backward_difference title "backward difference", \
     "chord_dots.tsv" using 1:2 with points @dots

call figure "central.svg" 560 420 490
set yrange [-0.1:1.5]
set key top left reverse Left
@key_below
plot "chords.tsv" using 1:2 with lines @exact title "x(t)", \
     "" using 1:3 with lines @tangent title "tangent at t_1", \
     "" using 1:6 with lines @central_difference title "central difference", \
     "chord_dots.tsv" using 1:2 with points @dots

call figure "taylor.svg" 560 420
set xlabel "t (rad)"
set ylabel "x"
set xrange [-2*pi:2*pi]
set yrange [-2.2:2.2]
set xtics ("−2π" -2*pi, "−π" -pi, "0" 0, "π" pi, "2π" 2*pi)
set ytics 1
set key off
set label 1 "1" at 2.35,1.95 textcolor rgb '#0072b2'
set label 2 "3" at 3.35,-1.95 textcolor rgb '#d55e00'
set label 3 "5" at 4.25,1.95 textcolor rgb '#009e73'
set label 4 "7" at 4.6,-1.95 textcolor rgb '#b15a98'
set label 5 "9" at 5.7,1.95 textcolor rgb ink
plot "taylor.tsv" using 1:2 with lines @exact, "" using 1:3 with lines @first, \
     "" using 1:4 with lines @second, "" using 1:5 with lines @third, \
     "" using 1:6 with lines @fourth, "" using 1:7 with lines lc rgb ink lw 2.5 dt (2,4)
unset label

# What was measured.

call figure "v_shape.svg" 560 440 510
set logscale xy
set xlabel "step h"
set ylabel "largest error of the slope"
set xrange [1e-16:1]
set yrange [*:*]
set format xy "10^{%T}"
set xtics 1e-16,1e4,1
set ytics autofreq
set key bottom left reverse Left
set label 1 "rounding,\ngrows as 1/h" at graph 0.27,0.72 textcolor rgb ink
set label 2 "truncation,\nfalls with h" at graph 0.69,0.3 textcolor rgb ink
@key_below
plot "forward_float.tsv" using 1:2 with lines @second title "float", \
     "forward_double.tsv" using 1:2 with lines @first title "double", \
     "forward_float.tsv" using 1:3 with lines @faint title "predicted", \
     "forward_double.tsv" using 1:3 with lines @faint
unset label

call figure "orders.svg" 560 440 510
set xrange [1e-10:1]
set yrange [*:1e3]
set xtics 1e-10,1e2,1
set key top left reverse Left
@key_below
plot "forward_double.tsv" using 1:2 with lines @forward_difference title "forward, order 1", \
     "central_double.tsv" using 1:2 with lines @central_difference title "central, order 2", \
     "five_point_double.tsv" using 1:2 with lines @five_point title "five-point, order 4", \
     "forward_double.tsv" using 1:3 with lines @faint title "predicted", \
     "central_double.tsv" using 1:3 with lines @faint, \
     "five_point_double.tsv" using 1:3 with lines @faint

# Break it.

call figure "clock.svg" 560 420 500
set xlabel "hours of play"
set ylabel "largest error of the velocity (m/s)"
set autoscale
set xrange [0.1:250]
set yrange [0.004:12]
set format
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100)
set ytics ("0.01" 0.01, "0.1" 0.1, "1" 1)
set key top left reverse Left
set label 1 "the clock stops" at 130,0.03 right textcolor rgb ink
@key_below
plot "clock.tsv" using 1:2 with lines @second title "t a float, divided by h", \
     "" using 1:4 with lines @exact title "t a double", \
     "" using 1:3 with lines @first title "t a float, divided by the step taken", \
     "clock_stop.tsv" using 1:(0.004):(0):(1) with vectors nohead lc rgb ink lw 2
