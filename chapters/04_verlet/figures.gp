load style
set datafile separator whitespace

# The rope, every quarter of a second.
call figure "falling_rope.svg" 640 480
set size ratio -1
set xlabel "x (m)"
set ylabel "y (m)"
set xrange [-2.15:2.25]
set yrange [-2.4:0.2]
unset key
plot for [i=0:6] "rope.dat" index i with linespoints lc rgb "#b15a98" lw (1 + 0.35*i) pt 7 ps 0.25, \
     for [i=0:6] "" index i every ::20::20 using 1:2:(sprintf("%.2f s", i*0.25)) with labels offset 0,-0.9 textcolor rgb ink
