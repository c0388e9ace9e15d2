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

test_the_second_time_nothing_is_asked_of_apt() {
    new_machine 0
    have_all
    expect 7 course list
    : >calls
    touch checkout/course
    expect 7 course list
    is "$(cat calls)" "cmake --build $folder/checkout/build --target course"
    is "$(cat err)" 'course: bringing the course program up to date; that may take half a minute'
}

test_only_what_is_missing_is_installed() {
    new_machine 0
    have_all
    rm bin/gnuplot usr/include/CLI/CLI.hpp
    expect 7 course tour
    says err 'course: this machine lacks: gnuplot-nox libcli11-dev'
    says calls 'install --no-install-recommends gnuplot-nox libcli11-dev'
}


test_what_lets_panels_move_is_installed_with_the_rest() {
    new_machine 0
    have_all
    rm -r bin/gnuplot usr/lib/llvm-14
    expect 7 course tour
    says err "course: this machine lacks: gnuplot-nox $panels"
    says calls "install --no-install-recommends gnuplot-nox $panels"
    rm -r usr/lib/llvm-14
    expect 7 course check velocity_now
    silent_on err lacks
}

test_where_nothing_lets_panels_move_the_site_is_made_all_the_same() {
    new_machine 1000
    have_all
    rm -r usr/lib/llvm-14
    expect 7 course tour
    says err "course: the site's panels stand still: you are not root, so I cannot install what they need. This lets them move: apt-get install --yes --no-install-recommends $panels"
    touch checkout/course
    expect 7 course tour
    silent_on err 'stand still'
    # A system that has no such packages is not asked for them; that is said once, in one line.
    fake id 'echo 0'
    for candidate in '' '(none)'; do
        rm -r checkout/build
        fake apt-cache "case \$2 in gnuplot-nox) echo '  Candidate: 5.4' ;; *) echo '  Candidate: $candidate' ;; esac"
        expect 7 course tour
        silent_on calls apt-get
        is "$(grep -c 'stand still' err)" 1
        says err "course: the site's panels stand still: this system has no package clang"
        touch checkout/course
        expect 7 course tour
        silent_on err 'stand still'
    done
    # Nor is one without apt-get.
    rm -r checkout/build
    mv bin/apt-get bin/apt-get.not
    expect 7 course tour
    says err "course: the site's panels stand still: there is no apt-get here to install what they need, in Debian $panels"
    mv bin/apt-get.not bin/apt-get
    # One whose packages cannot be installed goes without.
    rm -r checkout/build
    fake apt-cache "echo '  Candidate: 5.4'"
    : >apt_fails
    expect 7 course tour
    says err "course: the site's panels stand still: apt-get failed. "
}

test_tools_from_elsewhere_count() {
    new_machine 0
    have_all
    rm bin/g++ usr/include/eigen3/Eigen/Core
    fake clang++ ''
    mkdir -p "own/include/eigen3/Eigen"
    : >own/include/eigen3/Eigen/Core
    expect 7 env CMAKE_PREFIX_PATH="$folder/nothing:$folder/own" PATH="$folder/bin" \
        COURSE_PLACES="$folder/usr" checkout/course tour
    silent_on calls apt-get
}

test_a_cmake_that_is_too_old_is_missing() {
    new_machine 0
    have_all
    for version in 2.8.12 3.24.9; do
        make_cmake $version
        cp cmake_$version bin/cmake
        expect 7 course tour
        says err 'course: this machine lacks: cmake'
    done
    for version in 3.25.0 3.100.0 4.0.1; do
        make_cmake $version
        cp cmake_$version bin/cmake
        expect 7 course tour
        silent_on err lacks
    done
}

test_what_is_still_too_old_after_installing_is_named() {
    new_machine 0
    have_all
    make_cmake 3.22.1
    cp cmake_3.22.1 bin/cmake
    echo : >apt/cmake
    expect 3 course tour
    says err 'course: still missing or too old: cmake (all that apt-get said: '
    silent_on calls 'cmake -S'
}

