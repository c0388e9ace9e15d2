# Tests of ./course advise: what it refuses, and that people and programs get the same answer. Whether an answer is right is
# tested in tests/advise.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

refuses() {
    what=$1
    shift
    expect 2 course advise "$@"
    is "$(lines err)" 1
    is "$(lines out)" 0
    says err "$what"
}

# "words|what the one line says", each refused with status 2.
test_bad_input_is_refused_by_its_name_and_rule() {
    while IFS='|' read -r words what; do
        # shellcheck disable=SC2086
        refuses "$what" $words
    done <<'END'
|a spring (--omega, or --stiffness with --mass), a damper alone (--damping with --mass) or a spinning body
--omega nan|omega = nan: must be finite and greater than zero
--omega 0|omega = 0: must be finite and greater than zero
--omega 3 --zeta -1|zeta = -1: must be finite and zero or more
--omega 1e400|--omega: '1e400' is beyond what a double can hold, 1.8e308
--omega 3 --step 1e-400|--step: '1e-400' is nearer to zero than a double can be
--omega 3 --frames 0.01,1e999|--frames: '1e999' is beyond
--omega 10 --step 1e300|step = 1e+300: must be so short that its square
--omega 1e-300 --step 1e-300|step = 1e-300: must be so long that omega times it is 1e-12 or more
--omega abc|--omega = abc
--omega 3 --zeta 0,05|--zeta: 0,05 is not a number; write 0.05
--omega= --zeta 0|--omega
--inertia 1,2,9 --spin 1,0,0|moment of inertia = 9: must be at most the sum of the other two
--inertia 1,2,3 --spin 0,0,0|spin = 0: must be finite and greater than zero
--inertia 1,2 --spin 1,0,0|--inertia needs 3 values, with commas between
--inertia 1,2,2 --spin 1,,2|--spin = '1,,2': a number must stand on both sides of each comma
--omega 1 --frames 0.01,|--frames = '0.01,': a number must stand on both sides of each comma
--omega 1 --frames=,0.02|--frames = ',0.02': a number must stand on both sides of each comma
--omega 1 --frames 0.02,0.01|longest frame = 0.01: must be longer than the shortest
--omega 1 --frames 0.01,0.02 --rate 60|--frames and --step or --rate
--omega 1 --stiffness 3 --mass 1|give one of them
--omega 3 --step 1 --rate 60|give one of them
--stiffness 3|belong together
--omega 10 --damping 3|--damping needs --stiffness and --mass
--damping 3 --mass 1 --kind chain|a damper alone has no --kind
--inertia 1,2,3|belong together
--inertia 1,2,3 --spin 1,1,1 --omega 3|a spring or a spinning body
--inertia 1,2,3 --spin 1,1,1 --accuracy 1|--accuracy belongs to a spring
--inertia 1,2,3 --spin 1,1,1 --kicks|are a spring's
--inertia 1,2,3 --spin 1e20,2,3|spin = 1e+20: must be so slow that a step turns the body by at most
--inertia 1,2,3 --spin 1,1,1 --count 1.5|count = 1.5: must be a whole number from 1 to 1e9
--omega 3 --contacts|belong to a spinning body
--kind rope --omega 1|--kind = rope: must be spring, chain, cloth, tether or hinge
--kind chain --omega 1|--kind chain needs --stiffness and --mass
--stiffness 1 --mass 1 --springs 2.5|springs = 2.5: must be a whole number from 1
--stiffness 1 --mass 1 --arm 1|--arm needs --turning
--stiffness 1 --mass 1 --other-mass 1|--other-mass belongs to --kind hinge
--kind hinge --stiffness 1 --mass 1 --springs 2|--springs belongs to a body, a chain or a cloth
--kind cloth --stiffness 1 --mass 1 --arm 1 --turning 1|--arm belongs to a body that turns
END
    for option in --stiffness --mass --zeta --damping --step --rate --accuracy --springs --count; do
        refuses "$option: '' is no number" --omega 3 $option ''
    done
}

# verdict METHOD: what the JSON in `out` says of it.
verdict() { grep -A1 "\"method\": \"$1\"" out | sed -n 's/.*"verdict": "\(.*\)".*/\1/p'; }

