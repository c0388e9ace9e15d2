load style
set datafile separator whitespace

# The rope at each time that is written; the time stands where its last link points to, a line from the time before.
stats "rope.dat" using 1:2 nooutput
ropes = STATS_blocks
far = (narrow ? 0.11 : 0.08) * (STATS_max_x - STATS_min_x + STATS_max_y - STATS_min_y)
set xrange [STATS_min_x - 2*far : STATS_max_x + 2*far]
set yrange [STATS_min_y - 1.5*far : STATS_max_y + far]
stats "rope.dat" index 0 using 1:2 nooutput
end = STATS_records - 1
x0 = y0 = x1 = y1 = 0
xt = yt = 1e9
line = 0.6*far
clear(x, y) = abs(x - xt) < 2*far && abs(y - yt) < line ? yt + (y > yt ? line : -line) : y
time_y(x, y) = (yt = clear(x, y), xt = x, yt)
last_link(x, y) = (x0 = x1, y0 = y1, x1 = x, y1 = y, far / sqrt((x1 - x0)**2 + (y1 - y0)**2))

call figure "falling_rope.svg" 640 480 400
set size ratio -1
set xlabel "x (m)"
set ylabel "y (m)"
unset key
plot for [i=0:ropes-1] "rope.dat" index i using 1:2 with linespoints lc rgb "#b15a98" lw (1 + 2.5*i/ropes) pt 7 ps 0.25, \
     for [i=0:ropes-1] "" index i every ::end-1::end \
         using (k = last_link($1, $2), $0 == 0 ? NaN : x1 + k*(x1 - x0)): \
               ($0 == 0 ? NaN : time_y(x1 + k*(x1 - x0), y1 + k*(y1 - y0))):(sprintf("%.2f s", $3)) \
         with labels textcolor rgb ink
