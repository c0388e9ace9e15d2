# Tests of ./course on a machine of stand-ins: what it looks for, asks, installs, builds and says.

here=$(dirname "$0")
. "$here/expect.sh"
. "$here/machine.sh"

everything='g++ cmake ninja-build libeigen3-dev catch2 gnuplot-nox doxygen doxygen-awesome-css'
everything="$everything libjs-katex libcli11-dev nlohmann-json3-dev"

test_alone_and_help_only_talk() {
    new_machine 0
    for word in '' --help -h help; do
        # shellcheck disable=SC2086  # no word is no argument
        expect 0 course $word
        says out './course tour'
    done
    for command in tour test list run site setup; do
        says out "./course $command"
        expect 0 course $command --help
        says out './course tour'
    done
    is "$(lines calls)" 0
    [ ! -e checkout/build ] || fail 'something was built'
    have_all
    expect 7 course list
    expect 0 course setup --help
    says out './course tour'
    expect 7 course list --help  # built, the program has more to say
}

test_every_command_that_the_help_names_is_handed_over() {
    new_machine 0
    have_all
    course --help | grep -o '^  ./course [a-z]*' | sed 's|.* ||' | grep -v setup >commands
    echo solution >>commands  # which stands in the line of hint
    [ "$(lines commands)" -gt 10 ] || fail 'the help names too few'
    while read -r command; do
        expect 7 course "$command" 1
        is "$(cat out)" "handed over: $command 1"
    done <commands
}

test_unknown_words_are_refused_before_anything_is_installed() {
    new_machine 0
    expect 2 course turo
    says err "course: there is no command 'turo'"
    expect 2 course ''
    is "$(cat err)" "course: there is no command '': ./course --help shows those that there are"
    is "$(lines out)" 0
    expect 2 course setup --al
    says err "course: setup: '--al': it takes --all and --yes, nothing else"
    is "$(lines calls)" 0
}

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

# A checkout with what the course program is made of.
make_sources() {
    mkdir -p checkout/tools/course checkout/tools/cmake checkout/include
    : >checkout/CMakeLists.txt
    : >checkout/tools/CMakeLists.txt
    : >checkout/tools/course/main.cpp
    : >checkout/include/state.hpp
}

test_with_nothing_new_it_hands_over_and_asks_nobody() {
    new_machine 0
    have_all
    make_sources
    expect 7 course list
    for tool in cat sed grep dirname apt-cache cmake tr env flock; do
        stand_in $tool "echo $tool >>'$folder/calls'; exit 1"
    done
    : >calls
    for command in tour list run check watch hint solution reset advise bench site kit test; do
        expect 7 course $command 1
        is "$(/bin/cat out err)" "handed over: $command 1"
    done
    is "$(/usr/bin/wc -l <calls)" 0
}

test_what_is_new_is_built_first() {
    new_machine 0
    have_all
    make_sources
    expect 7 course list
    for file in tools/course/main.cpp tools/course/more.cpp include/state.hpp CMakeLists.txt \
        tools/cmake/new.cmake course; do
        : >calls
        touch "checkout/$file"
        expect 7 course list
        is "$file: $(cat calls)" "$file: cmake --build $folder/checkout/build --target course"
        : >calls
        expect 7 course list
        is "$(lines calls)" 0
    done
    : >calls
    rm checkout/tools/course/more.cpp
    expect 7 course list
    says calls '--target course'
    : >calls
    cp -p checkout/tools/CMakeLists.txt old
    mv old checkout/tools/course/old.cpp  # old, and new here
    expect 7 course list
    says calls '--target course'
    # What failed is not taken for done.
    touch checkout/tools/course/main.cpp
    : >build_fails
    expect 1 course list
    rm build_fails
    : >calls
    expect 7 course list
    says calls '--target course'
}

test_the_first_chapter_comes_before_the_course_program() {
    new_machine 0
    have_all
    expect 7 course tour
    says err "course: chapter 1 can be read: file://$folder/checkout/build/site/html/chapter_01.html"
    is "$(grep -n -e '--target first_chapter' calls | cut -d: -f1)" 2
    mkdir -p checkout/build/site/html
    : >checkout/build/site/html/index.html
    touch checkout/course
    : >calls
    expect 7 course tour
    silent_on calls '--target first_chapter'
}