test_grading_in_a_kit_wants_no_more_than_its_setup_and_bubblewrap() {
    new_machine 0
    mkdir -p checkout/kit
    echo "{\"processor\": \"$(uname -m)\"}" >checkout/kit/kit.json
    printf '#!/bin/sh\necho "handed over: $*"\nexit 7\n' >checkout/kit/course
    chmod +x checkout/kit/course
    # What fits this machine, its course program says.
    expect 7 course setup --yes
    is "$(cat out)" 'handed over: setup --yes'
    expect 7 course grade class --trust
    silent_on err 'lacks'
    expect 7 course grade class
    says err 'course: this machine lacks: bubblewrap'
    silent_on err catch2
    # Its course program comes built.
    silent_on calls 'cmake -S'
    silent_on calls 'cmake --build'
    sed -i 's/: ".*"/: "abacus"/' checkout/kit/kit.json
    touch checkout/course
    expect 3 course list
    says err "course: this learner's edition was made for abacus; here is $(uname -m): ask"
}

test_a_kit_wants_a_compiler_of_the_kind_that_it_was_made_with() {
    new_machine 0
    have_all
    mkdir -p checkout/kit
    printf '#!/bin/sh\nexit 7\n' >checkout/kit/course
    chmod +x checkout/kit/course
    rm bin/g++
    fake clang++ ''
    for kind in 'GNU g++' 'Clang clang'; do
        printf '{"processor": "%s",\n "compiler": "%s"}\n' "$(uname -m)" "${kind% *}" >checkout/kit/kit.json
        expect 7 env -i CXX=clang++ PATH="$folder/bin" COURSE_PLACES="$folder/usr" checkout/course setup
        silent_on err lacks
        expect 7 course setup --yes
        case $kind in GNU*) says err 'course: this machine lacks: g++' ;; *) silent_on err lacks ;; esac
    done
}

test_setup_installs_and_builds_nothing() {
    new_machine 0
    expect 0 course setup
    says err 'course: everything that is needed is there. Next: ./course tour'
    silent_on calls 'cmake -S'
    silent_on calls chromium
    expect 0 course setup --all --yes
    says err 'this machine lacks: bubblewrap libclang-rt-dev chromium chromium-driver poppler-utils python3-selenium libboost-dev libgsl-dev libsundials-dev libbullet-dev libode-dev libc++-dev libc++abi-dev nodejs g++-aarch64-linux-gnu qemu-user g++-i686-linux-gnu g++-mingw-w64-x86-64-posix wine'
    : >calls
    expect 0 course setup --all
    is "$(lines calls)" 0
}

test_test_all_brings_the_extras_and_configures_again() {
    new_machine 0
    have_all
    expect 7 course test
    silent_on calls chromium
    : >calls
    expect 7 course test --all
    is "$(cat out)" 'handed over: test --all'
    says calls chromium
    says calls "cmake -S $folder/checkout"
}

test_test_release_brings_the_extras_too() {
    new_machine 0
    have_all
    expect 7 course test
    : >calls
    expect 7 course test --release
    is "$(cat out)" 'handed over: test --release'
    says calls chromium
}

test_without_root_and_sudo_the_command_is_told() {
    new_machine 1000
    have g++
    expect 3 course tour
    says err 'course: you are not root, so I cannot install it. This command installs what is missing:'
    says err "  su -c 'apt-get update; apt-get install --yes --no-install-recommends ${everything#g++ } $panels'"
    is "$(lines calls)" 0
    [ ! -e checkout/build ] || fail 'something was built'
}

test_a_sudo_that_refuses_means_the_command_is_told() {
    new_machine 1000
    have_sudo no
    expect 3 course tour
    says err 'course: sudo does not let me install it. This command installs what is missing:'
    says err "  sudo apt-get update; sudo apt-get install --yes --no-install-recommends $everything"
    silent_on calls apt-get
}

test_a_sudo_that_works_is_used() {
    new_machine 1000
    have_sudo yes
    expect 7 course tour
    says calls 'sudo env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get'
    says calls "install --no-install-recommends $everything"
}

