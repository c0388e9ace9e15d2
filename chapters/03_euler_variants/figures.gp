load style
set datafile separator whitespace

# One spring in the phase portrait.
call figure "portraits.svg" 640 600
set size ratio -1
set xlabel "position x (m)\n " offset 0,0.4
set ylabel "velocity v / ω (m)"
set xrange [-4.2:5.2]
set yrange [-4.5:4.5]
set trange [0:2*pi]
set parametric
set label 1 "start" at 1.15,0.2 textcolor rgb ink front
set key outside bottom center horizontal Left reverse
plot cos(t), sin(t) with lines @exact title "exact", \
     "portraits.dat" index 0 with lines @explicit_euler title "explicit", \
     "" index 1 with lines @implicit_euler title "implicit", \
     "" index 2 with lines @semi_implicit_euler title "semi-implicit", \
     "" index 0 every ::0::0 with points pt 7 ps 0.8 lc rgb ink
