load style
set datafile separator whitespace

# A ball in air and a mass on a spring, frame by frame.
call figure "motion.svg" 640 560 600
bottom = narrow ? 0.21 : 0.2
set multiplot layout 2,1 margins side(0.15),0.97,bottom,0.97 spacing 0,0.05
set autoscale xfix
set xtics format ""
set ylabel "height of the ball (m)" offset 0.8
plot "motion.dat" using 1:2 with points pt 7 ps 0.5 lc rgb "#d55e00"
set xtics format "%g"
set xlabel "time t (s)" offset 0,0.4
set ylabel "mass on the spring (m)" offset 0.8
set key at screen 0.56,0.005 center bottom horizontal reverse Left samplen 2
plot "motion.dat" using 1:4 with lines @exact title "exact", \
     "" using 1:3 with points pt 7 ps 0.5 lc rgb "#d55e00" title "explicit Euler"
unset multiplot
