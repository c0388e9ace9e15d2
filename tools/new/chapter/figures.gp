load style
set datafile separator whitespace

# FILL IN: the picture of what the program writes. about.json names it.
call figure "fall.svg" 560 400
set xlabel "time t (s)"
set ylabel "height x (m)"
set key bottom left reverse Left
plot "fall.dat" using 1:3 with lines @exact title "exact", \
     "" using 1:2 with linespoints @explicit_euler pt 7 ps 0.6 title "explicit Euler"
