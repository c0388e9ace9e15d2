load style

# Orders: the orientation.
call figure "orders.svg" 640 600 720
set autoscale
set logscale xy
set format xy "10^{%T}"
set xtics autofreq
set ytics autofreq
set xlabel "step h (s)"
set ylabel "orientation after two seconds, off by (rad)"
set xrange [1.2e-3:0.2]
set yrange [1e-11:1]
set key below horizontal maxcols 3 reverse Left samplen 2 title " "
# Cayley lies on the half-step Jacobian, which is drawn broad below it.
broad_half_step = colour_of(half_step_jacobian)." lw 6"
of(id) = sprintf("strcol(1) eq '%s' ? $4 : NaN", id)
curve(id, style, words) = sprintf("'order_points.tsv' using 2:(%s) with linespoints pt 7 ps 0.5 %s title '%s'", of(id), style, words)
eval "plot ".curve("implicit", implicit_gyroscopic, "one Newton step").", ".curve("passive", passive_gyroscopic, "passive").", ". \
    curve("half_step_new", colour_of(half_step_jacobian)." lw 2.5 dt (3,4)", "half-step, new ω").", ". \
    curve("half_step_back", colour_of(half_step_jacobian)." lw 2.5 dt (9,5)", "…, half a step back").", ". \
    curve("half_step", broad_half_step, "half-step, mean ω").", ". \
    curve("cayley", cayley_gyroscopic, "Cayley").", ".curve("strang", strang_splitting, "Strang").", ". \
    curve("remainder_2", ball_and_remainder_2, "ball + rem. 2").", ". \
    curve("runge_kutta_4", runge_kutta_4, "RK4").", ".curve("remainder_4", ball_and_remainder_4, "ball + rem. 4")

# Where the half-step Jacobian fails.
broad_passive = colour_of(passive_gyroscopic)." lw 11"
less_broad_cayley = colour_of(cayley_gyroscopic)." lw 6.5"
call figure "fails.svg" 640 560 640
unset logscale
set logscale x
set format xy "%g"
set xlabel "h|ω| (rad)"
set ylabel "bodies that gain half or more (%)" offset 0.8
set xrange [0.3:32]
set xtics (0.3, 1, 2, 3, 10, 30)
set yrange [-1.5:50]
set ytics 10
set key below horizontal maxcols 3 reverse Left samplen 2 title " "
# What lies on the zero line is drawn broad to narrow, so that each is seen beside the next.
plot "fails.tsv" using 1:(100*$5) with lines @broad_passive title "passive", \
     "" using 1:(100*$4) with lines @less_broad_cayley title "Cayley", \
     "" using 1:(100*$6) with lines @calm_half_step title "calm half-step", \
     "" using 1:(100*$3) with lines @half_step_jacobian title "half-step Jacobian", \
     "" using 1:(100*$2) with lines @implicit_gyroscopic title "one Newton step", \
     "" using 1:(100*$7) with lines @strang_splitting title "Strang", \
     "" using 1:(100*$8) with lines @ball_and_remainder_2 title "ball + remainder 2", \
     "" using 1:(100*$9) with lines @ball_and_remainder_4 title "ball + remainder 4"

# A minute of the box: how far energy and |L| have been off so far.
call figure "minute.svg" 860 560 720
unset logscale
set logscale y
right = narrow ? 0.97 : 0.7
low = narrow ? 0.29 : 0.17
set multiplot layout 2,1 margins (narrow ? 0.2 : 0.13),right,low,0.97 spacing 0,0.06
set xrange [0:60]
set xtics 10 format ""
unset xlabel
unset key
set yrange [1e-17:2]
set format y "10^{%T}"
set ytics 1e-16,1e4,1
set mytics 1
set ylabel "energy off by, at most" offset (narrow ? 2 : 0.5)
each = "implicit passive half_step cayley strang remainder_2 remainder_4 runge_kutta_4"
styles = "implicit_gyroscopic passive_gyroscopic half_step_jacobian cayley_gyroscopic strang_splitting ball_and_remainder_2 ball_and_remainder_4 runge_kutta_4"
name_of(k) = k == 1 ? "one Newton step" : k == 2 ? "passive" : k == 3 ? "half-step Jacobian" : k == 4 ? "Cayley" : \
    k == 5 ? "Strang" : k == 6 ? "ball + remainder 2" : k == 7 ? "ball + remainder 4" : "RK4"
curves(column) = (text = "", sum [k = 1:8] (text = text.sprintf("%s'minute_%s.tsv' using 1:%d with lines %s title '%s'", \
    k == 1 ? "" : ", ", word(each, k), column, value(word(styles, k)), name_of(k)), 0), text)
eval "plot ".curves(2)
set xtics 10 format "%g"
set xlabel "time t (s)"
set ylabel "|L| off by, at most" offset (narrow ? 2 : 0.5)
set key at screen 0.72,0.78 left vertical reverse Left samplen 2
if (narrow) { set key at screen 0.5,0.09 center vertical maxrows 4 width -3 }
eval "plot ".curves(3)
unset multiplot

load folder."../../chapters/08_beyond_the_talk/study/engines.gp"

