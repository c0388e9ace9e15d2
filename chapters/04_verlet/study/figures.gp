load style

# The picture of the chapter: Verlet's positions lie on those of semi-implicit Euler.
call figure "overlay.svg" 640 440
set xlabel "time t (s)\n "
set ylabel "position x (m)"
set xrange [0:1.3]
set yrange [-1.25:1.25]
set key outside bottom center horizontal reverse Left
plot "overlay.tsv" using 1:2 with lines @exact title "exact", \
     "" using 1:3 with lines @semi_implicit_euler title "semi-implicit Euler", \
     "" every 2 using 1:4 with points pt 7 ps 0.55 lc rgb "#b15a98" title "Verlet, every other"

# How far rounding drives the two apart.
call figure "roundoff.svg" 640 440
set autoscale
set logscale xy
set format xy "10^{%T}"
set xlabel "step n\n " offset 0,0.4
set ylabel "largest difference so far (m)"
set key top left reverse Left
plot "roundoff.tsv" using 1:3 with lines @faint title "bound", \
     "" using 1:2 with lines @verlet title "measured"
unset logscale
set format xy "%g"

# The constant-force method on springs: growth a step.
call figure "constant_acceleration.svg" 640 440 520
set xlabel "ωh (rad)"
set ylabel "growth of the amplitude a step"
set xrange [0:6]
set yrange [0:16]
set key top left reverse Left
@key_below
plot 1 with lines @exact title "exact", \
     "constant_acceleration_line.tsv" using 1:3 with lines @faint title "√(1 + ω²h²/2)", \
     "" using 1:2 with lines lc rgb "#808000" lw 2.5 dt 1 title "constant acceleration, largest |λ|", \
     "constant_acceleration_points.tsv" using 1:2 with points pt 6 ps 0.9 lw 1.6 lc rgb "#808000" title "measured"

# The first demo: a ball.
call figure "balls.svg" 640 480 560
set size noratio
set xlabel "distance (m)\n "
set ylabel "height (m)"
set xrange [0:20]
set yrange [-1.6:9]
set key outside bottom center horizontal reverse Left
plot "ball_exact.tsv" using 2:3 with lines @exact title "exact", \
     "ball_explicit_euler.tsv" using 2:3 with lines @explicit_euler title "explicit", \
     "ball_implicit_euler.tsv" using 2:3 with lines @implicit_euler title "implicit", \
     "ball_semi_implicit_euler.tsv" using 2:3 with lines lc rgb "#009e73" lw 2.5 dt (2,4) title "semi-implicit", \
     "ball_constant_acceleration.tsv" using 2:3 with lines @constant_acceleration title "constant acceleration", \
     "ball_verlet.tsv" using 2:3 with points pt 7 ps 0.7 lc rgb "#b15a98" title "Verlet", \
     "ball_velocity_verlet.tsv" using 2:3 with points pt 6 ps 1.3 lw 1.4 lc rgb "#b15a98" title "velocity Verlet"

# The second demo: amplitude of the spring, every method.
call figure "springs.svg" 640 500 600
set autoscale
set logscale y
set format y "10^{%T}"
set xlabel "time t (s)\n "
set ylabel "amplitude (m)"
set xrange [0:15]
set yrange [1e-4:1e4]
set key outside bottom center horizontal reverse Left
plot 1 with lines @exact title "exact", \
     "amplitude_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit", \
     "amplitude_constant_acceleration.tsv" using 1:2 with lines @constant_acceleration title "constant acceleration", \
     "amplitude_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit", \
     "amplitude_velocity_verlet.tsv" using 1:2 with lines @velocity_verlet title "velocity Verlet", \
     "amplitude_verlet.tsv" every 12 using 1:2 with points lc rgb "#b15a98" pt 6 ps 0.9 lw 1.4 title "Verlet", \
     "amplitude_implicit_euler.tsv" using 1:2 with lines @implicit_euler title "implicit"
unset logscale
set format xy "%g"

