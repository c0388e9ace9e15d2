load style
set datafile separator whitespace

# The talk's solver and its one token: energy, and ω about the middle axis.
call figure "one_token.svg" 640 600
set multiplot layout 2,1 margins side(0.16),0.97,0.15,0.97 spacing 0,0.06
set autoscale xfix
set xtics format ""
set ylabel "energy / that at the start" offset 0.8
set key bottom left reverse Left samplen 2
if (narrow) { set key samplen 1; set yrange [0.5:*] }  # room for the key
plot "one_token.dat" index 0 using 1:(1) with lines @exact title "exact", \
     "" index 0 using 1:2 with lines @implicit_gyroscopic title "one Newton step", \
     "" index 1 using 1:2 with lines @half_step_jacobian title "half-step Jacobian"
set autoscale y
set xtics format "%g"
set xlabel "time t (s)"
set ylabel "ω, intermediate axis (rad/s)" offset 0.8
unset key
plot "one_token.dat" index 0 using 1:4 with lines @exact, \
     "" index 0 using 1:3 with lines @implicit_gyroscopic, \
     "" index 1 using 1:3 with lines @half_step_jacobian
unset multiplot
