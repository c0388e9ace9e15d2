load style

call figure "portraits.svg" 640 560
set size ratio -1
set xlabel "position x (m)"
set ylabel "velocity / ω (m)"
set key top left
plot "implicit_euler.tsv" using 2:3 with lines @implicit_euler title "implicit", \
     "explicit_euler.tsv" using 2:3 with lines @explicit_euler title "explicit", \
     "semi_implicit_euler.tsv" using 2:3 with lines @semi_implicit_euler title "semi-implicit"
