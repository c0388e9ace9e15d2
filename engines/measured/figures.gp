# Inside engines: a tumbling box after a minute; and what the place of a rule in the step does to a top on a joint
# and to capsules on a plane.
load style
box3d = "lc rgb '#0072b2' lw 2.5 pt 7 ps 0.6"
bullet = "lc rgb '#56b4e9' lw 2.5 pt 5 ps 0.6"
ode = "lc rgb '#009e73' lw 2.5 pt 9 ps 0.8"
jolt = "lc rgb '#999933' lw 2.5 pt 13 ps 0.8"

call figure "in_engines.svg" 640 960
set multiplot layout 3,1 margins side(0.16),0.96,0.13,0.96 spacing 0,0.11
set label 1 "a box alone for a minute" at graph 0.5,1.06 center textcolor rgb ink
set logscale x
set xrange [2.5:36]
set xtics (3, 10, 30)
set yrange [0:1.15]
set ytics 0.2
set xlabel "spin (rad/s)" offset 0,0.5
set ylabel "energy left / first" offset 0.5,0
set label 2 "full: as it is\ndotted, at one:".(narrow ? "\n" : " ")."half and half" at first 34,0.74 right textcolor rgb ink
plot "energies.tsv" using 1:2 with linespoints @box3d dt 1, \
     "" using 1:4 with linespoints @bullet dt 1, \
     "" using 1:6 with linespoints @ode dt 1, \
     "" using 1:8 with linespoints @jolt dt 1, \
     "" using 1:3 with lines lc rgb '#0072b2' lw 2.5 dt (3,9), \
     "" using 1:5 with lines lc rgb '#56b4e9' lw 2.5 dt (2,10), \
     "" using 1:7 with lines lc rgb '#009e73' lw 2.5 dt (2,8), \
     "" using 1:9 with lines lc rgb '#999933' lw 2.5 dt (2,6)
unset label 2
unset logscale x
unset xlabel
set xrange [-0.3:3.3]
set xtics ("as it is" 0, "all before" 1, "half and half" 2, "all after" 3)
set logscale y
set label 1 "a top on a joint, 20 rad/s: its precession"
set yrange [1:2000]
set ytics (1, 10, 100, 1000)
set ylabel "off by (%)" offset 2,0
# A top that hangs below its joint: a cross at the upper edge.
fell(column) = strcol(column) eq "fell over" ? 1300 : NaN
stood(column) = strcol(column) eq "fell over" ? NaN : column(column)
set label 2 "× fell over" at first 1,300 center textcolor rgb ink
plot "top_places.tsv" using 1:(stood(2)) with linespoints @box3d dt 1, \
     "" using 1:(stood(3)) with linespoints @bullet dt 1, \
     "" using 1:(stood(4)) with linespoints @ode dt 1, \
     "" using 1:(stood(5)) with linespoints @jolt dt 1, \
     "" using ($1 - 0.06):(fell(3)) with points lc rgb '#56b4e9' pt 2 ps 1, \
     "" using 1:(fell(4)) with points lc rgb '#009e73' pt 2 ps 1, \
     "" using ($1 + 0.06):(fell(5)) with points lc rgb '#999933' pt 2 ps 1
unset label 2
set label 1 "a hundred capsules thrown onto a plane".(narrow ? "" : " at 30 rad/s")
set yrange [0.9:12]
set ytics (1, 2, 5, 10)
set ylabel "most energy / first" offset 0.5,0
set key at screen 0.55,0.055 center top horizontal maxrows 1 width -1 reverse Left samplen 2
plot "throw_places.tsv" using 1:2 with linespoints @box3d dt 1 title "Box3D", \
     "" using 1:3 with linespoints @bullet dt 1 title "Bullet", \
     "" using 1:4 with linespoints @ode dt 1 title "ODE", \
     "" using 1:5 with linespoints @jolt dt 1 title "Jolt"
unset multiplot
