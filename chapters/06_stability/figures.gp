load style
set datafile separator whitespace

# The map: below its line a method is stable on a damped spring.
call figure "boundary.svg" 640 640
set logscale xy
set autoscale xfix
set format xy "%g"
set xlabel "damping ratio ζ\n " offset 0,0.4
set ylabel "longest stable ωh (rad)"
set key outside bottom center vertical maxrows 3 reverse Left width (narrow ? -3 : 0)
set label 1 "no limit: implicit Euler,\nimplicit midpoint, BDF2" at graph 0.06,0.95 left textcolor rgb ink
plot "longest.dat" index 0 using 1:3 with lines @explicit_euler title "explicit Euler", \
     "" index 1 using 1:3 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "" index 2 using 1:3 with lines @new_damping title "new damping", \
     "" index 3 using 1:3 with lines @midpoint title "midpoint", \
     "" index 4 using 1:3 with lines @runge_kutta_4 title "RK4", \
     for [i=0:4] "" index i every 4 using 1:2 with points pt 6 ps 0.8 lc rgb ink
