# Tests of ./course on a machine of fakes: what it looks for, asks and installs.

here=$(dirname "$0")
. "$here/expect.sh"
. "$here/machine.sh"

everything='g++ cmake ninja-build libeigen3-dev catch2 gnuplot-nox doxygen doxygen-awesome-css'
everything="$everything libjs-katex libjs-lunr libcli11-dev nlohmann-json3-dev valgrind"
panels='clang lld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32'

test_root_installs_what_is_missing_then_builds_and_hands_over() {
    new_machine 0
    expect 7 course list --json
    is "$(cat out)" 'handed over: list --json'
    says err "course: this machine lacks: $everything"
    is "$(grep 'cmake (' err)" 'course:   cmake (1.0)'
    is "$(ls tmp)" ''
    is "$(sed -n 's/^apt-get .* update$/update/p' calls)" update
    says calls "install --no-install-recommends $everything"
    says calls "cmake -S $folder/checkout -B $folder/checkout/build"
    says calls "cmake --build $folder/checkout/build --target course"
}

test_only_what_is_missing_is_installed() {
    new_machine 0
    have_all
    rm -r bin/gnuplot usr/include/CLI/CLI.hpp usr/lib/llvm-14
    expect 7 course tour
    says calls "install --no-install-recommends gnuplot-nox libcli11-dev $panels"
    # Tools from elsewhere count; a check needs no panels.
    rm -r bin/g++ usr/include/eigen3/Eigen/Core usr/lib/llvm-14
    fake clang++ ''
    mkdir -p own/include/eigen3/Eigen
    : >own/include/eigen3/Eigen/Core
    : >calls
    expect 7 env CMAKE_PREFIX_PATH="$folder/nothing:$folder/own" PATH="$folder/bin" \
        COURSE_PLACES="$folder/usr" checkout/course check velocity_now
    silent_on calls apt-get
}

test_a_tour_goes_on_where_panels_cannot_be_installed() {
    new_machine 1000
    have_all
    rm -r usr/lib/llvm-14
    expect 7 course tour
    says err "course: the site's panels stand still: you are not root, so I cannot install it."
    silent_on calls apt-get
}

test_a_cmake_that_is_too_old_is_missing() {
    new_machine 0
    have_all
    make_cmake 3.24.9
    cp cmake_3.24.9 bin/cmake
    expect 7 course tour
    says err 'course: this machine lacks: cmake'
    make_cmake 4.0.1
    cp cmake_4.0.1 bin/cmake
    expect 7 course tour
    silent_on err lacks
    # What apt-get has may be too old, too.
    cp cmake_3.24.9 bin/cmake
    echo : >apt/cmake
    : >calls
    expect 3 course tour
    says err 'course: still missing or too old: cmake (all that apt-get said: '
    silent_on calls 'cmake -S'
}

test_a_kit_needs_no_build_and_grades_with_bubblewrap() {
    new_machine 0
    mkdir -p checkout/kit
    printf '#!/bin/sh\necho "handed over: $*"\nexit 7\n' >checkout/kit/course
    chmod +x checkout/kit/course
    printf '{"processor": "%s",\n "compiler": "Clang"}\n' "$(uname -m)" >checkout/kit/kit.json
    expect 7 course setup --yes
    is "$(cat out)" 'handed over: setup --yes'
    says calls ' clang '  # it needs a compiler of the kind that it was made with
    expect 7 course grade class --trust
    silent_on err lacks
    expect 7 course grade class
    says err 'course: this machine lacks: bubblewrap'
    silent_on calls 'cmake -'
    sed -i 's/"processor": ".*"/"processor": "abacus"/' checkout/kit/kit.json
    touch checkout/course
    expect 3 course list
    says err "course: this learner's edition was made for abacus; here is $(uname -m): ask"
}

test_setup_installs_and_builds_nothing() {
    new_machine 0
    expect 0 course setup
    says err 'course: everything that is needed is there. Next: ./course tour'
    silent_on calls 'cmake -S'
    silent_on calls chromium
    expect 0 course setup --all --yes
    says err 'this machine lacks: bubblewrap libclang-rt-dev chromium chromium-driver poppler-utils clang-format python3-selenium libboost-dev libgsl-dev libsundials-dev libbullet-dev libode-dev libc++-dev libc++abi-dev nodejs g++-aarch64-linux-gnu qemu-user g++-i686-linux-gnu g++-mingw-w64-x86-64-posix wine'
    : >calls
    expect 0 course setup --all
    is "$(lines calls)" 0
}

