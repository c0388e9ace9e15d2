# Tests of ./course advise: what it refuses, and that what it says for people and for programs is one.

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

test_bad_input_is_refused_by_its_name_and_rule() {
    refuses 'a spring (--omega, or --stiffness with --mass), a damper alone (--damping with --mass) or a spinning body'
    refuses 'omega = nan: must be finite and greater than zero' --omega nan
    refuses 'omega = -3: must be finite and greater than zero' --omega -3
    refuses 'omega = 0: ' --omega 0
    refuses 'zeta = -1: must be finite and zero or more' --omega 3 --zeta -1
    refuses 'step = 0: must be finite and greater than zero' --omega 3 --step 0
    refuses 'rate = inf: ' --omega 3 --rate inf
    refuses "--omega: '1e400' is beyond what a double can hold, 1.8e308" --omega 1e400
    refuses "--omega: '-1e400' is beyond what a double can hold, 1.8e308" --omega -1e400
    refuses "--step: '1e-400' is nearer to zero than a double can be" --omega 3 --step 1e-400
    refuses "--frames: '1e999' is beyond" --omega 3 --frames 0.01,1e999
    refuses 'step = 1e+300: must be so short that its square' --omega 10 --step 1e300
    refuses 'step = 1e+200: must be so short that its square' --omega 10 --frames 1,1e200
    refuses 'step = 1e-300: must be so long that omega times it is 1e-12 or more' --omega 1e-300 --step 1e-300
    refuses 'step times spin = 0: ' --inertia 1,2,3 --spin 1e-300,0,0 --step 1e-300
    refuses 'stiffness = 0: ' --stiffness 0 --mass 1
    refuses 'mass = -1: ' --stiffness 1 --mass -1
    refuses 'accuracy = 0: ' --omega 3 --accuracy 0
    refuses '--omega = abc' --omega abc
    refuses '--zeta: 0,05 is not a number; write 0.05' --omega 3 --zeta 0,05
    refuses '--step: -1,5e-3 is not a number; write -1.5e-3' --omega 3 --step -1,5e-3
    refuses 'moment of inertia = 9: must be at most the sum of the other two' --inertia 1,2,9 --spin 1,0,0
    refuses 'spin = 0: must be finite and greater than zero' --inertia 1,2,3 --spin 0,0,0
    refuses 'spin = inf: must be a finite number' --inertia 1,2,3 --spin inf,0,0
    refuses '--inertia needs 3 values, with commas between' --inertia 1,2 --spin 1,0,0
}

test_an_empty_word_is_no_number() {
    refuses "--omega: '' is no number" --omega ''
    for option in --stiffness --mass --zeta --damping --step --rate --accuracy; do
        refuses "$option: '' is no number" --omega 3 $option ''
        refuses "$option: '' is no number" $option '' --omega 3
    done
    refuses '--omega' --omega= --zeta 0
    for option in --inertia --spin; do
        refuses "$option" --inertia 1,2,3 --spin 1,0,0 $option ''
    done
    refuses '--spin' --inertia 1,2,3 --spin 1,,0
}

