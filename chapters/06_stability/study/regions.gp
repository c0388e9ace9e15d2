# The definitions' plane: where each method is stable, and the runs laid over it.
call figure "regions.svg" 640 1000 780
shade = "fs transparent solid 0.22 noborder"
outlined(id) = "outline_".id.".tsv"
unset grid
unset xlabel
unset ylabel
unset key
set border 3
set size ratio -1
set xrange [-4.1:4.1]
set yrange [-3.6:3.6]
set xtics 2
set ytics 2
set multiplot layout 3,2 margins side(0.135),0.98,(narrow ? 0.11 : 0.09),0.965 spacing 0.06,(narrow ? 0.09 : 0.075)
# Crosses are letters: a point's lines are hair-thin in SVG.
runs(id) = sprintf("'decayed_%s.tsv' using 1:2 with points pt 7 ps 0.42 lc rgb ink, 'grew_%s.tsv' using 1:2:(\"×\") with labels font \":Bold,15\" textcolor rgb '#a31a0a'", id, id)

set ylabel "imaginary part of hλ" offset 1,0; set format y "%g"
set title "explicit Euler" offset 0,-0.7
outside = runs("explicit_euler")
plot "outline_explicit_euler.tsv" using 1:2 with filledcurves closed fc rgb "#d55e00" @shade, \
     "" using 1:2 with lines @explicit_euler, @outside
unset ylabel; set format y ""
set title "implicit Euler"
outside = runs("implicit_euler")
set object 1 rectangle from graph 0,0 to graph 1,1 fc rgb "#0072b2" @shade behind
plot "outline_implicit_euler.tsv" using 1:2 with filledcurves closed fc rgb "#ffffff" fs solid noborder, \
     "" using 1:2 with lines @implicit_euler, @outside
unset object 1
set ylabel "imaginary part of hλ" offset 1,0; set format y "%g"
set title "midpoint, Heun"
outside = runs("midpoint")
plot "outline_midpoint.tsv" using 1:2 with filledcurves closed fc rgb "#e69f00" @shade, \
     "" using 1:2 with lines @midpoint, @outside
unset ylabel; set format y ""
set title "BDF2"
outside = runs("bdf2")
set object 1 rectangle from graph 0,0 to graph 1,1 fc rgb "#2f4b7c" @shade behind
plot "outline_bdf2.tsv" using 1:2 with filledcurves closed fc rgb "#ffffff" fs solid noborder, \
     "" using 1:2 with lines @bdf2, @outside
unset object 1
set ylabel "imaginary part of hλ" offset 1,0; set format y "%g"
set title "RK4"
set xlabel "real part of hλ"
outside = runs("runge_kutta_4")
plot "outline_runge_kutta_4.tsv" using 1:2 with filledcurves closed fc rgb "#7a4a1e" @shade, \
     "" using 1:2 with lines @runge_kutta_4, @outside
unset ylabel; set format y ""
set title "implicit midpoint"
outside = runs("implicit_midpoint")
set object 1 rectangle from graph 0,0 to first 0,graph 1 fc rgb "#000000" @shade behind
set arrow 1 from first 0,graph 0 to first 0,graph 1 nohead @implicit_midpoint
plot @outside
unset object 1
unset arrow 1
set format y "%g"
unset multiplot
unset title

# Where scenes lie, on the nested regions of the explicit methods.
call figure "plane.svg" 640 600
set size ratio -1
set xrange [-5.2:1.9]
set yrange [-3.2:3.2]
set xtics 1
set ytics 1
set xlabel "real part of hλ: decay to the left\n " offset 0,0.4
set ylabel "imaginary part of hλ: oscillation"
set key outside bottom center horizontal reverse Left width -5 samplen (narrow ? 2 : 3)
set label 1 "damped" at -0.91,0.93 center offset 0,1.1 textcolor rgb ink
set label 2 "hard damping:\nits fast part" at -3.13,0 right offset -0.6,1.6 textcolor rgb ink
set label 3 "its slow part" at -0.42,-0.28 right offset 0.6,0 textcolor rgb ink
spring = "right offset -0.6,0.8"
if (narrow) {
    set label 1 offset 0,-0.9
    set label 2 "hard\ndamping:\nits fast part" at -4.05,-0.4 center offset 0,0
    set label 3 at 0.15,-0.1 left offset 0,0
    spring = "left offset 1.1,0"
}
plot "outline_runge_kutta_4.tsv" using 1:2 with filledcurves closed fc rgb "#7a4a1e" fs transparent solid 0.12 noborder, \
     "outline_runge_kutta_4.tsv" using 1:2 with lines @runge_kutta_4 title "RK4", \
     "outline_midpoint.tsv" using 1:2 with lines @midpoint title "midpoint", \
     "outline_explicit_euler.tsv" using 1:2 with lines @explicit_euler title "explicit Euler", \
     "plane_scenes.tsv" using 1:2 with points pt 7 ps 0.9 lc rgb ink, \
     "" using ($1 > -0.1 && $2 < 1.3 ? $1 : NaN):2:3 with labels left offset 0.8,0.5 textcolor rgb ink font ",16", \
     "" using ($2 > 1.3 ? $1 : NaN):2:3 with labels @spring textcolor rgb ink font ",16"
unset label
set size noratio
set autoscale
set xtics autofreq
set ytics autofreq
set grid lc rgb soft lt 1 lw 0.8