test_without_apt_the_missing_things_are_named() {
    new_machine 1000
    have_all
    rm bin/apt-get bin/apt-cache bin/gnuplot bin/doxygen
    expect 3 course tour
    says err 'course: this machine lacks what Debian calls: gnuplot-nox doxygen'
    says err 'course: There is no apt-get here to install it; install it by hand and start again'
}

test_a_failing_apt_gives_its_reason_in_one_line() {
    new_machine 0
    : >apt_fails
    expect 3 course tour
    says err 'course: apt-get failed: Unable to fetch some archives (all that it said: '
    silent_on calls 'cmake -S'
}

# ---- Catch2 3, which Debian 12 has only among its backports ---------------------------------------

test_catch2_comes_from_the_backports_where_the_system_has_an_old_one() {
    new_machine 0
    echo 2.13.10-1 >catch2_version
    expect 7 course tour
    says err 'course: Catch2 3 comes from bookworm-backports; your list of package sources stays as it is'
    says calls "install --no-install-recommends $(echo "$everything" | sed 's/catch2 //')"
    silent_on err 'no package'
    is "$(ls tmp)" ''
    grep 'backports' calls >backports
    says backports '-o Dir::Etc::SourceParts=-'
    says backports '-o Dir::State::Lists='
    says backports 'install --no-remove -t bookworm-backports catch2'
    # The source list is a file of our own, gone by now.
    own=$(sed -n 's/.*SourceList=\([^ ]*\).*/\1/p' backports | head -n 1)
    [ -n "$own" ] && [ ! -e "$own" ] || fail "the private source list $own is still there"
}

test_an_old_catch2_in_use_stays_and_cmake_fetches_the_new_one() {
    new_machine 0
    have_all
    rm usr/include/catch2/catch_all.hpp
    : >usr/include/catch2/catch.hpp
    echo 2.13.10-1 >catch2_version
    expect 7 course tour
    says err 'course: no package of Catch2 3 could be installed; CMake will fetch its source instead'
    silent_on calls 'install'
}

test_without_rights_catch2_alone_is_left_to_cmake() {
    new_machine 1000
    have_all
    rm usr/include/catch2/catch_all.hpp
    expect 7 course tour
    says err 'course: there is no Catch2 3 here; CMake fetches its source'
    # Fetched, it is there.
    mkdir -p checkout/build/_deps/catch2-src
    : >checkout/build/_deps/catch2-src/CMakeLists.txt
    touch checkout/course
    expect 7 course list
    is "$(cat err)" 'course: bringing the course program up to date; that may take half a minute'
    # Where the fetch fails, too, the way out is named.
    rm -r checkout/build
    : >configure_fails
    expect 3 course tour
    says err 'course: Catch2 3 is missing here and could not be fetched. With the right to install packages, this command gets it: '
    says err "$folder/checkout/course setup"
}

test_the_command_told_leaves_out_a_catch2_that_is_too_old() {
    new_machine 1000
    echo 2.13.10-1 >catch2_version
    expect 3 course tour
    says err 'libeigen3-dev gnuplot-nox'
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
    : >out
    {
        for _ in $(seq 6000); do
            [ ! -e ended ] && ! grep -qF '[Y/n]' out || break
            sleep 0.1
        done
        echo "$word"
        for _ in $(seq 6000); do
            [ ! -e ended ] || break
            sleep 0.1
        done
    } | script -qec 'sh on_terminal.sh' /dev/null >out || got=$?
    : >err
}

test_no_on_a_terminal_installs_nothing_and_tells_the_command() {
    new_machine 0
    answer n tour
    is "$got" 3
    says out 'course: install it now with apt-get? [Y/n]'
    says out 'course: nothing was installed. This command installs what is missing:'
    is "$(lines calls)" 0
}

test_yes_on_a_terminal_installs() {
    new_machine 0
    answer '' tour
    is "$got" 7
    says calls "install --no-install-recommends $everything"
}

test_with_yes_nothing_is_asked_on_a_terminal() {
    new_machine 0
    answer n tour --yes
    is "$got" 7
    silent_on out '[Y/n]'
}

begin "$@"
"$function"
