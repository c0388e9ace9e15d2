# The capsule on the plane, the box with a motor, and the two films. figures.gp ends with
#   load folder."../../chapters/05_gyroscopic/study/films.gp"

# How fast it spins, without rolling resistance and with it.
call figure "plane_spin.svg" 640 800
reset_axes = "unset logscale; unset label; unset arrow; unset object; unset title; unset xlabel; unset ylabel; set autoscale; set xtics autofreq; set ytics autofreq; set format '%g'; set size noratio; set border 3; set grid lc rgb soft lt 1 lw 0.8"
@reset_axes
set multiplot layout 2,1 margins side(0.15),0.97,0.235,0.95 spacing 0.02,0.15
set xrange [0:20]
set yrange [0:160]
set ylabel "spin |ω| (rad/s)"
set title "no rolling resistance" offset 0,-0.6
unset xlabel
unset key
plot "plane_free_explicit.tsv" using 1:2 with lines @explicit_gyroscopic, \
     "plane_free_dropped.tsv" using 1:2 with lines @no_gyroscopic, \
     "plane_free_lagged_inertia.tsv" using 1:2 with lines @lagged_inertia, \
     "plane_free_implicit.tsv" using 1:2 with lines @implicit_gyroscopic, \
     "plane_free_passive.tsv" using 1:2 with lines @passive_gyroscopic
set title "with rolling resistance" offset 0,-0.6
set xlabel "time t (s)"
set key at screen 0.55,0.075 center horizontal maxrows 3 reverse Left width -4
if (narrow) { set key vertical maxrows 3 width -3 }
plot "plane_rolling_explicit.tsv" using 1:2 with lines @explicit_gyroscopic title "explicit", \
     "plane_rolling_dropped.tsv" using 1:2 with lines @no_gyroscopic title "dropped", \
     "plane_rolling_lagged_inertia.tsv" using 1:2 with lines @lagged_inertia title "lagged inertia", \
     "plane_rolling_implicit.tsv" using 1:2 with lines @implicit_gyroscopic title "one Newton step", \
     "plane_rolling_passive.tsv" using 1:2 with lines @passive_gyroscopic title "passive"
unset multiplot
unset title

# Many throws: what share of them still moves.
call figure "plane_throws.svg" 640 800
@reset_axes
set multiplot layout 2,1 margins side(0.15),0.97,0.235,0.95 spacing 0.02,0.15
set xrange [0:20]
set yrange [0:105]
set ylabel "still moving (%)"
set title "lever arms from the start of the step" offset 0,-0.6
unset xlabel
unset key
plot "throws_middle_fine.tsv" using 1:2 with lines @exact, \
     "throws_start_explicit.tsv" using 1:2 with lines @explicit_gyroscopic, \
     "throws_start_dropped.tsv" using 1:2 with lines @no_gyroscopic, \
     "throws_start_lagged_inertia.tsv" using 1:2 with lines @lagged_inertia, \
     "throws_start_implicit.tsv" using 1:2 with lines @implicit_gyroscopic, \
     "throws_start_passive.tsv" using 1:2 with lines @passive_gyroscopic
set title "lever arms from its middle" offset 0,-0.6
set xlabel "time t (s)"
set key at screen 0.55,0.075 center horizontal maxrows 3 reverse Left width -4
if (narrow) { set key vertical maxrows 3 width -3 }
plot "throws_middle_fine.tsv" using 1:2 with lines @exact title "short steps", \
     "throws_middle_explicit.tsv" using 1:2 with lines @explicit_gyroscopic title "explicit", \
     "throws_middle_dropped.tsv" using 1:2 with lines @no_gyroscopic title "dropped", \
     "throws_middle_lagged_inertia.tsv" using 1:2 with lines @lagged_inertia title "lagged inertia", \
     "throws_middle_implicit.tsv" using 1:2 with lines @implicit_gyroscopic title "one Newton step", \
     "throws_middle_passive.tsv" using 1:2 with lines @passive_gyroscopic title "passive"
unset multiplot
unset title

# A box with a motor: the error of its orientation against the step.
call figure "driven.svg" 640 520 580
@reset_axes
set logscale xy
set format xy "10^{%T}"
set xlabel "step h (s)\n " offset 0,0.4
set ylabel "error of the orientation (rad)"
set xrange [4e-4:2e-2]
set key outside bottom center horizontal reverse Left width 2
plot "driven_dropped.tsv" using 1:2 with lines @no_gyroscopic title "dropped", \
     "driven_explicit.tsv" using 1:2 with lines @explicit_gyroscopic title "explicit", \
     "driven_lagged_inertia.tsv" using 1:2 with lines @lagged_inertia title "lagged inertia", \
     "driven_implicit.tsv" using 1:2 with lines @implicit_gyroscopic title "one Newton step", \
     "driven_converged.tsv" using 1:2 with lines @converged_gyroscopic title "converged", \
     "driven_passive.tsv" using 1:2 with lines @passive_gyroscopic title "passive"
@reset_axes

# The films. The program has projected the polygons; the third column is the number of their paint. (Not `splot with
# polygons`, which in gnuplot 6.0.2 draws nothing.)
set palette maxcolors 18 defined ( \
    0 "#8a4300",  1 "#a85200",  2 "#c46800",  3 "#e08600",  4 "#f5a623", \
    5 "#00324f",  6 "#00466f",  7 "#005a8f",  8 "#0072b2",  9 "#3592cc", \
   10 "#7b7b7b", 11 "#929292", 12 "#ababab", 13 "#c4c4c4", 14 "#dedede", \
   15 "#b4babf", 16 "#c9ced3", 17 "#eef0f2")
set cbrange [-0.5:17.5]
unset colorbox
unset border
unset tics
unset xlabel
unset ylabel
unset key
unset grid
unset xzeroaxis
unset yzeroaxis

call animation "tumbling.gif" 640 250 7
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1
set xrange [-2.53:2.53]
set yrange [-1.08:0.897]
do for [i=0:149] {
    plot "tumbling.tsv" index i using 1:2:3 with filledcurves closed fs solid 1 noborder lc palette, \
          "tumbling_captions.tsv" every ::i+1::i+1 using (0):(0.79):(strcol(1)) with labels textcolor rgb ink, \
          "" every ::i+1::i+1 using (-1.89):(-0.84):("exact\n".strcol(2)) with labels textcolor rgb ink, \
          "" every ::i+1::i+1 using (-0.63):(-0.84):("dropped\n".strcol(3)) with labels textcolor rgb ink, \
          "" every ::i+1::i+1 using (0.63):(-0.84):("one Newton step\n".strcol(4)) with labels textcolor rgb ink, \
          "" every ::i+1::i+1 using (1.89):(-0.84):("passive\n".strcol(5)) with labels textcolor rgb ink
}

call animation "capsule.gif" 640 300 7
set xrange [-2.05:2.05]
set yrange [-0.62:1.3]
do for [i=0:149] {
    plot "capsule.tsv" index i using 1:2:3 with filledcurves closed fs solid 1 noborder lc palette, \
          "capsule_captions.tsv" every ::i+1::i+1 using (0):(1.2):(strcol(1)) with labels textcolor rgb ink, \
          "" every ::i+1::i+1 using (-1.35):(-0.4):("explicit\n".strcol(2)) with labels textcolor rgb ink, \
          "" every ::i+1::i+1 using (0):(-0.4):("dropped\n".strcol(3)) with labels textcolor rgb ink, \
          "" every ::i+1::i+1 using (1.35):(-0.4):("passive\n".strcol(4)) with labels textcolor rgb ink
}
