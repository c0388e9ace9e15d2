load style
key = "reverse Left samplen ".(narrow ? "1.5 width -1" : "2.5")

# The question: one landing, stepped by the frame and stepped by a fixed step.
call figure "frame_rates.svg" 640 700
set multiplot
set xrange [0:3]
set yrange [-0.1:2.25]
set ytics 0.5
set ylabel "height of the hip (m)" offset 1,0
set key top left maxrows 2 @key
set lmargin at screen side(0.15)
set rmargin at screen 0.97
set tmargin at screen 0.945
set bmargin at screen 0.585
set title "the frame's time as the step" offset 0,-0.5
plot "frames_exact.tsv" using 1:2 with lines @exact title "exact", \
     "variable_144.tsv" using 1:2 with lines @first title "144 frames/s", \
     "variable_60.tsv" using 1:2 with lines @third title "60 frames/s", \
     "variable_30.tsv" using 1:2 with lines @second title "30 frames/s"
set tmargin at screen 0.465
set bmargin at screen 0.115
set title "a fixed step"
set xlabel "time (s)" offset 0,0.4
plot "frames_exact.tsv" using 1:2 with lines @exact title "exact", \
     "fixed_144.tsv" using 1:2 with lines @first title "144 frames/s", \
     "fixed_60.tsv" every 6 using 1:2 with points @third pt 7 ps 0.55 title "60 frames/s", \
     "fixed_30.tsv" every 3::2 using 1:2 with points @second pt 6 ps 1.2 title "30 frames/s"
unset multiplot
unset title
set ylabel offset 0,0
unset tmargin
unset bmargin
unset lmargin
unset rmargin
set ytics autofreq

# N11: rates that are constant, that depend on time, and that depend on x.
call figure "solutions.svg" 640 440 510
set xlabel "time t (s)" offset 0,0.3
set ylabel "x"
set xrange [0:4]
set yrange [-1.3:3.7]
set ytics 1
set key top left maxrows 2 @key
@key_below
plot "solution_line.tsv" using 1:2 with lines @first title "ẋ = 1/2", \
     "solution_integral.tsv" using 1:2 with lines @second title "ẋ = cos t", \
     "solution_decay.tsv" using 1:2 with lines @third title "ẋ = −x", \
     "solution_growth.tsv" using 1:2 with lines @fourth title "ẋ = x/2", \
     "solved_line.tsv" using 1:2 with points @first pt 7 ps 0.7, \
     "solved_integral.tsv" using 1:2 with points @second pt 7 ps 0.7, \
     "solved_decay.tsv" using 1:2 with points @third pt 7 ps 0.7, \
     "solved_growth.tsv" using 1:2 with points @fourth pt 7 ps 0.7

# N12: a parabola; the velocity changes upwards only.
call figure "projectile.svg" 640 360 430
set size ratio -1
set xlabel "distance (m)" offset 0,0.3
set ylabel "height (m)"
set xrange [-2:102]
set yrange [-10:34]
set ytics 10
set key top left maxrows 1 @key
@key_below
plot "projectile.tsv" using 2:3 with lines lc rgb "#8a8a8a" lw 3 title "path", \
     "projectile_velocity.tsv" using 2:3:($4*0.38):(0) with vectors @first head filled size 1.6,20,60 \
         title "ẋ", \
     "" using 2:3:(0):($5*0.38) with vectors lc rgb "#d55e00" lw 2.5 dt 1 head filled size 1.6,20,60 title "ẏ", \
     "" using 2:3 with points pt 7 ps 0.7 lc rgb ink
set size noratio
set ytics autofreq

# N14: velocity runs a quarter of a swing ahead.
call figure "oscillation.svg" 640 400 470
set autoscale
stats "oscillation.tsv" using 1 nooutput
swing = STATS_max/2
set xlabel "time (s)" offset 0,0.3
set ylabel "x and v / ω (m)"
set xrange [0:2*swing]
set yrange [-0.3:0.45]
set key top right maxrows 1 @key
set arrow 1 from 0.75*swing,0.285 to swing,0.285 heads size graph 0.012,25 lc rgb ink lw 1.5
set label 1 "a quarter of a period" at 0.875*swing,0.325 center textcolor rgb ink
@key_below
plot "oscillation.tsv" using 1:2 with lines @first title "position x", \
     "" using 1:3 with lines @second title "velocity v / ω"
unset arrow
unset label

