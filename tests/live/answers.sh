# Do the questions below the panels have the answers that the chapters give? A reader's settings, and what the panels say.

# The number that a panel's readout shows:  read PANEL 'LABEL' WORD...
read_off() {
    name=$1 label=$2
    shift 2
    "$programs/live_$name" "$@" | sed -n "s/^$label: \([^ ]*\).*/\1/p"
}
# By an expression of awk, with the numbers as a, b and c:  holds 'a > 2 * b' NUMBER...
holds() {
    awk -v "a=$2" -v "b=$3" -v "c=$4" "BEGIN { exit !(a != \"\" && ($1)) }" || fail "$1 does not hold of $2 $3 $4"
}
# blows_up PANEL METHOD WORD...
blows_up() {
    name=$1 method=$2
    shift 2
    "$programs/live_$name" "$@" | grep -q "^$method blew up"
}

test_the_end_of_the_chord_sets_the_step() {
    is "$(read_off tangent_and_chord 'slope of the chord' grab=1.287,0.376 drag=1.6,0.1)" "$(read_off tangent_and_chord 'slope of the chord' h=0.8)"
    is "$(read_off tangent_and_chord 'of the tangent' grab=0.8,0.6 drag=1.25,0.1)" "$(read_off tangent_and_chord 'of the tangent' t=1.25)"
}

test_luck_is_gone_at_the_next_point() {
    holds 'a < 1e-10 && b > 1e-9' "$(read_off tangent_and_chord forward h=1e-8 t=0.8)" "$(read_off tangent_and_chord forward h=1e-8 t=0.81)"
    holds 'a / b > 1.9 && a / b < 2.1' "$(read_off tangent_and_chord forward h=1e-3)" "$(read_off tangent_and_chord forward h=5e-4)"
}

test_no_method_cures_a_variable_step() {
    holds 'a > 5' "$(read_off frame_rate 'variable time step' method=1 rate=10 hitch=250)"
    holds 'a > 10 * b' "$(read_off frame_rate 'variable time step' method=2 rate=10 hitch=250)" "$(read_off frame_rate 'variable time step' method=2 rate=10 hitch=50)"
    for method in 0 1 2; do
        holds 'a == b' "$(read_off frame_rate 'fixed time step' "method=$method" rate=10 hitch=250)" "$(read_off frame_rate 'fixed time step' "method=$method" rate=60)"
    done
}

test_the_green_circle_breaks_at_two() {
    holds 'a < 20 && b > 100' "$(read_off three_eulers 'semi-implicit Euler' omega_h=1.99 steps=2000)" "$(read_off three_eulers 'semi-implicit Euler' omega_h=2 steps=300)"
    blows_up three_eulers 'semi-implicit Euler' omega_h=2.01 steps=300 || fail 'it does not blow up above two'
    holds 'a > 1.005' "$(read_off three_eulers 'explicit Euler' omega_h=0.01 steps=200)"
}

test_the_green_cloud_keeps_its_area() {
    area() { read_off three_eulers "$1" cloud=1 "omega_h=$2" "steps=$3"; }
    near() { holds 'a / b > 0.9999 && a / b < 1.0001' "$1" "$2"; }
    near "$(area 'explicit Euler' 0.5 4)" "$(awk 'BEGIN { print 1.25 ^ 4 }')"
    near "$(area 'implicit Euler' 0.5 4)" "$(awk 'BEGIN { print 1.25 ^ -4 }')"
    for omega_h in 0.05 0.5 1.5 1.99; do near "$(area 'semi-implicit Euler' "$omega_h" 200)" 1; done
    holds 'a > 1.005' "$(area 'explicit Euler' 0.01 200)"
}

test_less_damping_calms() {
    holds 'a >= 1.4 && b < 1.4' "$(read_off damping 'old velocity' zeta=0.36)" "$(read_off damping 'old velocity' zeta=0.37)"
    holds 'a < b && b < c' "$(read_off damping 'new velocity' zeta=0)" "$(read_off damping 'new velocity' zeta=1)" "$(read_off damping 'new velocity' zeta=2)"
}

test_another_step_lets_the_rope_go_anew() {
    holds 'a == b && a < 1' "$(read_off rope Verlet sweeps=1 steps=300 cuts=8 steps=60)" "$(read_off rope Verlet sweeps=1 cuts=8 steps=60)"
    holds 'a == b' "$(read_off rope Verlet sweeps=8 steps=300 changes=1 steps=60)" "$(read_off rope Verlet sweeps=8 changes=1 steps=60)"
}

test_small_steps_stiffen_most() {
    holds 'a > 4 * b' "$(read_off rope Verlet sweeps=8 cuts=1 steps=600)" "$(read_off rope Verlet sweeps=1 cuts=8 steps=600)"
}

# What leaps pulls at its links.
test_a_shorter_step_kicks_verlet() {
    holds 'a > 5 * b' "$(read_off rope Verlet sweeps=8 changes=1 steps=120)" "$(read_off rope 'corrected for Δt' sweeps=8 changes=1 steps=120)"
    holds 'a > 2 * b' "$(read_off rope 'corrected for Δt' sweeps=1 changes=1 steps=480)" "$(read_off rope Verlet sweeps=1 changes=1 steps=480)"
}

test_the_cloth_tears_by_itself() {
    holds 'a > 0' "$(read_off cloth 'torn links' sweeps=1 wind=20 steps=60)"
    holds 'a == 0 && b == 0' "$(read_off cloth 'torn links' sweeps=8 wind=20 steps=1200)" "$(read_off cloth 'torn links' steps=1200)"
}