test_without_rights_the_command_is_told() {
    new_machine 1000
    have g++
    expect 3 course tour
    says err 'course: you are not root, so I cannot install it. This command installs what is missing:'
    says err "  su -c 'apt-get update; apt-get install --yes --no-install-recommends ${everything#g++ } $panels'"
    have_sudo no
    expect 3 course tour
    says err 'course: sudo does not let me install it. This command installs what is missing:'
    says err "  sudo apt-get update; sudo apt-get install --yes --no-install-recommends ${everything#g++ }"
    silent_on calls apt-get
    [ ! -e checkout/build ] || fail 'something was built'
    rm bin/true
    have_sudo yes
    expect 7 course tour
    says calls 'sudo env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get'
}

test_without_apt_or_with_a_failing_one_the_reason_is_told() {
    new_machine 0
    : >apt_fails
    expect 3 course tour
    says err 'course: apt-get failed: Unable to fetch some archives (all that it said: '
    silent_on calls 'cmake -S'
    rm bin/apt-get bin/apt-cache
    have_all
    rm bin/gnuplot bin/doxygen
    expect 3 course tour
    says err 'course: this machine lacks what Debian calls: gnuplot-nox doxygen'
    says err 'course: There is no apt-get here to install it; install it by hand and start again'
}

# ---- Catch2 3, which Debian 12 has only among its backports ---------------------------------------

test_catch2_comes_from_the_backports_where_the_system_has_an_old_one() {
    new_machine 0
    echo 2.13.10-1 >catch2_version
    expect 7 course tour
    says err 'course: Catch2 3 comes from bookworm-backports; your list of package sources stays as it is'
    says calls "install --no-install-recommends $(echo "$everything" | sed 's/catch2 //')"
    grep 'backports' calls >backports
    says backports '-o Dir::Etc::SourceParts=-'
    says backports 'install --no-remove -t bookworm-backports catch2'
    # The source list is a file of our own, gone by now.
    own=$(sed -n 's/.*SourceList=\([^ ]*\).*/\1/p' backports | head -n 1)
    [ -n "$own" ] && [ ! -e "$own" ] || fail "the private source list $own is still there"
}

test_catch2_is_left_to_cmake_where_it_cannot_be_installed() {
    new_machine 0
    have_all
    rm usr/include/catch2/catch_all.hpp
    : >usr/include/catch2/catch.hpp  # somebody uses the old one
    echo 2.13.10-1 >catch2_version
    expect 7 course tour
    says err 'course: no package of Catch2 3 could be installed; CMake will fetch its source instead'
    silent_on calls 'install --no'
    rm -r checkout/build
    : >configure_fails
    expect 3 course tour
    says err 'course: Catch2 3 is missing here and could not be fetched. With the right to install packages, this command gets it: '
    says err "$folder/checkout/course setup"
}

# ---- On a terminal --------------------------------------------------------------------------------

# answer WORD COMMAND…: runs the command on a terminal where WORD is typed as soon as there is a question, or
# the command is over; all it says is in `out`.
answer() {
    command -v script >/dev/null || exit 77
    word=$1
    shift
    cat >on_terminal.sh <<END
env -i PATH='$folder/bin' HOME='$folder' COURSE_PLACES='$folder/usr' checkout/course $*
got=\$?
: >ended
exit \$got
END
    got=0
    rm -f ended
    : >out
    {
        until [ -e ended ] || grep -qF '[Y/n]' out; do sleep 0.1; done
        echo "$word"
        until [ -e ended ]; do sleep 0.1; done
    } | script -qec 'sh on_terminal.sh' /dev/null >out || got=$?
    : >err
}

test_on_a_terminal_it_asks_before_it_installs() {
    new_machine 0
    answer n tour
    is "$got" 3
    says out 'course: install it now with apt-get? [Y/n]'
    says out 'course: nothing was installed. This command installs what is missing:'
    is "$(lines calls)" 0
    answer '' tour
    is "$got" 7
    says calls "install --no-install-recommends $everything"
    rm bin/gnuplot checkout/build/up_to_date
    answer n tour --yes
    is "$got" 7
    silent_on out '[Y/n]'
}

begin "$@"
"$function"