test_the_three_eulers_on_a_spring_at_60_hz() {
    expect 0 course advise --omega 100 --json
    is "$(verdict 'explicit Euler')" grows
    is "$(verdict 'semi-implicit Euler')" stable
    is "$(verdict 'implicit Euler')" stable
    expect 0 course advise --omega 121 --json
    is "$(verdict 'semi-implicit Euler')" grows
    expect 0 course advise --omega 120 --json
    is "$(verdict 'semi-implicit Euler')" 'too close to call'
    expect 0 course advise --omega 100 --zeta 0.1 --json
    is "$(verdict Verlet)" refused
    for key in growth_per_second period_error_percent cost reason; do
        is "$(grep -c "\"$key\": " out)" 13
    done
    silent_on out nan
    silent_on out inf
}

# ω = √(9/1) = 3, ζ = 1.2/(2 √9) = 0.2: the same spring in other words gets the same answer.
test_stiffness_mass_and_damping_are_omega_and_zeta() {
    expect 0 course advise --stiffness 9 --mass 1 --damping 1.2 --rate 50 --json
    mv out by_stiffness
    expect 0 course advise --omega 3 --zeta 0.2 --step 0.02 --json
    is "$(grep -c verdict out)" 13
    is "$(grep verdict out)" "$(grep verdict by_stiffness)"
    is "$(grep -o '"cost": [0-9]*' out)" "$(grep -o '"cost": [0-9]*' by_stiffness)"
}

test_people_are_told_what_programs_are_told() {
    expect 0 course advise --omega 100 --zeta 0.05 --json
    for method in 'explicit Euler' 'midpoint' 'BDF2' 'constant acceleration'; do
        verdict "$method"
    done >told
    expect 0 course advise --omega 100 --zeta 0.05
    is "$(grep -E '^(explicit Euler|midpoint|BDF2|constant acceleration) +(grows|stable)' out | sed 's/.*\(grows\|stable\).*/\1/')" \
        "$(sed -n '1p;2p;3p;4p' told)"
    says out 'the cheapest is'
    says out 'four steps a period'
}

# The fast part decays 400 times faster than the slow one, and implicit midpoint hardly lets it.
test_what_rings_is_said_and_not_recommended() {
    expect 0 course advise --omega 5 --zeta 20 --step 2.74
    says out 'stable, but rings: a step multiplies the fast part by −0.993'
    silent_on out 'steps of 2.74 s'
    is "$(grep -c '^implicit midpoint  *stable, rings  ' out)" 1
    says out 'It rings when a part that should decay turns its sign from step to step'
    expect 0 course advise --omega 10 --zeta 1000000
    says out 'stable, but rings: a step multiplies the fast part by nearly −1'
    silent_on out 'the cheapest is implicit midpoint'
    expect 0 course advise --omega 5 --zeta 20 --step 2.74 --json
    is "$(grep -c '"ringing": -0.99' out)" 1
    is "$(grep -c '"ringing": null' out)" 12
    is "$(verdict 'implicit midpoint')" stable
}

# What is printed, as one line: people's lines are broken anywhere.
joined() { tr '\n' ' ' <out >joined; }

test_one_method_is_recommended() {
    expect 0 course advise --omega 10 --accuracy 5
    says out 'the cheapest is Verlet'
    says out 'Recommended at 1/60 s: Verlet;'
    expect 0 course advise --omega 1000 --frames 0.01,0.02
    says out 'Recommended: a constant step'
    expect 0 course advise --omega 100 --zeta 0.05 --json
    is "$(grep -A8 '"recommended": {' out | grep -c -E '"name": "swing"|"method": "semi-implicit Euler, new damping"|"substeps": 2|"why": "|"where": "ch3_energy"')" 5
    expect 0 course advise --omega 3 --zeta 2
    joined
    says joined 'no position while it decays, for 7.82 s,'
    silent_on joined 'in the first period'
}

# 2·2k/m = 4000.
test_each_kind_of_spring_has_its_fastest_oscillation() {
    expect 0 course advise --kind chain --stiffness 1000 --mass 1
    says out 'ω² = 2·2k/m, neighbours against each other; so ω = 63.2'
    expect 0 course advise --kind hinge --stiffness 1000 --mass 1 --other-mass 2
    says out 'ω = 38.7 rad/s, ζ = 0'
    expect 0 course advise --kind tether --omega 10
    says out 'A tether only pulls: the limit and the numbers are for a taut tether.'
    expect 0 course advise --mass 1 --damping 60
    says out 'a step multiplies the velocity by e^(−hc/m) = 0.3679'
    is "$(grep -c '^explicit Euler  *stable  *37 % ' out)" 1
}

