load style
set datafile separator whitespace

# Error against time, a line a method; circles are 60 Hz.
call figure "four_methods.svg" 640 520
set logscale xy
set format xy "10^{%T}"
set xlabel "time of the run (µs)\n "
set ylabel "largest error (m)"
set key outside bottom center horizontal reverse Left
plot "work.dat" index 0 with linespoints @explicit_euler pt 7 ps 0.4 title "explicit Euler", \
     "" index 1 with linespoints @semi_implicit_euler pt 7 ps 0.4 title "semi-implicit Euler", \
     "" index 2 with linespoints @velocity_verlet pt 7 ps 0.4 title "velocity Verlet", \
     "" index 3 with linespoints @runge_kutta_4 pt 7 ps 0.4 title "RK4", \
     for [i=0:3] "" index i using 1:2:($3 == 60 ? 1.6 : 0) with points pt 6 ps variable lw 1.5 lc rgb ink
