# The front door as learners have it: a checkout, its own build folder, the real CMake and compiler.

here=$(dirname "$0")
. "$here/expect.sh"

# Installs nothing: where something is missing, the test is skipped.
course() {
    got=0
    PATH="$folder/bin:$PATH" checkout/course "$@" >out 2>err </dev/null || got=$?
    [ $got -ne 3 ] || { cat err; exit 77; }
}

new_checkout() {
    mkdir bin checkout
    printf '#!/bin/sh\nexit 1\n' >bin/apt-get
    chmod +x bin/apt-get
    for part in course CMakeLists.txt LICENSE chapters docs engines exercises include solutions tests tools; do
        cp -r "$source/$part" checkout
    done
    room=checkout/exercises/01_derivatives
}

test_a_check_builds_what_it_needs_and_no_file_in_exercises_stops_it() {
    new_checkout
    : >$room/velocity_now_old.cpp
    ln -s me@host.1 $room/.#best_gap.cpp
    cp "$source/solutions/01_derivatives/velocity_now.cpp" $room/velocity_now.cpp
    for touched in tools/course/verdict_text.cpp include/timestep/state.hpp tools/checker/registry.cpp; do
        touch "checkout/$touched"
        course check velocity_now
        is $got 0
    done
    # By CMake alone it is the same check.
    expect 0 cmake --build checkout/build --target check_velocity_now
    says out '1.1 velocity_now: right'
    cp "$source/solutions/01_derivatives/best_gap.cpp" $room/velocity_now.cpp
    expect 1 cmake --build checkout/build --target check_velocity_now
    says out '1.1 velocity_now: does not compile'
    rm $room/velocity_now.cpp
    expect 1 cmake --build checkout/build --target check_velocity_now
    says err 'velocity_now.cpp is not there; ./course reset velocity_now brings it back'
}

begin "$@"
"$function"