# N15: the same as a portrait.
call figure "portrait.svg" 560 540
set size ratio -1
set xlabel "position x (m)" offset 0,0.3
set ylabel "velocity v / ω (m)"
set xrange [-0.33:0.33]
set yrange [-0.33:0.33]
set tics 0.1
unset key
plot "portrait.tsv" using 2:3 with lines @first, \
     "portrait_arrows.tsv" using ($1-$3/2):($2-$4/2):3:4 with vectors head filled size 0.024,22,90 @first, \
     "portrait.tsv" every ::1::1 using 2:3 with points pt 7 ps 1.6 lc rgb "#009e73", \
     "" every ::1::1 using 2:3:("start") with labels offset -3.4,0 textcolor rgb ink

# N15: graphs and portrait side by side, a swing long. The strip shows the last one and a half swings.
# Both share the vertical axis: the state stands as high in the portrait as v / ω in the strip.
strip = 'set lmargin at screen 0.14; set rmargin at screen 0.49; unset ylabel; set format y "%g"; \
         set xlabel "time (periods)" offset 0,0.5'
plane = 'set lmargin at screen 0.59; set rmargin at screen 0.98; set ylabel "v / ω (m)" offset 0.7,0; set format y ""; \
         set xlabel "x (m)" offset 0,0.5; set xrange [-0.31:0.31]; set xtics 0.2'
set size noratio
set yrange [-0.31:0.31]
set ytics 0.2
set bmargin at screen 0.2
set tmargin at screen 0.85
call animation "portrait_film.gif" 560 340 4
set label 1 "x (m)" at screen 0.2,0.93 center textcolor rgb "#0072b2"
set label 2 "v / ω (m)" at screen 0.38,0.93 center textcolor rgb "#d55e00"
set label 3 "the state" at screen 0.79,0.93 center textcolor rgb "#007a59"
do for [i=0:59] {
    now = i/60.0
    row = 91 + i
    set multiplot
    @strip
    set xrange [-1.5:0.07]
    set xtics ("−1" -1, "now" 0)
    plot "portrait_film.tsv" using ($1 > now - 1.5 && $1 <= now + 1e-9 ? $1 - now : 1/0):2 with lines @first, \
         "" using ($1 > now - 1.5 && $1 <= now + 1e-9 ? $1 - now : 1/0):3 with lines @second, \
         "" every ::row::row using (0):2 with points pt 7 ps 2.4 lw 0.3 lc rgb "#0072b2", \
         "" every ::row::row using (0):3 with points pt 7 ps 2.4 lw 0.3 lc rgb "#d55e00"
    @plane
    plot "portrait.tsv" every 4::1 using 2:3 with lines lc rgb "#8a8a8a" lw 2, \
         "portrait_film.tsv" every ::row::row using (0):3:2:(0) with vectors nohead lc rgb "#0072b2" lw 2.5, \
         "" every ::row::row using 2:(0):(0):3 with vectors nohead lc rgb "#d55e00" lw 2.5, \
         "" every ::row::row using 2:3 with points pt 7 ps 2.8 lw 0.3 lc rgb "#009e73"
    unset multiplot
}
unset label
unset lmargin
unset rmargin
unset tmargin
unset bmargin
set tics autofreq
set format y "%g"
set ylabel offset 0,0

# N17: a family of damping ratios.
call figure "damping.svg" 640 460 530
set autoscale
stats "zeta_0.tsv" using 1 nooutput
set xlabel "time (s)" offset 0,0.3
set ylabel "position x (m)"
set xrange [0:STATS_max]
set yrange [-0.27:0.4]
set key top right maxrows 2 @key
@key_below
plot "zeta_0.tsv" using 1:2 with lines lc rgb "#8a8a8a" lw 2 title "ζ = 0", \
     "zeta_0.1.tsv" using 1:2 with lines @fourth title "0.1", \
     "zeta_0.3.tsv" using 1:2 with lines @third title "0.3", \
     "zeta_0.7.tsv" using 1:2 with lines lc rgb "#56b4e9" lw 3.5 title "0.7", \
     "zeta_1.tsv" using 1:2 with lines @first title "1", \
     "zeta_3.tsv" using 1:2 with lines @second title "3"

# N17: the portrait becomes a spiral.
call figure "spiral.svg" 560 540
set size ratio -1
set xlabel "position x (m)" offset 0,0.3
set ylabel "velocity v / ω (m)"
set xrange [-0.33:0.33]
set yrange [-0.33:0.33]
set tics 0.1
unset key
plot "spiral.tsv" using 2:3 with lines @first, \
     "spiral_arrows.tsv" using ($1-$3/2):($2-$4/2):3:4 with vectors head filled size 0.024,22,90 @first, \
     "spiral.tsv" every ::1::1 using 2:3 with points pt 7 ps 1.6 lc rgb "#009e73", \
     "" every ::1::1 using 2:3:("start") with labels offset 3.2,0 textcolor rgb ink