# Both demos as a film, a step a frame.
call animation "demos.gif" 640 400 16
unset xlabel
unset ylabel
# The key, in words of the curves' colours.
set label 11 "exact" at screen 0.10,0.08 center textcolor rgb "#777777"
set label 12 "explicit" at screen 0.27,0.08 center textcolor rgb "#b34e00"
set label 13 "semi-implicit" at screen 0.48,0.08 center textcolor rgb "#007a59"
set label 14 "Verlet" at screen 0.70,0.08 center textcolor rgb "#8f4379"
set label 15 "const. accel." at screen 0.88,0.08 center textcolor rgb "#6b6b00"
inside(x, y) = sqrt(x**2 + y**2) < 2.35 ? x : NaN  # a curve ends where it would leave the frame
do for [i=0:23] {
    n = i + 2  # the file's line; the first holds names, and a curve has two points
    set multiplot
    set key off
    set lmargin at screen 0.08
    set rmargin at screen 0.52
    set tmargin at screen 0.86
    set bmargin at screen 0.24
    set size noratio
    set xrange [0:20]
    set yrange [-1.6:9]
    set xtics 5
    set ytics 2
    set title "a ball (m)" textcolor rgb ink
    plot "ball_exact.tsv" using 2:3 with lines @exact, \
         "ball_explicit_euler.tsv" every ::1::n using 2:3 with linespoints @explicit_euler pt 7 ps 0.8, \
         "ball_semi_implicit_euler.tsv" every ::1::n using 2:3 with linespoints @semi_implicit_euler pt 7 ps 0.8, \
         "ball_verlet.tsv" every ::1::n using 2:3 with linespoints @velocity_verlet pt 7 ps 0.8, \
         "ball_constant_acceleration.tsv" every ::1::n using 2:3 with points pt 6 ps 1.6 lc rgb "#808000"
    set lmargin at screen 0.6
    set rmargin at screen 0.98
    set xrange [-2.4:2.4]
    set yrange [-2.4:2.4]
    set xtics 1
    set ytics 1
    set title "a spring: x and v/ω (m)"
    plot "circle.tsv" using 1:2 with lines @exact, \
         "spring_explicit_euler.tsv" every ::1::n using (inside($2,$3)):3 with linespoints @explicit_euler pt 7 ps 0.8, \
         "spring_semi_implicit_euler.tsv" every ::1::n using 2:3 with linespoints @semi_implicit_euler pt 7 ps 0.8, \
         "spring_verlet.tsv" every ::1::n using 2:3 with linespoints @velocity_verlet pt 7 ps 0.8, \
         "spring_constant_acceleration.tsv" every ::1::n using (inside($2,$3)):3 with linespoints lc rgb "#808000" lw 2.5 dt 1 pt 6 ps 1.6
    unset multiplot
}
unset title
unset label
set lmargin; set rmargin; set tmargin; set bmargin
set xtics autofreq
set ytics autofreq

# The first step decides the order.
call figure "first_step.svg" 640 460 530
set autoscale
set logscale xy
set format xy "10^{%T}"
set xlabel "step h (s)"
set ylabel "error at the end (m)"
set key bottom right vertical reverse Left
@key_below
plot "start_euler.tsv" using 1:2 with lines lc rgb "#009e73" lw 5 dt 1 title "x + hv + h²a", \
     "start_careless.tsv" using 1:2 with lines @second title "x + hv", \
     "start_taylor.tsv" using 1:2 with lines @verlet title "x + hv + h²a/2"

# A step that changes.
call figure "changing_steps.svg" 640 560 620
set xlabel "mean step (s)\n " offset 0,0.4
set ylabel "error at the end (m)"
set key outside bottom center horizontal reverse Left
plot "turn_plain.tsv" using 1:2 with lines @second title "plain, in turn", \
     "chance_plain.tsv" using 1:2 with points pt 2 ps 0.8 lw 1.6 lc rgb "#d55e00" title "by chance", \
     "turn_scaled.tsv" using 1:2 with lines @third title "scaled, in turn", \
     "chance_scaled.tsv" using 1:2 with points pt 6 ps 0.8 lw 1.6 lc rgb "#007a59" title "by chance", \
     "turn_corrected.tsv" using 1:2 with lines @first title "corrected, in turn", \
     "chance_corrected.tsv" using 1:2 with points pt 7 ps 0.8 lc rgb "#0072b2" title "by chance", \
     "turn_velocity.tsv" using 1:2 with lines @velocity_verlet title "velocity Verlet"
unset logscale
set format xy "%g"

# The rope: three of them, let go from the level.
call figure "rope.svg" 640 640
set size ratio -1
set xlabel "x (m)\n " offset 0,0.4
set ylabel "y (m)"
set xrange [narrow ? -1.5 : -1.2:2.3]
set yrange [-3.4:0.3]
set key outside bottom center horizontal reverse Left
plot "rope_frames.tsv" index 0 using 2:3 with lines @faint title "at the start", \
     for [k in "6 9 12"] "" index int(k) using 2:3 with lines @second title (k eq "6" ? "1 iteration" : ""), \
     for [k in "6 9 12"] "" index int(k) using 4:5 with lines @third title (k eq "6" ? "4 iterations" : ""), \
     for [k in "6 9 12"] "" index int(k) using 6:7 with lines @first title (k eq "6" ? "32 iterations" : ""), \
     for [k in "6 9 12"] "" index int(k) every ::20::20 using 2:3:(sprintf("%.1f s", $1)) \
         with labels left offset 0.7,0 textcolor rgb ink, \
     for [k in "4 6"] "" index 12 every ::20::20 using int(k):int(k)+1:(sprintf("%.1f s", $1)) \
         with labels right offset -0.7,0 textcolor rgb ink