test_the_table_fits_a_terminal() {
    for question in '--omega 100 --zeta 0.05' '--omega 5 --zeta 20 --step 2.74' '--omega 10000 --zeta 1 --rate 1000'; do
        expect 0 course advise $question
        is "$(LC_ALL=C.UTF-8 awk '/^method/ { in_table = 1 } /^$/ { in_table = 0 } in_table && length($0) > 100' out)" ''
    done
}

test_numbers_below_a_million_are_written_out() {
    expect 0 course advise --omega 0.001 --zeta 0.1
    says out 'h < 1810 s'
    expect 0 course advise --stiffness 60000 --mass 20 --damping 3000 --rate 4321
    says out ' 4321'
    silent_on out 'e+03'
}

# ---- A spinning body ------------------------------------------------------------------------------

plank='--inertia 0.758,0.787,0.0313 --spin 0,0,20'
box='--inertia 13,10,5 --spin 1,10,0.1'

test_a_spinning_plank() {
    expect 0 course advise --inertia 0.758,0.787,0.0313 --spin 0,0,60 --json
    is "$(verdict explicit)" 'one step can'
    is "$(verdict 'one Newton step')" 'one step can'
    is "$(verdict passive)" never
    is "$(verdict 'half-step Jacobian')" bounded
    is "$(verdict 'ball and remainder 4')" bounded
    silent_on out nan
    silent_on out inf
    expect 0 course advise --inertia 0.758,0.787,0.0313 --spin 0,0,6 --json
    is "$(verdict 'one Newton step')" never
    expect 0 course advise --inertia 1,1,1 --spin 0,0,60
    is "$(grep -c '  never  ' out)" 13
    is "$(grep -c '^dropped .* lost$' out)" 1
    is "$(grep -c '^dropped, turned by h|ω|  *× 1 .* below 0.0001 %$' out)" 1
    says out 'Recommended: nothing: leave the gyroscopic torque out because it is zero, or next to it;'
    expect 0 course advise $plank
    is "$(grep -c '^explicit  *one step can: [+]7.4 %  *every step can  *1 torque  *60$' out)" 1
    is "$(grep -c '^dropped  *never  *no limit  *nothing  *0$' out)" 1
    is "$(grep -c '^ball and remainder 4  *at most × 25.1  *no limit  *14 turns  *840$' out)" 1
}

# Passive takes its spin about the length, and nobody sees why.
test_a_spear_is_told_to_be_one() {
    expect 0 course advise $plank
    says out 'Two moments are within 3.7 % of each other. By passive half of the spin'
    says out '1.02 s; by SymmetricInertia it stays'
    says out '--inertia 0.7725,0.7725,0.0313'
    says out 'tilted by a hundredth'
    is "$(grep -c '^passive  *× 0.51 .* lost$' out)" 1
    says out 'Ball and remainder 2 is accurate for this throw, with the true moments'
    is "$(grep -c '^ball and remainder 2  *× 1 .* 0.00068 %  *0.00068 %$' out)" 1
    expect 0 course advise --inertia 0.7725,0.7725,0.0313 --spin 0,0,20
    silent_on out 'Two moments'
    expect 0 course advise --inertia 1,2,3 --spin 1e10,2,3
    silent_on out '- %'
    expect 0 course advise $plank --json
    is "$(grep -c '"half_gone_by_passive": 1.01' out)" 1
    expect 0 course advise $box
    silent_on out 'Two moments'
    silent_on out 'tilted'
}

test_people_are_told_one_line_to_take_and_last() {
    expect 0 course advise $box --contacts --callback
    is "$(grep -c '^Recommended: ' out)" 1
    is "$(tail -n 1 out | cut -c 1-50)" 'Recommended: the passive step (linearly implicit, '
    says out ', chapter 8.'
    silent_on out '**'
    silent_on out '`'
    expect 0 course advise --inertia 13,10,5 --spin 0,40,0
    says out '(here 3 substeps of 0.00556 s)'
    expect 0 course advise $box --frames 0.01,0.02
    says out 'h = 0.02 s at most'
    is "$(grep -c '^half-step Jacobian  *one step can' out)" 1
    says out 'the bound is that of a constant step'
}

begin "$@"
new_fixture "$4" "$5"
"$function"
