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

# A text that the code names must be in words.txt, and one that it does not name is for nobody.
test_words_are_those_that_the_code_names() {
    cd "$here/../../tools/advise"
    sections='number|table|verdict|why|found|recommend|report|spring|damper|body|throw'
    is "$(awk -F '[][]|: ' '/^\[/ { section = $2 } /^[a-z]/ { print section "." $1 }' words.txt | grep -E "^($sections)\." | sort)" \
        "$(grep -ohE "\"($sections)\.[a-z0-9_]+\"" ./*.cpp | grep -v hpp | tr -d '"' | sort -u)"
}

# "words|what the one line says", each refused with status 2.
test_bad_input_is_refused_by_its_name_and_rule() {
    while IFS='|' read -r words what; do
        # shellcheck disable=SC2086
        refuses "$what" $words
    done <<'END'
|a spring (--omega, or --stiffness with --mass), a damper alone (--damping with --mass) or a spinning body
--omega 0|omega = 0: must be finite and greater than zero
--omega 1e400|omega = inf: must be finite and greater than zero
--omega 10 --step 1e300|step = 1e+300: must be so short that its square
--omega 1e-300 --step 1e-300|step = 1e-300: must be so long that omega times it is 1e-12 or more
--omega 3 --zeta 0,05|Could not convert: --zeta = 0,05
--inertia 1,2,9 --spin 1,0,0|moment of inertia = 9: must be at most the sum of the other two
--inertia 1,2,2 --spin 1,,2|--spin: At least 3 required but received 2
--omega 1 --frames 0.02,0.01|longest frame = 0.01: must be longer than the shortest
--omega 1 --frames 0.01,0.02 --rate 60|--frames and --step or --rate
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
--omega 3 --accuracy 90|accuracy = 90: must be from 1e-6 to 50 percent
--omega 3 --contacts|belong to a spinning body
--kind rope --omega 1|--kind = rope: must be spring, chain, cloth, tether or hinge
--stiffness 1 --mass 1 --springs 2.5|springs = 2.5: must be a whole number from 1
--stiffness 1 --mass 1 --arm 1|--arm needs --turning
--kind hinge --stiffness 1 --mass 1 --springs 2|--springs belongs to a body, a chain or a cloth
--kind cloth --stiffness 1 --mass 1 --arm 1 --turning 1|--arm belongs to a body that turns
END
    refuses "--zeta: '' is no number" --omega 3 --zeta ''
}

# verdict METHOD: what the JSON in `out` says of it.
verdict() { grep -A1 "\"method\": \"$1\"" out | sed -n 's/.*"verdict": "\(.*\)".*/\1/p'; }

test_json_has_every_key_for_every_method_and_no_number_beyond_json() {
    expect 0 course advise --omega 100 --zeta 0.1 --json
    is "$(verdict 'explicit Euler')" grows
    is "$(verdict 'implicit Euler')" stable
    is "$(verdict Verlet)" refused
    methods=$(grep -c '"method": ' out)
    for key in growth_per_second period_error_percent cost; do
        is "$(grep -c "\"$key\": " out)" $((methods - 1)) # the answer names its method, too
    done
    silent_on out nan
    silent_on out inf
    is "$(grep -A8 '"recommended": {' out | grep -c -E '"name": "swing"|"method": "semi-implicit Euler, new damping"|"substeps": 2|"why": "|"where": "ch3_energy"')" 5
}

# ω = √(9/1) = 3, ζ = 1.2/(2 √9) = 0.2: the same spring in other words gets the same answer.
test_stiffness_mass_and_damping_are_omega_and_zeta() {
    expect 0 course advise --stiffness 9 --mass 1 --damping 1.2 --rate 50 --json
    mv out by_stiffness
    expect 0 course advise --omega 3 --zeta 0.2 --step 0.02 --json
    is "$(grep verdict out)" "$(grep verdict by_stiffness)"
    is "$(grep -o '"cost": [0-9]*' out)" "$(grep -o '"cost": [0-9]*' by_stiffness)"
}

test_one_method_is_recommended() {
    expect 0 course advise --omega 10 --accuracy 5
    says out 'the cheapest is Verlet'
    says out 'Recommended at 1/60 s: Verlet;'
    expect 0 course advise --omega 1000 --frames 0.01,0.02
    says out 'Recommended: a constant step'
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

plank='--inertia 0.758,0.787,0.0313 --spin 0,0,20'
box='--inertia 13,10,5 --spin 1,10,0.1'

test_a_spinning_plank() {
    expect 0 course advise $plank --json
    is "$(verdict explicit)" 'one step can'
    is "$(verdict passive)" never
    is "$(verdict 'half-step Jacobian')" bounded
    is "$(grep -c '"half_gone_by_passive": 1.01' out)" 1
    silent_on out nan
    silent_on out inf
    expect 0 course advise $plank
    is "$(grep -c '^explicit  *one step can: [+]7.4 %  *every step can  *1 torque  *60$' out)" 1
    is "$(grep -c '^ball and remainder 4  *at most × 25.1  *no limit  *14 turns  *840$' out)" 1
    is "$(grep -c '^passive  *× 0.51 .* lost$' out)" 1
    says out 'Two moments are within 3.7 % of each other. By passive half of the spin'
    expect 0 course advise --inertia 1,1,1 --spin 0,0,60
    is "$(grep -c '^dropped, turned by h|ω|  *× 1 .* below 0.0001 %$' out)" 1
    silent_on out 'Two moments'
}

test_people_are_told_one_line_to_take_and_last() {
    expect 0 course advise $box --contacts --callback
    is "$(grep -c '^Recommended: ' out)" 1
    is "$(tail -n 1 out | cut -c 1-50)" 'Recommended: the passive step (linearly implicit, '
    silent_on out '**'
    expect 0 course advise --inertia 13,10,5 --spin 0,40,0
    says out '(here 3 substeps of 0.00556 s)'
    expect 0 course advise $box --frames 0.01,0.02
    is "$(grep -c '^half-step Jacobian  *one step can' out)" 1
}

begin "$@"
new_fixture "$4" "$5"
"$function"
