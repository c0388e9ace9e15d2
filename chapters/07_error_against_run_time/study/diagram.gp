# call rooms."diagram.gp" SCENE "methods" LEAST: the diagram of a scene, LEAST the least error shown. Every
# method has its own line; a circle is a step of 1/60 s, a cross at the top a run that has blown up.
# `library` names whose methods they are.
call rooms."axes.gp" ARG3
title_of(id) = id eq "explicit_euler" ? "explicit Euler" : id eq "implicit_euler" ? "implicit Euler" : \
    id eq "semi_implicit_euler" ? "semi-implicit Euler" : id eq "runge_kutta_4" ? "Runge–Kutta 4" : \
    id eq "implicit_midpoint" ? "implicit midpoint" : id eq "velocity_verlet" ? "velocity Verlet" : \
    id eq "bdf2" ? "BDF2" : id eq "heun" ? "Heun" : id eq "verlet" ? "Verlet" : \
    id eq "semi_implicit_euler__new_damping" ? "new damping" : id eq "one_newton_step" ? "one Newton step" : id eq "implicit__converged" ? "converged" : \
    id eq "passive__arms_of_the_start" ? "passive, arms of the start" : \
    id eq "runge_kutta_4_in_the_air__passive" ? "RK4 in the air" : id
style_of(id) = id eq "semi_implicit_euler__new_damping" ? new_damping : id eq "explicit" ? explicit_gyroscopic : id eq "dropped" ? no_gyroscopic : \
    id eq "one_newton_step" ? implicit_gyroscopic : id eq "implicit__converged" ? converged_gyroscopic : \
    id eq "passive" ? passive_gyroscopic : id eq "passive__arms_of_the_start" ? third : \
    id eq "runge_kutta_4_in_the_air__passive" ? runge_kutta_4 : value(id)
curves = "0.1 with lines @faint notitle, 0.01 with lines @faint notitle"
do for [id in ARG2] {
    mine = sprintf("strcol(1) eq '%s' && strcol(2) eq '%s'", id, library)
    curves = curves . sprintf(", '%s.tsv' using (%s && strcol(9) eq 'no' ? $6*1e6 : NaN):5 with lines %s title '%s'", \
        ARG1, mine, style_of(id), title_of(id))
    curves = curves . sprintf(", '' using (%s && strcol(9) eq 'no' && abs($3*60 - 1) < 0.01 ? $6*1e6 : NaN):5 with points pt 7 ps 0.8 %s notitle", \
        mine, colour_of(style_of(id)))
    curves = curves . sprintf(", '' using (%s && strcol(9) eq 'yes' ? $6*1e6 : NaN):(2.2) with points pt 2 ps 0.9 lw 2 %s notitle", \
        mine, colour_of(style_of(id)))
}
eval "plot " . curves