# N17: kicked, ringing down, kicked again. The strip shows the last five swings.
set size noratio
set yrange [-0.31:0.31]
set ytics 0.2
set bmargin at screen 0.2
set tmargin at screen 0.85
call animation "damping_film.gif" 560 340 5
set label 1 "x (m)" at screen 0.2,0.93 center textcolor rgb "#0072b2"
set label 2 "v / ω (m)" at screen 0.38,0.93 center textcolor rgb "#d55e00"
set label 3 "the state" at screen 0.79,0.93 center textcolor rgb "#007a59"
do for [i=0:79] {
    now = i/16.0
    row = 241 + 3*i
    set multiplot
    @strip
    set xrange [-5:0.23]
    set xtics ("−4" -4, "−2" -2, "now" 0)
    plot "damping_film.tsv" using ($1 >= now - 5 && $1 <= now + 1e-9 ? $1 - now : 1/0):2 with lines @first, \
         "" using ($1 >= now - 5 && $1 <= now + 1e-9 ? $1 - now : 1/0):3 with lines @second, \
         "" every ::row::row using (0):2 with points pt 7 ps 2.4 lw 0.3 lc rgb "#0072b2", \
         "" every ::row::row using (0):3 with points pt 7 ps 2.4 lw 0.3 lc rgb "#d55e00"
    @plane
    plot "damping_film.tsv" using 2:3 with lines lc rgb "#cccccc" lw 1.5, \
         "" using ($1 >= now - 1 && $1 <= now + 1e-9 ? $2 : 1/0):3 with lines lc rgb "#666666" lw 2.5, \
         "" every ::row::row using (0):3:2:(0) with vectors nohead lc rgb "#0072b2" lw 2.5, \
         "" every ::row::row using 2:(0):(0):3 with vectors nohead lc rgb "#d55e00" lw 2.5, \
         "" every ::row::row using 2:3 with points pt 7 ps 2.8 lw 0.3 lc rgb "#009e73"
    unset multiplot
}
unset label
unset lmargin
unset rmargin
unset tmargin
unset bmargin
set tics autofreq
set format y "%g"
set ylabel offset 0,0

# N17, erratum: overdamped, and yet across zero.
call figure "crossing.svg" 640 400 470
set autoscale
stats "thrown_0.tsv" using 1 nooutput
set xlabel "time (s)" offset 0,0.3
set ylabel "position x (m)"
set xrange [0:STATS_max]
set yrange [-0.13:0.3]
set key top right vertical maxrows 3 @key
@key_below
plot "thrown_0.tsv" using 1:2 with lines @first title "let go at rest", \
     "thrown_0.8.tsv" using 1:2 with lines @third title "thrown at 0.8 q x_0", \
     "thrown_2.tsv" using 1:2 with lines @second title "thrown at 2 q x_0"

# N17: the textbook's formula near critical damping.
call figure "near_critical.svg" 640 420 490
set logscale xy
set format xy "10^{%T}"
set xlabel "ζ − 1" offset 0,0.3
set ylabel "relative error of x"
set xrange [1e-15:0.1]
set yrange [1e-17:1e-7]
set key top right @key
@key_below
plot "near_critical.tsv" using 1:($2 > 0 ? $2 : 1/0) with points @second pt 6 ps 0.7 title "textbook formula", \
     "" using 1:($3 > 0 ? $3 : 1/0) with points @first pt 7 ps 0.6 title "exact()"
unset logscale
set format xy "%g"

# N16: two bodies that act on each other.
call figure "coupled.svg" 640 520
set autoscale
stats "coupled.tsv" using 1 nooutput
set multiplot
set xrange [0:STATS_max]
set yrange [-0.3:0.3]
set ytics 0.2
unset key
set lmargin at screen side(0.15)
set rmargin at screen 0.97
set tmargin at screen 0.98
set bmargin at screen 0.59
set ylabel "first body x (m)" offset 1.5,0
set format x ""
unset xlabel
plot "coupled.tsv" using 1:2 with lines lc rgb "#8a8a8a" lw 2, \
     "coupled_dots.tsv" using 1:2 with points @first pt 7 ps 0.6