call animation "rope.gif" 480 480 7
set xrange [-2.4:2.4]
set yrange [-3.6:0.6]
set tics 1
set xlabel "x (m)\n " offset 0,0.4
set ylabel "y (m)"
set key outside bottom center horizontal reverse Left
do for [i=0:60] {
    plot "rope_frames.tsv" index i using 2:3 with lines lc rgb "#d55e00" lw 2.5 dt 1 title "1 iteration", \
         "" index i using 4:5 with lines lc rgb "#009e73" lw 2.5 dt 1 title "4 iterations", \
         "" index i using 6:7 with lines lc rgb "#0072b2" lw 2.5 dt 1 title "32 iterations"
}

set tics autofreq

# Stretch at rest.
call figure "stretch.svg" 640 480
set size noratio
set autoscale
set logscale xy
set format xy "%g"
set xlabel "iterations a step\n " offset 0,0.4
set ylabel "too long by (%)"
set xrange [0.9:80]
set key outside bottom center horizontal reverse Left
plot "stretch_60.tsv" using 1:2 with linespoints @second pt 7 ps 0.7 title "60 Hz", \
     "stretch_120.tsv" using 1:2 with linespoints @third pt 7 ps 0.7 title "120 Hz", \
     "stretch_240.tsv" using 1:2 with linespoints @fourth pt 7 ps 0.7 title "240 Hz", \
     "stretch_480.tsv" using 1:2 with linespoints @first pt 7 ps 0.7 title "480 Hz", \
     "stretch_budget.tsv" using 1:2 with points pt 6 ps 1.8 lw 2 lc rgb ink title "480 iterations a second"
unset logscale

# The stiffness against the frame rate: PBD, and XPBD with a compliance.
call figure "compliance.svg" 640 420
set size noratio
set autoscale
set logscale xy
set format xy "%g"
set xlabel "steps a second (Hz)\n " offset 0,0.4
set ylabel "too long by (%)"
set xrange [25:600]
set xtics (30,60,120,240,480)
set key outside bottom center horizontal reverse Left
plot "compliance.tsv" using 1:2 with linespoints @second pt 7 ps 0.7 title "PBD, 8 iterations", \
     "" using 1:3 with linespoints @third pt 7 ps 0.7 title "XPBD, 8 iterations", \
     "" using 1:4 with linespoints @first pt 7 ps 0.7 title "XPBD, 200 iterations"
unset logscale
set xtics autofreq

# What the links do to the energy.
call figure "rope_energy.svg" 640 440
set autoscale
set xlabel "time t (s)\n "
set ylabel "energy / energy at the start"
set xrange [0:20]
set key outside bottom center horizontal reverse Left
plot 1 with lines @exact title "exact", \
     "rope_energy_fast.tsv" using 1:2 with lines @first title "480 Hz, 4 iterations", \
     "rope_energy_32.tsv" using 1:2 with lines @third title "60 Hz, 32 iterations", \
     "rope_energy_4.tsv" using 1:2 with lines @second title "60 Hz, 4 iterations"

# In float: shorter steps, and worse.
call figure "floats.svg" 640 440 510
set autoscale
set logscale xy
set format xy "10^{%T}"
set xlabel "step h (s)\n " offset 0,0.4
set ylabel "error after 2 s (m)"
set key top right vertical reverse Left
@key_below
plot "floats.tsv" using 1:2 with lines @verlet title "Verlet", \
     "" using 1:3 with lines @velocity_verlet title "velocity Verlet"

# Accuracy against force evaluations.
call figure "work.svg" 640 500 560
set autoscale
set xlabel "force evaluations in 20 s\n " offset 0,0.4
set ylabel "error at the end (m)"
set yrange [1e-10:2]
set xrange [20:1e5]
set key outside bottom center horizontal reverse Left
plot "work_semi_implicit_euler.tsv" using 1:2 with lines @semi_implicit_euler title "semi-implicit", \
     "work_constant_acceleration.tsv" using 1:2 with lines @constant_acceleration title "constant acceleration", \
     "work_velocity_verlet.tsv" using 1:2 with lines @velocity_verlet title "velocity Verlet", \
     "work_verlet.tsv" using 1:2 with lines @verlet title "Verlet", \
     "work_runge_kutta_4.tsv" using 1:2 with lines @runge_kutta_4 title "RK4"
