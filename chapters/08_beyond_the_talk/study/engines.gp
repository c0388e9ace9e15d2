# The appendix: the energy over a minute of a box thrown about each of its axes. Box3D's, Bullet's
# and MuJoCo's rule is the talk's, ODE's is the passive step, Godot drops the torque: those colours.
# Magnus-Taylor's curve is implicit midpoint's, at one, and Moser-Veselov's two would be; Buss's and
# Adams-Bashforth's lie within a tenth of it, Spiers's within two thousandths.
box3d = "lc rgb '#0072b2' lw 2.5 dt 1"
godot = "lc rgb '#b15a98' lw 5 dt 1"

call figure "engines.svg" 640 900
unset logscale
set autoscale
set multiplot layout 3,1 margins side(0.13),0.97,0.215,0.96 spacing 0,0.055
set xrange [0:60]
set yrange [0:1.5]
set ytics 0.5
set xtics 10 format ""
set format y "%g"
unset xlabel
unset key
set mytics default
do for [throw in "short middle long"] {
    set label 1 "thrown about the ".throw." axis" at graph 0.985,0.93 right front textcolor rgb ink
    set ylabel throw eq "middle" ? "energy / energy at the start" : "" offset 0.5,0
    if (throw eq "long") {
        set xtics 10 format "%g"
        set xlabel "time t (s)"
        set key at screen 0.99,0.12 right top vertical maxrows 4 reverse Left samplen 2 width -7
        if (narrow) { set key at screen 0.5,0.065 center font ",14" }
    }
    plot "engines_godot_".throw.".tsv" using 1:2 with lines @godot title "Godot: no torque", \
         "engines_ode_".throw.".tsv" using 1:2 with lines @passive_gyroscopic title "ODE", \
         "engines_box3d_".throw.".tsv" using 1:2 with lines @box3d title "Box3D, four substeps", \
         "engines_bullet_".throw.".tsv" using 1:2 with lines @implicit_gyroscopic title "Bullet, MuJoCo", \
         "engines_explicit_euler_".throw.".tsv" using 1:2 with lines @explicit_gyroscopic title "explicit Euler", \
         "engines_implicit_midpoint_".throw.".tsv" using 1:2 with lines @implicit_midpoint title "midpoint, Moser–Veselov", \
         "engines_magnus_taylor_4_".throw.".tsv" using 1:2 with lines @implicit_midpoint title "Magnus–Taylor", \
         "engines_jolt_".throw.".tsv" using 1:2 with lines @jolt_gyroscopic title "Jolt, PhysX, Rapier, Avian"
}
unset multiplot
unset label
set format x "%g"
