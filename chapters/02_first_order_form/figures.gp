load style
set datafile separator whitespace

# A ball in air and a mass on a spring, frame by frame.
call figure "motion.svg" 640 560
set multiplot layout 2,1 margins 0.12,0.97,0.17,0.97 spacing 0,0.05
set xrange [0:3]
set xtics format ""
set ylabel "height of the ball (m)"
plot "motion.dat" using 1:2 with points pt 7 ps 0.5 lc rgb "#d55e00"
set xtics format "%g"
set xlabel "time t (s)"
set ylabel "the mass on the spring (m)"
plot "motion.dat" using 1:3 with points pt 7 ps 0.5 lc rgb "#d55e00", \
     cos(3*x) with lines @exact title "exact"
unset multiplot
