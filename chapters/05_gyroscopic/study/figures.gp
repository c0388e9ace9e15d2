load style

# How large the torque is, all round.
call figure "torque.svg" 640 400 470
set xlabel "ω turned from the shortest side".(narrow ? "\n" : " ")."towards the longest by (°)"
set ylabel "gyroscopic torque (N m)"
set xrange [0:180]
set yrange [-2:48]
set xtics 30
set key top right
@key_below
plot "torque.tsv" using 1:2 with lines @first title "box 1 x 2 x 3 m", \
     "" using 1:3 with lines @second title "cube"

# The orientation's error.
call figure "orientation.svg" 640 440 560
set autoscale
set xtics autofreq
set logscale xy
set format xy "10^{%T}"
set xlabel "step h (s)"
set ylabel "orientation after a second, off by (rad)"
set xrange [2e-4:2e-2]
set key bottom right reverse Left
@key_below
plot "orientation.tsv" using 1:2 with linespoints @explicit_gyroscopic pt 7 ps 0.6 title "explicit", \
     "" using 1:3 with linespoints @implicit_gyroscopic pt 7 ps 0.6 title "one Newton step", \
     "" using 1:4 with linespoints @passive_gyroscopic pt 7 ps 0.6 title "passive"

# Between two orientations.
call figure "between.svg" 640 420
set autoscale
set logscale xy
set format x "%g"
set format y "10^{%T}"
set xlabel "turn from one step to the next (°)\n " offset 0,0.4
set ylabel "off by at most (°)"
set xrange [2:200]
set xtics (2.5,5,10,20,45,90,180)
set key outside bottom center vertical reverse Left
plot "between.tsv" using 1:3 with linespoints @second pt 7 ps 0.6 title "slerp, a tumbling box", \
     "" using 1:2 with linespoints @first pt 7 ps 0.6 title "nlerp, a constant spin"
set xtics autofreq
unset logscale

# Newton-Raphson closes in.
call figure "newton.svg" 640 440
unset logscale
set logscale y
set format x "%g"
set xlabel "iterations of Newton–Raphson"
set ylabel "residual over |Iω|"
set xrange [-0.2:4.2]
set yrange [1e-18:10]
set xtics 1
set key top right
plot "newton.tsv" using 1:4 with linespoints @second pt 7 ps 0.8 title "h|ω| = 1", \
     "" using 1:3 with linespoints @third pt 7 ps 0.8 title "0.5", \
     "" using 1:2 with linespoints @first pt 7 ps 0.8 title "0.1"

# A capsule in free flight: its energy, and how far its angular momentum turns.
call figure "capsule.svg" 640 760
unset logscale
set multiplot layout 2,1 margins side(0.14),0.97,0.235,0.97 spacing 0,0.06
set xrange [0:4]
set xtics 1 format ""
unset xlabel
set logscale y
set yrange [0.3:300]
set ytics ("0.5" 0.5, "1" 1, "10" 10, "100" 100)
set ylabel "energy / energy at the start" offset 0.5,0
unset key
plot 1 with lines @exact, \
     "capsule_explicit.tsv" using 1:2 with lines @explicit_gyroscopic, \
     "capsule_dropped.tsv" using 1:2 with lines @no_gyroscopic, \
     "capsule_lagged_inertia.tsv" using 1:2 with lines @lagged_inertia, \
     "capsule_implicit.tsv" using 1:2 with lines @implicit_gyroscopic, \
     "capsule_passive.tsv" using 1:2 with lines @passive_gyroscopic
unset logscale
set format y "%g"
set yrange [-3:99]
set ytics 30
set xtics 1 format "%g"
set xlabel "time t (s)"
set ylabel "L turned by (°)" offset 0.5,0
set key at screen 0.55,0.075 center vertical maxrows 3 reverse Left width 1
if (narrow) { set key vertical maxrows 3 width -3 }
plot 0 with lines @exact title "exact", \
     "capsule_explicit.tsv" using 1:4 with lines @explicit_gyroscopic title "explicit", \
     "capsule_dropped.tsv" using 1:4 with lines @no_gyroscopic title "dropped", \
     "capsule_lagged_inertia.tsv" using 1:4 with lines @lagged_inertia title "lagged inertia", \
     "capsule_implicit.tsv" using 1:4 with lines @implicit_gyroscopic title "one Newton step", \
     "capsule_passive.tsv" using 1:4 with lines @passive_gyroscopic title "passive"
unset multiplot

# The staff's tip.
call figure "staff.svg" 640 440
set autoscale
set format xy "%g"
set xlabel "time t (s)\n "
set ylabel "height of the tip (m)"
set xrange [0:4]
set yrange [-1.05:1.1]
set xtics 1
set ytics 0.5
set key outside bottom center horizontal reverse Left width (narrow ? -1 : 0)
plot "staff_exact.tsv" using 1:4 with lines @exact title "exact", \
     "staff_dropped.tsv" using 1:4 with lines @no_gyroscopic title "dropped", \
     "staff_passive.tsv" using 1:4 with lines @passive_gyroscopic title "passive"