set tmargin at screen 0.54
set bmargin at screen 0.15
set ylabel "second body x (m)" offset 1.5,0
set format x "%g"
set xlabel "time (s)" offset 0,0.3
plot "coupled.tsv" using 1:3 with lines lc rgb "#8a8a8a" lw 2, \
     "coupled_dots.tsv" using 1:3 with points @second pt 7 ps 0.6
unset multiplot
unset lmargin
unset rmargin
unset tmargin
unset bmargin
set ytics autofreq
set ylabel offset 0,0

# I03: with air and without.
call figure "drag.svg" 640 360 430
set size ratio -1
set xlabel "distance (m)" offset 0,0.3
set ylabel "height (m)"
set lmargin at screen side(0.15)
set rmargin at screen 0.96
set xrange [0:100]
set yrange [0:42]
set ytics 10
set key top right vertical maxrows 3 @key
@key_below
plot "path_vacuum.tsv" every 8 using 1:2 with lines @faint title "no air", \
     "path_drag.tsv" every 8 using 1:2 with lines @exact title "drag", \
     "path_euler.tsv" using 1:2 with linespoints @explicit_euler pt 7 ps 0.5 title "explicit Euler, 10 Hz"
set size noratio
unset lmargin
unset rmargin
set ytics autofreq

# I03: a tether in space.
call figure "orbit.svg" 640 600
large = narrow ? 1.1 : 1.2
set view 65, 30, large, large
set view equal xy
set xyplane at -1.6
set xrange [-2:2]
set yrange [-2:2]
set zrange [-1.6:1.6]
set tics 1
set ztics 1
unset xlabel
unset ylabel
set label 1 "x (m)" at -0.4,-2.9,-1.6 center
set label 2 "y (m)" at 2.9,0.2,-1.6 center
set label 3 "z (m)" at -2,-2,1.9 center
set border 31
set key at screen 0.97,0.97 right vertical maxrows 3 @key
splot "orbit_tether.tsv" using 1:2:(-1.6) with lines lc rgb "#a0a0a0" lw 1.2, \
      "orbit_tether.tsv" using 1:2:3 with lines lc rgb "#0072b2" lw 2 title "tether, 1 m long at rest", \
      "orbit_spring.tsv" using 1:2:3 with lines @second title "spring without rest length"
set border 3
unset label
set tics autofreq

# I02: what is owed and what is paid.
call figure "accumulator.svg" 640 460
set autoscale
stats "accumulator.tsv" using 1 nooutput
set xlabel "player’s clock (ms)" offset 0,0.3
set ylabel "simulation’s clock (ms)"
set xrange [0:STATS_max]
set yrange [0:STATS_max*1.1]
set key top left @key
plot x with lines lc rgb "#8a8a8a" lw 1.5 dt (4,4) title "player’s clock", \
     "accumulator.tsv" using 1:2 with steps @first title "last step taken", \
     "" using 1:3 with points pt 7 ps 0.8 lc rgb "#d55e00" title "state that is drawn"

# Break it: frames that take turns.
call figure "taking_turns.svg" 640 420 480
set logscale y
set format y "10^{%T}"
set xlabel "time (s)" offset 0,0.3
set ylabel "amplitude / amplitude at the start"
set xrange [0:1]
set yrange [0.3:1e6]
set key top left @key
@key_below
plot "taking_turns.tsv" using 1:4 with linespoints @second pt 7 ps 0.7 title "60 and 30 frames/s in turn", \
     "" using 1:3 with linespoints @third pt 7 ps 0.7 title "always 30", \
     "" using 1:2 with linespoints @first pt 7 ps 0.7 title "always 60"

# Break it: the spiral of death.
call figure "spiral_of_death.svg" 640 420 490
set format y "%g"
set xlabel "frame" offset 0,0.3
set ylabel "time of the frame (ms)"
set xrange [0:31]
set yrange [10:10000]
set key top left @key
@key_below
plot "spiral_of_death.tsv" using 1:2 with linespoints @second pt 7 ps 0.7 title "no cap", \
     "" using 1:3 with linespoints @first pt 7 ps 0.7 title "at most five steps a frame"

# Break it: the same program, other bits.
call figure "other_bits.svg" 640 420
set logscale y
set format y "10^{%T}"
set xlabel "time (s)" offset 0,0.3
set ylabel "distance between two builds (m)"
set xrange [0:15]
set yrange [1e-17:1000]
set key top left @key
@key_below
above_0(d) = d > 0 ? d : NaN  # the axis is logarithmic
plot "other_bits.tsv" using 1:(above_0($2)) with lines @second title "among pegs", \
     "" using 1:(above_0($3)) with lines @first title "on a spring"