test_two_at_once_in_a_build_folder_take_turns() {
    new_machine 0
    have_all
    command -v flock >/dev/null || exit 77
    mkdir -p checkout/build
    flock checkout/build/course.lock sleep 2 &
    while ! flock --nonblock checkout/build/course.lock true; do break; done
    sleep 0.3
    expect 7 course list
    says err 'course: another ./course is building here; waiting for it'
    wait
}

test_the_second_time_nothing_is_asked_of_apt() {
    new_machine 0
    have_all
    expect 7 course list
    : >calls
    touch checkout/course
    expect 7 course list
    is "$(cat calls)" "cmake --build $folder/checkout/build --target course"
    is "$(lines err)" 0
}

test_only_what_is_missing_is_installed() {
    new_machine 0
    have_all
    rm bin/gnuplot usr/include/CLI/CLI.hpp
    expect 7 course tour
    says err 'course: this machine lacks: gnuplot-nox libcli11-dev'
    says calls 'install --no-install-recommends gnuplot-nox libcli11-dev'
}

test_tools_from_elsewhere_count() {
    new_machine 0
    have_all
    rm bin/g++ usr/include/eigen3/Eigen/Core
    stand_in clang++ ''
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
    expect 0 course setup --yes
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

test_setup_installs_and_builds_nothing() {
    new_machine 0
    expect 0 course setup
    says err 'course: everything that is needed is there. Next: ./course tour'
    silent_on calls 'cmake -S'
    silent_on calls valgrind
    expect 0 course setup --all --yes
    says err 'this machine lacks: bubblewrap clang libclang-rt-dev valgrind chromium chromium-driver python3-selenium libboost-dev libgsl-dev libsundials-dev libbullet-dev libode-dev'
    : >calls
    expect 0 course setup --all
    is "$(lines calls)" 0
}

test_test_all_brings_the_extras_and_configures_again() {
    new_machine 0
    have_all
    expect 7 course test
    silent_on calls valgrind
    : >calls
    expect 7 course test --all
    is "$(cat out)" 'handed over: test --all'
    says calls valgrind
    says calls "cmake -S $folder/checkout"
}

test_after_two_dashes_the_words_are_the_chapters() {
    new_machine 0
    have_all
    expect 7 course run 3 -- --all --help 'two  words'
    is "$(cat out)" 'handed over: run 3 -- --all --help two  words'
    silent_on calls valgrind
}

test_without_root_and_sudo_the_command_is_told() {
    new_machine 1000
    have g++
    expect 3 course tour
    says err 'course: you are not root, so I cannot install it. This command installs what is missing:'
    says err "  su -c 'apt-get update; apt-get install --yes --no-install-recommends ${everything#g++ }'"
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
    is "$(lines err)" 0
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

# ---- Building -------------------------------------------------------------------------------------

test_it_works_through_a_link_and_from_any_folder() {
    new_machine 0
    have_all
    ln -s "$folder/checkout/course" bin/course_link
    mkdir elsewhere
    cd elsewhere || exit 1
    expect 7 env -i PATH="$folder/bin" COURSE_PLACES="$folder/usr" ../bin/course_link list
    is "$(cat out)" 'handed over: list'
    says "$folder/calls" "cmake -S $folder/checkout -B $folder/checkout/build"
}

test_a_checkout_that_has_moved_is_configured_afresh() {
    new_machine 0
    have_all
    expect 7 course list
    : >calls
    mv checkout 'moved checkout'
    expect 7 env -i PATH="$folder/bin" COURSE_PLACES="$folder/usr" 'moved checkout/course' list
    says calls "cmake -S $folder/moved checkout -B $folder/moved checkout/build"
    says calls --fresh
}

test_a_failing_configuration_or_build_shows_why() {
    new_machine 0
    have_all
    : >configure_fails
    expect 3 course list
    says err 'CMake Error: no'
    says err "course: CMake could not configure the build (all that was said: $folder/checkout/build/"
    rm configure_fails
    : >build_fails
    expect 1 course list
    says err 'error: no'
    says err 'course: the course program could not be built (all that was said: '
}

test_a_build_folder_that_cannot_be_made_is_named() {
    new_machine 0
    have_all
    : >checkout/build
    expect 2 course list
    says err "$folder/checkout/build"
    is "$(lines err)" 1
}

begin "$@"
"$function"