# About the middle axis: the three components of ω in the body.
call figure "tumble.svg" 640 900
set multiplot layout 5,1 margins side(0.12),0.97,0.09,0.94 spacing 0,0.035
set xrange [0:12]
set yrange [-15:15]
set ytics 10
set xtics 2 format ""
unset xlabel
set ylabel "ω (rad/s)" offset 1.5,0
set key at screen 0.99,0.995 right horizontal maxrows 1 reverse Left samplen 2 width -3 font ",15"
do for [name in "exact explicit dropped implicit passive"] {
    set label 1 (name eq "implicit" ? "one Newton step" : name) at graph 0.01,0.085 left front textcolor rgb ink
    if (name eq "passive") {
        set xtics 2 format "%g"
        set xlabel "time t (s)"
    }
    thin = name eq "exact" ? 4 : name eq "passive" ? 1 : 2  # more points than a screen shows
    plot "tumble_".name.".tsv" every thin using 1:2 with lines lc rgb "#d55e00" lw 2 title "about x", \
         "" every thin using 1:3 with lines lc rgb "#0072b2" lw 2 title "y (intermediate)", \
         "" every thin using 1:4 with lines lc rgb "#009e73" lw 2 dt (6,3) title "z"
    unset key
}
unset multiplot
unset label

# Its energy and its momentum.
call figure "tumble_energy.svg" 640 700
set multiplot layout 2,1 margins side(0.15),0.97,0.27,0.97 spacing 0,0.05
set xrange [0:12]
set xtics 2 format ""
unset xlabel
set yrange [0.5:2.1]
set ytics 0.5
set ylabel "energy / at the start"
unset key
plot 1 with lines @exact, \
     "tumble_explicit.tsv" every 2 using 1:5 with lines @explicit_gyroscopic, \
     "tumble_dropped.tsv" every 2 using 1:5 with lines @no_gyroscopic, \
     "tumble_lagged_inertia.tsv" every 2 using 1:5 with lines @lagged_inertia, \
     "tumble_implicit.tsv" every 2 using 1:5 with lines @implicit_gyroscopic, \
     "tumble_converged.tsv" every 2 using 1:5 with lines @converged_gyroscopic, \
     "tumble_passive.tsv" every 2 using 1:5 with lines @passive_gyroscopic
set xtics 2 format "%g"
set xlabel "time t (s)"
set ylabel "momentum / at the start"
set yrange [0.7:1.5]
set ytics 0.2
set key at screen 0.55,0.075 center horizontal maxrows 3 reverse Left width -4
if (narrow) { set key vertical maxrows 4 width -3 }
plot 1 with lines @exact title "exact", \
     "tumble_explicit.tsv" every 2 using 1:6 with lines @explicit_gyroscopic title "explicit", \
     "tumble_dropped.tsv" every 2 using 1:6 with lines @no_gyroscopic title "dropped", \
     "tumble_lagged_inertia.tsv" every 2 using 1:6 with lines @lagged_inertia title "lagged inertia", \
     "tumble_implicit.tsv" every 2 using 1:6 with lines @implicit_gyroscopic title "one Newton step", \
     "tumble_converged.tsv" every 2 using 1:6 with lines @converged_gyroscopic title "converged", \
     "tumble_passive.tsv" every 2 using 1:6 with lines @passive_gyroscopic title "passive"
unset multiplot

# The worst of many random bodies.
call figure "gains.svg" 640 480
set autoscale
set xtics autofreq format "%g"
set ytics autofreq
set logscale xy
set format y "10^{%T}"
set xlabel "h|ω| (rad)\n "
set lmargin 10
set ylabel "largest E_2/E_1 of a step" offset -1.5,0
set format x "%g"
set xrange [0.1:10]
set yrange [0.1:1e9]
set key outside bottom center horizontal reverse Left
plot 1 with lines @exact title "no gain", \
     "gain_curve.tsv" using 1:3 with lines @implicit_gyroscopic title "one Newton step", \
     "" using 1:4 with lines @converged_gyroscopic title "converged", \
     "" using 1:5 with lines @passive_gyroscopic title "passive"

# Where one iteration adds energy. A step without gain is white.
unset lmargin
call figure "map.svg" 640 520
unset logscale
set autoscale
set view map
set xrange [-1.545:1.21]
set yrange [-0.105:6.146]
set xtics ("0.03" -1.523, "0.1" -1, "0.3" -0.523, "1" 0, "3" 0.477, "10" 1)
set ytics ("1" 0, "10" 1, "100" 2, "1000" 3, "10^4" 4, "10^5" 5, "10^6" 6)
set xlabel "h|ω| (rad)"
set ylabel "largest moment over smallest" offset (narrow ? 0.5 : 0),0
set cblabel "worst gain found, E_2/E_1" offset 1.5,0
set cbrange [0:8]
set cbtics ("1" 0, "10" 1, "100" 2, "1000" 3, "10^4" 4, "10^5" 5, "10^6" 6, "10^7" 7, "10^8" 8)
set palette defined (0 "#ffffff", 0.02 "#fbe3b5", 1 "#f0b040", 3 "#d55e00", 5.5 "#8a2f00", 8 "#2a0c00")
set border 15
unset grid
set rmargin 12
set lmargin at screen 0.19
if (narrow) { set lmargin at screen 0.22; set rmargin at screen 0.74; set xtics ("0.1" -1, "1" 0, "10" 1) }
plot "energy_map.tsv" skip 1 using (log10($1)):(log10($2)):($3 > 1.000001 ? log10($3) : 0) with image notitle, \
     "map_edge.tsv" skip 1 using (log10($1)):(log10($2)) with lines lc rgb "#0072b2" lw 2 dt (6,4) notitle
unset rmargin
unset lmargin
set border 3

load folder."../../chapters/05_gyroscopic/study/films.gp"