test_the_box_without_a_touch() {
    holds 'a < 1e-9' "$(read_off tumble exact touch=0 steps=3600 | awk '{ print ($1 - 1) ^ 2 }')"
    holds 'a > 10 && b > 1.5' "$(read_off tumble explicit touch=0 steps=2400)" "$(read_off tumble 'momentum, lagged inertia' touch=0 steps=3600)"
    holds 'a < 0.5 && b < 0.95' "$(read_off tumble 'one Newton step' touch=0 steps=3600)" "$(read_off tumble passive touch=0 steps=3600)"
}

test_the_capsule_on_its_end() {
    holds 'a > 0.1' "$(read_off capsule dropped steps=600 rolling=0.3 steps=600)"
    holds 'a < 1e-3' "$(read_off capsule dropped steps=600 spinning=0.1 steps=600)"
    holds 'a == 0 && b == 0' "$(read_off capsule dropped rolling=0.3 steps=1200)" "$(read_off capsule dropped arms=1 steps=1200)"
    holds 'a == 0 && b == 0 && c == 0' "$(read_off capsule 'one Newton step' steps=1200)" "$(read_off capsule passive steps=1200)" "$(read_off capsule 'calm half-step' steps=1200)"
    holds 'a > 0.01 && a < 0.2' "$(read_off capsule passive rolling=0 steps=2400)"
}

test_the_dropped_capsule() {
    holds 'a > 1 && b > 1' "$(read_off capsule passive start=1 steps=1200)" "$(read_off capsule 'momentum, lagged inertia' start=1 steps=1200)"
    holds 'a < 1 && b == 0' "$(read_off capsule dropped start=1 steps=1200)" "$(read_off capsule 'one Newton step' start=1 steps=1200)"
    holds 'a > 1 && b == 0 && c == 0' "$(read_off capsule 'calm half-step' start=1 place=0 steps=1200)" \
        "$(read_off capsule 'calm half-step' start=1 place=1 steps=1200)" "$(read_off capsule passive start=1 arms=1 steps=1200)"
    is "$(read_off capsule 'calm half-step' start=1 place=2 steps=1200)" 0
}

test_more_damping_blows_up() {
    ! blows_up blow_up 'semi-implicit Euler' steps=600 || fail 'it blows up as it stands'
    blows_up blow_up 'semi-implicit Euler' c=40 steps=600 || fail 'a damper does not blow it up'
    holds 'a < 50 && b > 100' "$(read_off blow_up 'Runge-Kutta 4' steps=60)" "$(read_off blow_up 'semi-implicit Euler' steps=60)"
    "$programs/live_blow_up" rate=240 steps=2000 >said
    is "$(grep -c 'blew up' said)" 1
    says said 'explicit Euler blew up'
}

test_the_floor_of_the_race() {
    is "$(read_off race 'Runge-Kutta 4' wanted=1e-13 steps=200)" inf
    "$programs/live_race" wanted=0.01 steps=200 >said
    holds 'a < b' "$(sed -n 's/^Runge-Kutta 4: \([^ ]*\).*/\1/p' said)" "$(sed -n 's/^velocity Verlet: \([^ ]*\).*/\1/p' said)"
}

# How far down the picture six times half the step lead Runge-Kutta 4's dots, px. A decade has 23.9.
test_a_jump_takes_the_order_away() {
    fall() {
        "$programs/live_race" clock=2 "scene=$1" steps=100 --still race.svg >said
        grep -o '<circle [^>]*#7a4a1e' race.svg | sed -n 's/.* cy="\([^"]*\)".*/\1/p' | awk 'NR == 1 { a = $1 } NR == 7 { print $1 - a }'
    }
    holds 'a > 23.9 * 6 * 1.1 && b < 23.9 * 6 * 0.5' "$(fall 0)" "$(fall 1)"
}

# Solvers of the boxes: 0 one Newton step, 1 passive, 2 half-step Jacobian, 3 calm half-step, 4 ball and remainder 4.
boxes() { read_off many_bodies "$1" "solver=$2" "spin=$3" count=200 "steps=$4"; }

test_boxes_that_spin_fast() {
    holds 'a > 99.9 && a < 100.1' "$(boxes 'mean energy' 3 60 600)"
    holds 'a < 95 && b < 95' "$(boxes 'mean energy' 1 60 600)" "$(boxes 'mean energy' 0 60 600)"
    holds 'a > 95 && a < 105' "$(boxes 'mean energy' 2 60 600)"
    is "$(boxes 'have gained a tenth' 1 60 600)" 0
    blows_up many_bodies explicit solver=5 spin=60 steps=600 || fail 'explicit does not blow up'
}

test_boxes_that_point_where_they_should() {
    off() { boxes 'off by half a radian' "$@"; }
    holds 'a == 0 && b == 0 && c == 0' "$(off 4 15 3600)" "$(off 4 30 3600)" "$(off 4 60 3600)"
    holds 'a > 80 && b > 80 && c > 80' "$(off 2 60 600)" "$(off 3 60 600)" "$(off 1 60 600)"
    holds 'a == 0 && b > 20 && c > 80' "$(off 2 15 120)" "$(off 2 15 600)" "$(off 2 15 3600)"
    is "$(boxes 'have lost a tenth' 2 15 3600)" 0
}

. "$(dirname "$0")/../tools/expect.sh"
programs=$4
begin "$@"
"$function"
