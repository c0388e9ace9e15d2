load style
set datafile separator whitespace

# The three components of ω in the body's axes.
call figure "box.svg" 640 480
set xlabel "time t (s)\n "
set ylabel "ω in the axes of the box (rad/s)"
set autoscale xfix
set key outside bottom center horizontal reverse Left
plot "tumble.dat" using 1:2 with lines lc rgb "#d55e00" lw 2 title "x, largest moment", \
     "" using 1:3 with lines lc rgb "#0072b2" lw 2.5 title "y, intermediate", \
     "" using 1:4 with lines lc rgb "#009e73" lw 2 dt (6,4) title "z, least", \
     "" using 1:5 with lines lc rgb "#0072b2" lw 1.5 dt (2,4) title "y, torque dropped"