# Error against time: three bodies, three spins.
bodies = "near box needle"
paces = "slow game fast"
top_at(error) = error > 2 ? 2 : error  # the most that it can be; a run that is no number has 9
high = narrow ? 0.24 : 0.265
top(j) = 0.96 - high*(j - 1)
wide = narrow ? 0.26 : 0.295
begin = narrow ? 0.19 : 0.115
set logscale xy
set xrange [0.3:600]
set yrange [1e-12:4]
set xtics ("1" 1, "10" 10, "100" 100)
set ytics ("1" 1, "10^{-2}" 0.01, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12)
head(body) = body eq "near" ? (narrow ? "near-symmetric" : "nearly symmetric") : body eq "box" ? "box 1:2:3" : "needle"
spin(pace) = pace eq "slow" ? "1 rad/s" : pace eq "game" ? "10 rad/s" : "100 rad/s"

# First those of a game's spin, large, one below the other.
call figure "work_game.svg" 760 1060 1060
set multiplot
do for [i = 1:3] {
    set lmargin at screen (narrow ? 0.19 : 0.13); set rmargin at screen 0.97
    set tmargin at screen 0.965 - 0.28*(i - 1); set bmargin at screen 0.965 - 0.28*i + 0.075
    set title head(word(bodies, i)).", 10 rad/s" textcolor rgb ink offset 0,-0.5
    set ylabel (i == 2 ? "orientation off by (rad)" : "") offset 1.7
    set xlabel (i == 3 ? "µs a second of the motion" : "") offset 0,0.3
    if (i == 3) { set key at screen 0.5,0.05 center center vertical maxrows 3 width -2 reverse Left samplen 2.5 } else { unset key }
    if (i == 3 && narrow) { set key vertical maxrows 4 width -3 }
    set label 2 "1 %" at 550,0.01 right offset 0,0.5 textcolor rgb "#666666"
    set label 3 "lost" at 550,0.5 right offset 0,0.5 textcolor rgb "#666666"
    all = "0.01 with lines ".faint." notitle, 0.5 with lines ".faint." notitle"
    name = sprintf("work_%s_game.tsv", word(bodies, i))
    do for [k = 1:8] {
        style = word(each, k) eq "half_step" ? broad_half_step : value(word(styles, k))
        mine = sprintf("strcol(1) eq '%s'", word(each, k))
        all = all.sprintf(", name using (%s ? $5 : NaN):(top_at($4)) with lines %s title '%s'", mine, style, name_of(k))
        all = all.sprintf(", name using (%s && $3 == 60 ? $5 : NaN):(top_at($4)) with points pt 7 ps 0.6 %s notitle", mine, colour_of(style))
    }
    eval "plot ".all
    unset label
}
unset multiplot

call figure "work.svg" 940 940 1000
set multiplot
do for [j = 1:3] { do for [i = 1:3] {
    name = sprintf("work_%s_%s.tsv", word(bodies, i), word(paces, j))
    set lmargin at screen begin + wide*(i - 1)
    set rmargin at screen begin + wide*i - 0.025
    set tmargin at screen top(j)
    set bmargin at screen top(j) - high + 0.025
    set title (j == 1 ? head(word(bodies, i)) : "") textcolor rgb ink offset 0,-0.5
    set format y (i == 1 ? "%g" : "")
    set ylabel (i == 1 ? "orientation off by (rad)" : "") offset (narrow ? 1.9 : 0.5)
    if (i == 3) { set label 1 spin(word(paces, j)) at graph 1.05,0.5 center rotate by -90 textcolor rgb ink }
    set xlabel (j == 3 && (i == 2 || !narrow) ? "µs a second of the motion" : "") offset 0,0.3
    if (i > 1) { set ytics ("" 1, "" 0.01, "" 1e-4, "" 1e-6, "" 1e-8, "" 1e-10, "" 1e-12) } \
    else { set ytics ("1" 1, "10^{-2}" 0.01, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12) }
    if (j < 3) { set xtics ("" 1, "" 10, "" 100) } else { set xtics ("1" 1, "10" 10, "100" 100) }
    unset key
    all = "0.01 with lines ".faint." notitle, 0.5 with lines ".faint." notitle, ". \
        "name using ($2 == 0 ? $5 : NaN):(top_at($4)) with lines lc rgb '#b8b8b8' lw 1.5 notitle"
    if (i == 1 && j == 1) { set label 2 "1 %" at 550,0.01 right offset 0,0.5 textcolor rgb "#666666"
                            set label 3 "lost" at 550,0.5 right offset 0,0.5 textcolor rgb "#666666" }
    do for [k = 1:8] {
        style = word(each, k) eq "half_step" ? broad_half_step : value(word(styles, k))
        mine = sprintf("strcol(1) eq '%s'", word(each, k))
        all = all.sprintf(", name using (%s ? $5 : NaN):(top_at($4)) with lines %s", mine, style)
        all = all.sprintf(", name using (%s && $3 == 60 ? $5 : NaN):(top_at($4)) with points pt 7 ps 0.6 %s notitle", mine, colour_of(style))
    }
    eval "plot ".all
    unset label
} }
# The key has a row of its own.
set lmargin at screen 0.02; set rmargin at screen 0.98; set tmargin at screen (narrow ? 0.16 : 0.095); set bmargin at screen 0
unset border; unset tics; unset grid; unset xlabel; unset ylabel; unset title
set key center center horizontal maxcols (narrow ? 2 : 5) reverse Left samplen 2.5
if (narrow) { set key vertical maxrows 5 width -5 }
keys = ""
do for [k = 1:8] { keys = keys.sprintf("NaN with lines %s title '%s', ", \
    word(each, k) eq "half_step" ? broad_half_step : value(word(styles, k)), name_of(k)) }
eval "plot ".keys."NaN with lines lc rgb '#b8b8b8' lw 1.5 title 'the appendix'"
unset multiplot

load folder."../../chapters/08_beyond_the_talk/study/many.gp"
