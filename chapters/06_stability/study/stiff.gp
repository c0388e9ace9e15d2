# Stiff scenes.
stiff_clear = "unset logscale; unset label; unset arrow; unset object; unset title; unset xlabel; unset ylabel; set autoscale; set tics nomirror out scale 0.6 textcolor rgb ink; set xtics nomirror autofreq; set ytics nomirror autofreq; set format '%g'; set size noratio; set border 3; set grid lc rgb soft lt 1 lw 0.8"

rough = "lc rgb '#e69f00' lw 2.5 dt (4,4)"

# The cloth, hung by two corners.
call figure "cloth.svg" 640 480
@stiff_clear
set size ratio -1
unset border
unset tics
unset grid
unset xzeroaxis
unset yzeroaxis
set xrange [-0.08:1.5]
set yrange [-1.08:0.1]
unset key
set label 1 "after 0.4 s" at 1.2,-0.12 left textcolor rgb "#0072b2"
set label 2 "after 5 s" at 1.08,-0.92 left textcolor rgb ink
plot "cloth_24.tsv" using 1:2 with lines lc rgb "#56b4e9" lw 1.2, \
     "cloth_300.tsv" using 1:2 with lines lc rgb ink lw 1, \
     "+" using (0):(0) every ::0::0 with points pt 7 ps 1 lc rgb "#d55e00", \
     "+" using (1):(0) every ::0::0 with points pt 7 ps 1 lc rgb "#d55e00"
set border 3 lc rgb ink lw 1
set xzeroaxis lc rgb soft lt 1
set yzeroaxis lc rgb soft lt 1

# What a frame of it costs.
call figure "cloth_cost.svg" 640 800
@stiff_clear
set multiplot layout 2,1 margins side(0.14),0.97,0.235,0.98 spacing 0,0.11
set logscale xy
set xrange [7.5:42]
set xtics (8, 12, 16, 24, 32, 40)
set xlabel "masses along an edge, at 10^{4} N/m" offset 0,0.3
set ylabel "ms a frame" offset 1.5,0
unset key
plot "cloth_sizes.tsv" using 1:2 with linespoints @semi_implicit_euler pt 7 ps 0.6, \
     "" using 1:3 with linespoints @implicit_euler pt 5 ps 0.6, \
     "" using 1:4 with linespoints @fourth pt 9 ps 0.7, \
     "" using 1:5 with linespoints @rough pt 11 ps 0.7
