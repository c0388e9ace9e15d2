# The front door as learners have it: a checkout, its own build folder, the real CMake and compiler.

here=$(dirname "$0")
. "$here/expect.sh"

# Installs nothing: where something is missing, the test is skipped.
course() {
    got=0
    PATH="$folder/bin:$PATH" checkout/course "$@" >out 2>err </dev/null || got=$?
    [ $got -ne 3 ] || { cat err; exit 77; }
}

test_no_file_in_exercises_stops_a_command() {
    mkdir bin checkout
    printf '#!/bin/sh\nexit 1\n' >bin/apt-get
    chmod +x bin/apt-get
    for part in course CMakeLists.txt chapters docs exercises include solutions tests tools; do
        cp -r "$source/$part" checkout
    done
    room=checkout/exercises/01_derivatives
    rm -f $room/velocity_now.cpp
    : >$room/velocity_now_old.cpp
    ln -s me@host.1 $room/.#best_gap.cpp
    course list
    is $got 0
    says out 'velocity_now'
    course check velocity_now
    is $got 2
    is "$(tail -n 1 err)" "course: $room/velocity_now.cpp is not there; ./course reset velocity_now brings it back"
    course reset velocity_now
    is $got 0
    says $room/velocity_now.cpp 'return not_started;'
    # Gone while the build is already there.
    rm $room/velocity_now.cpp
    touch checkout/CMakeLists.txt
    course reset velocity_now
    is $got 0
    says $room/velocity_now.cpp 'return not_started;'
}

begin "$@"
"$function"
