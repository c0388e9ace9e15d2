load style
set datafile separator whitespace

# The error of three differences, against the step.
call figure "slopes.svg" 640 480
set logscale xy
set format xy "10^{%T}"
set xlabel "step h (s)\n "
set ylabel "error of the slope (m/s)"
set key outside bottom center horizontal reverse Left
plot "slopes.dat" using 1:2 with linespoints lc rgb "#d55e00" lw 5 pt 7 ps 0.6 title "forward", \
     "" using 1:3 with linespoints @backward_difference pt 7 ps 0.5 title "backward", \
     "" using 1:4 with linespoints @central_difference pt 7 ps 0.6 title "central"
