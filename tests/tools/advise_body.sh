# Tests of ./course advise about a spinning body.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

plank='--inertia 0.758,0.787,0.0313 --spin 0,0,20'
box='--inertia 13,10,5 --spin 1,10,0.1'

refuses() {
    what=$1
    shift
    expect 2 course advise "$@"
    is "$(lines err)" 1
    is "$(lines out)" 0
    says err "$what"
}

# verdict METHOD: what the JSON in `out` says of it.
verdict() { grep -A1 "\"method\": \"$1\"" out | sed -n 's/.*"verdict": "\(.*\)".*/\1/p'; }

# recommended: the name of the line that the JSON in `out` recommends.
recommended() { sed -n '/"recommended"/,$s/.*"name": "\(.*\)".*/\1/p' out; }

test_bad_input_about_a_body_is_refused_by_its_name_and_rule() {
    refuses 'moment of inertia = 2.0000001: must be at most the sum of the other two moments, 2; it exceeds that by 1e-07' \
        --inertia 1,1,2.0000001 --spin 1,2,3
    refuses 'count = 0: must be a whole number from 1 to 1e9' $box --count 0
    refuses 'count = 1.5: must be a whole number from 1 to 1e9' $box --count 1.5
    refuses 'count = 1e+20: must be a whole number from 1 to 1e9' $box --count 99999999999999999999
    for wish in '' --contacts '--frames 0.01,0.02'; do
        refuses 'spin = 1e+20: must be so slow that a step turns the body by at most' --inertia 1,2,3 --spin 1e20,2,3 $wish
    done
    refuses 'spin = 1e+50: must be so slow that a step' --inertia 1,2,3 --spin 1e50,2,3
    refuses "--spin: '1e400' is beyond what a double can hold, 1.8e308" --inertia 1,2,3 --spin 1,1e400,3
    refuses "--count: '' is no number" $box --count ''
    refuses 'shortest frame = 0.02: must be at most the longest' $box --frames 0.02,0.01
    refuses 'shortest frame = 0: must be finite and greater than zero' $box --frames 0,0.01
    refuses 'longest frame = inf: ' $box --frames 0.01,inf
    refuses '--frames and --step or --rate say the same' $box --frames 0.01,0.02 --rate 60
    refuses '--frames' $box --frames 0.01
    refuses '--frames' $box --frames a,b
    refuses 'belong to a spinning body' --omega 3 --count 3
    refuses 'belong to a spinning body' --omega 3 --contacts
    refuses 'belong to a spinning body' --omega 3 --callback
    refuses '--inertia and --spin belong together' --inertia 1,2,3 --contacts
}

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

test_the_line_of_the_list_that_is_recommended() {
    asks() {
        name=$1
        shift
        expect 0 course advise "$@" --json
        is "$(recommended)" "$name"
    }
    asks free $box
    asks symmetric_free $plank
    asks free_fast --inertia 0.758,0.787,0.0313 --spin 10,5,15
    asks contacts $plank --contacts
    asks symmetric --inertia 1,1,0.2 --spin 1,2,50 --contacts
    asks many --inertia 0.758,0.787,0.0313 --spin 10,5,15 --count 5000
    asks many_fast --inertia 1,1.5,0.8 --spin 0,50,20 --count 5000
    asks symmetric_free --inertia 1,1,0.2 --spin 1,2,50 --frames 0.01,0.02
    asks contacts $box --contacts
    asks callback $box --contacts --callback
    asks callback $plank --contacts --callback
    asks callback_free $plank --callback
    asks callback_symmetric --inertia 1,1,0.3 --spin 0,0,20 --contacts --callback
    asks many $box --count 1000
    asks free $box --count 999
    asks free_uneven $box --frames 0.01,0.02
    asks ball --inertia 1,1,1 --spin 1,2,3 --contacts
    asks ball --inertia 1,1.0000001,1.0000002 --spin 1,2,3 --contacts
    asks symmetric_free --inertia 1,1.0000001,0.5 --spin 1,2,20
    asks symmetric_free --inertia 1,1.000001,0.18 --spin 0,0,63 --count 10000
    asks callback_symmetric --inertia 1,1.001,0.18 --spin 0,0,20 --contacts --callback
    asks callback_light --inertia 3.9e-7,3.9e-7,7.6e-7 --spin 1,2,100 --contacts --callback
    asks many_uneven $box --count 10000 --frames 0.01,0.05
}

# A spear that spins about its length: its roll may be anywhere, its axis is where it should be.
test_a_body_of_revolution_is_lost_when_its_axis_is() {
    spear='--inertia 0.3333,0.3330,0.0004 --spin 0.3,0,30'
    expect 0 course advise $spear
    is "$(grep -c '^half-step Jacobian .* 3.4 %  *lost$' out)" 1
    is "$(grep -c '^dropped .* lost  *lost$' out)" 1
    says out 'a roll about that axis is invisible:'
    says out 'use the first of the two columns'
    expect 0 course advise $spear --json
    is "$(grep -A6 '"most_energy"' out | grep -c '"lost": true')" 6
    is "$(recommended)" symmetric_free
    expect 0 course advise $box
    silent_on out 'a roll about that axis'
    says out 'orientation off in 2 s'
}

# Of two equal moments the library's passive takes nothing: no callback's answer, and a row of its own.
test_two_equal_moments() {
    wheel='--inertia 1,1,0.3 --spin 0,0,20'
    expect 0 course advise $wheel --contacts --callback
    tail -n 1 out >last
    says last 'in Bullet and Box3D the engine'"'"'s own one Newton step: leave it on'
    says last 'passive, by its formula for three moments'
    is "$(grep -c '^passive  ' out)" 0
    is "$(grep -c '^passive, three moments  *× 0.646 .* lost$' out)" 1
    is "$(grep -c '^passive, two equal moments  *× 1  *× 1  *100 %' out)" 1
    expect 0 course advise $wheel --contacts --json
    is "$(sed -n '/"recommended"/,$p' out | grep -c '"energy": 0.99999\|"energy": 1.0')" 1
    expect 0 course advise $box
    is "$(grep -c '^passive  ' out)" 2
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