test_two_words_for_the_same_are_refused() {
    refuses 'give one of them' --omega 1 --stiffness 3 --mass 1
    refuses 'belong together' --stiffness 3
    refuses '--damping needs --stiffness and --mass' --omega 10 --damping 3
    refuses '--damping and --mass belong together' --damping 3
    refuses 'damping = 0: must be' --damping 0 --mass 1
    refuses 'a damper alone has no --kind' --damping 3 --mass 1 --kind chain
    refuses 'give one of them' --stiffness 3 --mass 1 --zeta 1 --damping 2
    refuses 'give one of them' --omega 3 --step 1 --rate 60
    refuses 'belong together' --inertia 1,2,3
    refuses 'a spring or a spinning body' --inertia 1,2,3 --spin 1,1,1 --omega 3
    refuses '--accuracy belongs to a spring' --inertia 1,2,3 --spin 1,1,1 --accuracy 1
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

# Without a damper implicit Euler keeps 1/(1 + (ωh)²) of the energy a step.
test_little_energy_is_told_as_it_is() {
    expect 0 course advise --omega 100 --rate 60
    says out '× 2.3e-35'
    silent_on out '× 0 '
    expect 0 course advise --omega 10000 --zeta 1 --rate 1000
    says out '× under 1e-308'
    silent_on out '× 0 '
    silent_on out 'amplitude × 0.'
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

test_no_step_longer_than_the_asked_one_is_recommended() {
    expect 0 course advise --omega 5 --zeta 20 --rate 60
    says out 'At your rate, within 1 %: implicit Euler; implicit midpoint; BDF2;'
    says out 'To be right to 1 % at steps no longer than yours, the cheapest is '
    says out 'steps of 0.0167 s, 60 per second, cost 120 per second'
    expect 0 course advise --omega 100 --zeta 0.05 --rate 60
    says out 'At your rate, within 1 %: none.'
    says out 'Right to 1 %: let go at rest, no position in the first period, 0.0628 s, is off'
    expect 0 course advise --omega 100 --zeta 0.05 --step 0.001
    says out 'At your step, within 1 %: '
    says out 'steps of 0.001 s, 1000 per second'
    expect 0 course advise --omega 10
    says out 'At 60 steps per second, within 1 %: '
    says out 'at steps no longer than 1/60 s, the cheapest is '
    says out 'steps of 0.0167 s, 60 per second'
    expect 0 course advise --omega 0.001 --zeta 0.1
    says out 'steps of 0.0167 s, 60 per second, cost 60 per second'
    says out 'Equally cheap: explicit Euler; constant acceleration.'
    silent_on out 'If it only has to'
}

# Four steps a period and more: semi-implicit Euler keeps its size, and its place is far off.
test_the_error_that_is_seen_counts() {
    expect 0 course advise --omega 0.84 --step 1 --json
    is "$(grep -A20 '"method": "semi-implicit Euler"' out | sed -n 's/.*"position_error_percent": \([0-9]*\).*/\1/p')" 55
    is "$(grep -A20 '"method": "semi-implicit Euler"' out | sed -n 's/.*"rate_error_percent": \([0-9]*\).*/\1/p')" 3
    expect 0 course advise --omega 0.84 --step 1
    is "$(grep -c '^semi-implicit Euler  *stable, far off  *56 % ' out)" 1
    says out 'Recommended at your step: semi-implicit Euler, with the damping at the new'
    joined
    says joined '(chapter 3). Off by 56 % in the first period'
}

# What is printed, as one line: people's lines are broken anywhere.
joined() { tr '\n' ' ' <out >joined; }

test_the_error_is_told_at_the_substeps_too() {
    expect 0 course advise --omega 100 --zeta 0.05 --rate 60
    joined
    says joined 'in 2 substeps;'
    says joined '(chapter 3). Off by 42 % in the first period, in frequency and decay by'
    expect 0 course advise --omega 10 --accuracy 1
    joined
    says joined '(chapter 7). Off by 0.56 %'
}

test_what_decays_has_no_oscillation() {
    expect 0 course advise --omega 3 --zeta 2
    joined
    says joined 'from the true ones while it decays, over the start'
    says joined 'no position while it decays, for 7.82 s,'
    says joined '% while it decays, in frequency and decay by'
    silent_on joined 'in the first period'
    silent_on joined 'many periods'
}

test_the_one_that_is_right_is_recommended() {
    expect 0 course advise --omega 2000 --zeta 0.15 --accuracy 1
    joined
    says joined 'implicit Euler; as accurate as you asked, at the least cost in whole substeps'
    expect 0 course advise --omega 1e6 --zeta 0.01
    says out 'Recommended at 1/60 s: implicit Euler'
    expect 0 course advise --kind cloth --stiffness 1e9 --mass 0.001 --damping 5
    joined
    says joined 'Recommended at 1/60 s: implicit Euler, and factorise; semi-implicit Euler would want '
    expect 0 course advise --kind cloth --springs 8 --stiffness 10000 --mass 0.00139 --rate 60
    joined
    says joined ': semi-implicit Euler, in 90 substeps; a substep costs one force per spring'
}

test_a_tether_gets_an_answer_of_its_own() {
    for wish in '' '--keep-size' '--accuracy 1' '--frames 0.01,0.02'; do
        expect 0 course advise --kind tether --stiffness 900 --mass 1 $wish
        joined
        silent_on joined 'does not drift'
        silent_on joined 'its energy stays'
    done
    expect 0 course advise --kind tether --stiffness 900 --mass 1
    joined
    says joined 'Recommended at 1/60 s: implicit Euler; in no step does its energy rise, slack or taut'
    says joined 'in the first period if it is taut'
    # Tied off the centre of mass it turns the body, and its potential is not convex.
    expect 0 course advise --kind tether --mass 1 --stiffness 1000 --arm 0.5 --turning 0.0833
    joined
    says joined 'a step may raise the energy where the tether turns a body'
    silent_on joined 'slack or taut'
    expect 0 course advise --kind tether --stiffness 900 --mass 1 --keep-size
    joined
    says joined 'in 4 substeps; with ωh at most 0.125 none of 400 undamped throws'
}

test_one_method_is_recommended() {
    expect 0 course advise --omega 100 --zeta 0.05 --rate 60
    says out 'velocity, in 2 substeps;'
    for accuracy in 1 5 50; do
        expect 0 course advise --omega 10 --accuracy $accuracy
        says out 'the cheapest is Verlet'
        says out 'Recommended at 1/60 s: Verlet;'
    done
    expect 0 course advise --omega 1000 --zeta 3
    says out 'Recommended at 1/60 s: implicit Euler'
    expect 0 course advise --omega 1000
    says out 'Recommended at 1/60 s: BDF2'
    joined
    says joined 'must be seen, semi-implicit Euler in substeps of ωh at most 1'
    expect 0 course advise --omega 1000 --keep-size
    says out 'Recommended at 1/60 s: implicit midpoint'
    expect 0 course advise --omega 1000 --frames 0.01,0.02
    says out 'Recommended: a constant step'
    expect 0 course advise --omega 100 --zeta 0.05 --json
    is "$(grep -A8 '"recommended": {' out | grep -c -E '"name": "swing"|"method": "semi-implicit Euler, new damping"|"substeps": 2|"why": "|"where": "ch3_energy"')" 5
}

# 2·2k/m = 4000, and with a plank's arm 2k(1/m + r²/I) = 2000 (1 + 3).
test_many_springs_have_a_fastest_oscillation() {
    expect 0 course advise --kind chain --stiffness 1000 --mass 1
    says out 'ω² = 2·2k/m, neighbours against each other; so ω = 63.2'
    expect 0 course advise --kind cloth --stiffness 1000 --mass 1
    says out 'ω² = 2·4k/m, neighbours against each other (four'
    joined
    says joined 'four springs hold a point; with diagonals give --springs 8); so ω = 89.4'
    expect 0 course advise --kind cloth --stiffness 1000 --mass 1 --springs 8
    silent_on out 'diagonals'
    expect 0 course advise --stiffness 1000 --mass 1 --springs 2 --arm 0.5 --turning 0.083333333333
    joined
    says joined 'ω² = 2·k(1/m + r²/I), if all pull at one end, one way; so ω = 89.4 rad/s at most, for springs near their rest length, and at least 31.6 rad/s.'
    expect 0 course advise --kind hinge --stiffness 1000 --mass 1 --other-mass 2 --arm 0
    refuses '--arm needs --turning' --kind hinge --stiffness 1000 --mass 1 --arm 1
    expect 0 course advise --kind hinge --stiffness 1000 --mass 1 --other-mass 2
    says out 'ω = 38.7 rad/s, ζ = 0'
    expect 0 course advise --kind chain --stiffness 1000 --mass 1 --step 0.04 --json
    is "$(verdict 'semi-implicit Euler')" 'not proven'
    is "$(verdict 'implicit Euler')" stable
    expect 0 course advise --kind tether --omega 10 --json
    is "$(verdict 'semi-implicit Euler')" 'not proven'
    is "$(verdict 'implicit Euler')" stable
    expect 0 course advise --kind tether --omega 10
    says out 'A tether only pulls: the limit and the numbers are for a taut tether.'
}

test_frames_and_kicks() {
    expect 0 course advise --omega 30 --frames 0.0166667,0.0333333 --json
    is "$(verdict 'implicit Euler')" stable
    is "$(verdict 'implicit midpoint')" stable
    is "$(verdict 'semi-implicit Euler')" grows
    is "$(verdict 'Runge-Kutta 4')" stable
    expect 0 course advise --omega 30 --frames 0.0166667,0.0333333
    joined
    says joined "the limits of semi-implicit Euler, of Verlet's kind and of constant acceleration hold for a constant step"
    says joined 'where that cannot be, Runge-Kutta 4; with ωh and ζωh at most 1 no mixture of step lengths blows it up'
    expect 0 course advise --stiffness 58860 --mass 1200 --damping 8000 --frames 0.0069,0.033
    joined
    says joined 'where that cannot be, semi-implicit Euler, new damping; with this much damping'
    silent_on joined 'may blow up'
    expect 0 course advise --omega 30 --frames 0.0166667,0.0333333 --keep-size
    joined
    says joined 'where that cannot be, implicit midpoint;'
    expect 0 course advise --omega 30 --frames 0.0166667,0.0333333 --accuracy 1
    joined
    says joined 'where that cannot be, Runge-Kutta 4, in 2 substeps;'
    expect 0 course advise --omega 30 --kicks
    says out 'restart it after each kick'
}

test_a_damper_alone_is_answered() {
    expect 0 course advise --mass 1 --damping 60
    says out 'a step multiplies the velocity by e^(−hc/m) = 0.3679'
    is "$(grep -c '^explicit Euler  *stable  *37 % ' out)" 1
    says out 'At 60 steps per second, within 1 %: Runge-Kutta 4.'
    says out 'Recommended at 1/60 s: semi-implicit Euler, with the damping at the new'
    expect 0 course advise --mass 1 --damping 600 --json
    is "$(verdict 'explicit Euler')" grows
    is "$(grep -A8 '"recommended": {' out | grep -c -E '"name": "pull"|"method": "implicit Euler"')" 2
    expect 0 course advise --stiffness 1e-9 --mass 1 --damping 60
    silent_on out 'the cheapest is explicit Euler'
    joined
    says joined 'For the damper alone give --mass and --damping without --stiffness.'
    says joined 'its velocity must not be off by more than 1 %'
}

test_several_dampers_are_swept_there_and_back() {
    for question in '--kind chain --stiffness 400 --mass 2 --damping 1000' '--kind cloth --stiffness 400 --mass 2 --damping 30' \
        '--kind hinge --stiffness 400 --mass 2 --damping 30' '--springs 3 --stiffness 400 --mass 2 --damping 30'; do
        expect 0 course advise $question
        joined
        says joined 'Recommended at 1/60 s: semi-implicit Euler, the dampers swept there and back, dividing by a square root each way'
        says joined '< 2, dampers there and back or all at once'
    done
    expect 0 course advise --stiffness 400 --mass 2 --damping 1000
    silent_on out 'there and back'
}

test_a_joint_gets_what_a_joint_can_carry_out() {
    expect 0 course advise --kind hinge --stiffness 1000000 --mass 3 --damping 10
    joined
    says joined 'Recommended at 1/60 s: implicit Euler: the joint as a soft constraint'
    says joined 'Off by 85 % in the first period'
}

test_bad_kinds_are_refused() {
    refuses '--kind = rope: must be spring, chain, cloth, tether or hinge' --kind rope --omega 1
    refuses '--kind chain needs --stiffness and --mass' --kind chain --omega 1
    refuses 'springs = 2.5: must be a whole number from 1' --stiffness 1 --mass 1 --springs 2.5
    refuses 'springs = 0: ' --stiffness 1 --mass 1 --springs 0
    refuses 'arm = -1: must be finite and zero or more' --stiffness 1 --mass 1 --arm -1 --turning 1
    refuses 'turning = 0: must be finite and greater than zero' --stiffness 1 --mass 1 --arm 1 --turning 0
    refuses '--arm needs --turning' --stiffness 1 --mass 1 --arm 1
    refuses '--turning needs --arm' --stiffness 1 --mass 1 --turning 1
    refuses '--other-arm needs --other-turning' --kind hinge --stiffness 1 --mass 1 --other-arm 0.1
    refuses 'other-turning = 0: must be finite and greater' --kind hinge --stiffness 1 --mass 1 --other-arm 1 --other-turning 0
    refuses '--springs belongs to a body, a chain or a cloth' --kind hinge --stiffness 1 --mass 1 --springs 2
    refuses '--arm belongs to a body that turns' --kind cloth --stiffness 1 --mass 1 --arm 1 --turning 1
    refuses '--other-mass belongs to --kind hinge' --stiffness 1 --mass 1 --other-mass 1
    for row in , 0.01, ,0.02 0.01,,0.02; do
        refuses "--frames = '$row': a number must stand on both sides of each comma" --frames $row --omega 1
        refuses "--frames = '$row': a number must stand on both sides of each comma" --frames=$row --omega 1
    done
    refuses "--inertia = '1,2,': a number must stand" --inertia 1,2, --spin 1,2,3
    refuses "--spin = '1,,2': a number must stand" --inertia 1,2,2 --spin 1,,2
    refuses '--frames' --frames 0.01 --omega 1
    refuses 'longest frame = 0.01: must be longer than the shortest' --omega 1 --frames 0.02,0.01
    refuses 'shortest frame = 0: ' --omega 1 --frames 0,0.01
    refuses '--frames and --step or --rate' --omega 1 --frames 0.01,0.02 --rate 60
    refuses "are a spring's" --inertia 1,2,3 --spin 1,1,1 --kicks
    refuses "--springs: '' is no number" --stiffness 1 --mass 1 --springs ''
    for number in nan inf; do
        refuses "$number" --kind cloth --stiffness $number --mass 1
        refuses "$number" --stiffness 1 --mass 1 --arm $number --turning 1
    done
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

test_the_words_are_those_of_what_they_mean() {
    expect 0 course advise --omega 100 --zeta 0.05 --rate 60
    says out 'it may die too slowly. Energy that should be gone:'
    is "$(grep -c '^  implicit midpoint  *× 60$' out)" 1
    says out 'ωh = 1.667 > 0.8, the s = ωh with s³/4'
    says out 'takes forces of the position only'
    expect 0 course advise --omega 10
    silent_on out 'die too slowly'
    joined
    says joined 'a mere division'
    silent_on out 'h < 0 s'
    says out '> 0 = 2ζ: no step is short enough'
    expect 0 course advise --omega 10 --step 0.2
    says out 'ωh = 2, the limit itself'
    silent_on out '= 2 = 2,'
    expect 0 course advise --omega 10 --zeta 0.7 --step 2
    says out '× 58000 '
    is "$(grep -c 'e+[0-9]* %' out)" 0
}

begin "$@"
new_fixture "$4" "$5"
"$function"
