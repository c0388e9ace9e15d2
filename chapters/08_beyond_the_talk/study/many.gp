# The cost of one among many, with the machine's caches.
call figure "many.svg" 760 840 900
reset_axes = "unset multiplot; unset logscale; unset title; set autoscale; set border 3; set key default"
reset_tics = "set xtics; set ytics; set tics nomirror out scale 0.6 textcolor rgb ink"
reset_margins = "unset lmargin; unset rmargin; unset tmargin; unset bmargin"
@reset_axes
@reset_tics
@reset_margins
set grid lc rgb soft lt 1 lw 0.8
set multiplot layout 2,1 margins (narrow ? 0.19 : 0.13),0.93,0.1,(narrow ? 0.86 : 0.88) spacing 0,(narrow ? 0.22 : 0.19)
set logscale xy
set format xy "%g"
set xrange [99:1.01e6]
set xtics ("100" 100, "1000" 1000, "10 000" 10000, "100 000" 100000, "1 000 000" 1000000)
if (narrow) { set xtics ("100" 100, "1000" 1000, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6) }
set ylabel "ns a step of one" offset 1,0
unset xlabel
set key at graph 0.5,1.02 center bottom horizontal maxcols 4 noautotitle reverse Left samplen 2
if (narrow) { set key vertical maxrows 2 width -1 }
small = narrow ? ",14" : ""
above = narrow ? 2.7 : 1.3  # a title, above the key
set title "springs, semi-implicit Euler" offset 0,above textcolor rgb ink
set yrange [0.05:20]
set ytics (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)
plot "many_caches.tsv" using 2:(20) with impulses @faint notitle, \
     "" using 2:(13):1 with labels left offset 0.4,0 font small textcolor rgb "#666666" notitle, \
     "many_springs.tsv" using 1:2 with linespoints @second pt 7 ps 0.5 title "one by one", \
     "" using 1:3 with linespoints @first pt 7 ps 0.5 title "lanes", \
     "" using 1:4 with linespoints @third pt 7 ps 0.5 title "lanes, 32 a pass"
set title "boxes, half-step Jacobian and orientation" offset 0,above
set xlabel "how many there are"
set yrange [1:2000]
set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
plot "many_caches.tsv" using 3:(2000) with impulses @faint notitle, \
     "" using 3:(1200):1 with labels left offset 0.4,0 font small textcolor rgb "#666666" notitle, \
     "many_bodies.tsv" using 1:2 with linespoints @second pt 7 ps 0.5 title "one by one", \
     "" using 1:3 with linespoints @first pt 7 ps 0.5 title "lanes", \
     "" using 1:5 with linespoints @third pt 7 ps 0.5 title columnheader(5), \
     "" using 1:4 with linespoints @fourth pt 7 ps 0.5 title "balls, lanes"
@reset_axes