set xrange [80:1.25e6]
set xtics ("10^2" 1e2, "10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6)
set xlabel "stiffness of the springs (N/m), 24 × 24 masses" offset 0,0.3
set key at screen 0.5,0.075 center horizontal maxcols 2 reverse Left width -2
plot "cloth_stiffness.tsv" using 1:2 with linespoints @semi_implicit_euler pt 7 ps 0.6 title "explicit, many steps", \
     "" using 1:3 with linespoints @implicit_euler pt 5 ps 0.6 title "factorised", \
     "" using 1:4 with linespoints @fourth pt 9 ps 0.7 title "gradients, 10^{−6}", \
     "" using 1:5 with linespoints @rough pt 11 ps 0.7 title "gradients, 10^{−2}"
unset multiplot
@stiff_clear

# What becomes of stiff springs and hard dampers: a row for each method.
call figure "fates.svg" 640 900
@stiff_clear
set multiplot layout 2,1 margins side(0.3),0.97,0.17,0.99 spacing 0,0.09
set logscale x
set yrange [0.4:12.6]
set ytics ("BDF2" 1, "implicit Euler" 2, "implicit midpoint" 3, "velocity Verlet" 4, "Verlet" 5, "with new damping" 6, "semi-implicit" 7, "RK4" 8, "Heun" 9, "midpoint" 10, "constant accel." 11, "explicit" 12)
unset grid
unset key
set xrange [0.7:1.4e8]
set xtics ("1" 1, "100" 1e2, "10^4" 1e4, "10^6" 1e6, "10^8" 1e8)
set xlabel "ω of an undamped spring (rad/s)" offset 0,0.3
lives = "with points pt 7 ps 0.7 lc rgb '#009e73'"
fades = "with points pt 9 ps 0.7 lc rgb '#0072b2'"
rings = "with points pt 4 ps 0.8 lw 1.5 lc rgb '#b15a98'"
bursts = "with points pt 2 ps 0.7 lw 1.5 lc rgb '#d55e00'"
plot "spring_fates.tsv" using 1:($3 == 0 ? $2 : NaN) @lives, \
     "" using 1:($3 == 1 ? $2 : NaN) @fades, \
     "" using 1:($3 == 3 ? $2 : NaN) @bursts
set xrange [0.007:1.4e6]
set xtics ("0.01" 1e-2, "1" 1, "100" 1e2, "10^4" 1e4, "10^6" 1e6)
set xlabel "damping ratio ζ".(narrow ? ", ω = 10 rad/s" : " of a spring with ω = 10 rad/s") offset 0,0.3
set label 1 "do not take a damper" at 0.01,4.5 left textcolor rgb "#666666"
set key at screen 0.55,0.045 center vertical maxrows 2 reverse Left
plot "damper_fates.tsv" using 1:($3 == 0 ? $2 : NaN) @lives title "swings on", \
     "" using 1:($3 == 1 ? $2 : NaN) @fades title "dies away", \
     "" using 1:($3 == 3 ? $2 : NaN) @bursts title "blows up", \
     "" using 1:($3 == 2 ? $2 : NaN) @rings title "rings"
unset multiplot

# A slow motion with a fast pull: error against step.
call figure "prothero.svg" 640 680
@stiff_clear
set logscale xy
set format y "10^{%T}"
set xrange [5.5e-3:0.17]
set yrange [1e-13:5e-2]
set xtics ("1/160" 1.0/160, "1/80" 1.0/80, "1/40" 1.0/40, "1/20" 1.0/20, "1/10" 1.0/10)
set xlabel "step h (s)\n " offset 0,0.4
set ylabel "error after 1 s" offset 0.5,0
set key outside bottom center horizontal reverse Left width -1 maxcols 2
set label 1 "slope 1" at 0.1,8e-13 left offset 0.5,0 textcolor rgb "#666666"
set label 2 "2" at 0.1,3.2e-12 left offset 0.5,0 textcolor rgb "#666666"
set label 3 "3" at 0.1,1.28e-11 left offset 0.5,0 textcolor rgb "#666666"
do for [p = 1:3] { set arrow p from 0.025,2e-13 to 0.1,2e-13*4**p nohead lc rgb "#8a8a8a" lw 1.5 }
plot "prothero.tsv" using 1:5 with linespoints @implicit_midpoint pt 4 ps 0.7 title "implicit midpoint, uneven", \
     "" using 1:4 with linespoints @implicit_midpoint pt 7 ps 0.6 title "implicit midpoint", \
     "" using 1:6 with linespoints @sdirk_3 pt 9 ps 0.7 title "SDIRK, order 3", \
     "" using 1:7 with linespoints lc rgb "#882255" lw 1.5 dt (3,4) pt 9 ps 0.5 title "the same, λ = −1", \
     "" using 1:2 with linespoints @implicit_euler pt 5 ps 0.6 title "implicit Euler", \
     "" using 1:3 with linespoints @bdf2 pt 11 ps 0.7 title "BDF2"

# Van der Pol's jumps.
call figure "van_der_pol.svg" 640 420
@stiff_clear
set xrange [0:2]
set yrange [-2.3:2.3]
set xlabel "time t (s)\n " offset 0,0.4
set ylabel "x"
set key outside bottom center horizontal reverse Left
plot "van_der_pol_adaptive.tsv" using 1:2 with lines @exact title "implicit Euler, adaptive", \
     "van_der_pol_fixed.tsv" using 1:2 with lines @implicit_euler title "implicit Euler, h = 1 ms"
@stiff_clear
