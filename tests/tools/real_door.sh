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
    for part in course CMakeLists.txt LICENSE chapters docs exercises include solutions tests tools; do
        cp -r "$source/$part" checkout
    done
    room=checkout/exercises/01_derivatives
    cp "$source/solutions/01_derivatives/velocity_now.cpp" solved.cpp
}

# builds NUMBER WORDS…: ./course WORDS runs the build tool so often.
builds() {
    number=$1
    shift
    : >calls
    course "$@"
    is "$* $(lines calls)" "$* $number"
}

# With the real build tool, counted (but for what CMake itself asks it, and tries out).
test_a_check_is_at_most_one_build() {
    new_checkout
    ninja=$(command -v ninja) || exit 77
    cat >bin/ninja <<END
#!/bin/sh
case " \$* " in *' --version '* | *' -t '* | *' cmTC_'*) ;; *) echo "\$*" >>'$folder/calls' ;; esac
exec '$ninja' "\$@"
END
    chmod +x bin/ninja
    builds 1 check velocity_now
    is $got 1
    says out 'not started'
    builds 0 check velocity_now
    cp solved.cpp $room/velocity_now.cpp
    builds 0 check velocity_now
    is $got 0
    builds 1 check 1.2
    for file in tools/course/verdict_text.cpp tools/cmake/found.cmake include/timestep/state.hpp; do
        touch "checkout/$file"
        builds 1 check velocity_now
        is $got 0
        builds 0 check velocity_now
    done
    touch checkout/tools/checker/registry.cpp
    builds 1 check velocity_now
    touch checkout/tools/checker/registry.cpp checkout/tools/course/verdict_text.cpp
    builds 2 check  # what has been begun, the course program finds out
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

test_no_file_in_exercises_stops_a_command() {
    new_checkout
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
