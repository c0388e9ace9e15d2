# Tests of ./course on a machine of fakes: what it understands, builds, hands over and says.

here=$(dirname "$0")
. "$here/expect.sh"
. "$here/machine.sh"

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
    is "$(cat err)" "course: there is no command 'turo': ./course --help shows those that there are"
    expect 2 course ''
    is "$(cat err)" "course: there is no command '': ./course --help shows those that there are"
    is "$(lines out)" 0
    expect 2 course setup --al
    says err "course: setup: '--al': it takes --all and --yes, nothing else"
    is "$(lines calls)" 0
}

# A checkout with what the course program is made of.
make_sources() {
    mkdir -p checkout/tools/course checkout/tools/cmake checkout/tools/processes checkout/include
    : >checkout/CMakeLists.txt
    : >checkout/tools/CMakeLists.txt
    : >checkout/tools/course/main.cpp
    : >checkout/include/state.hpp
}

test_with_nothing_new_it_hands_over_and_asks_nobody() {
    new_machine 0
    have_all
    have bubblewrap
    make_sources
    expect 7 course list
    for tool in cat sed grep dirname apt-cache cmake tr env flock; do
        fake $tool "echo $tool >>'$folder/calls'; exit 1"
    done
    : >calls
    # All that there are but setup.
    commands=$(/usr/bin/sed -n 's/^\(tour | .*\) | setup) ;;$/\1/p' checkout/course | /usr/bin/tr -d '|')
    case $commands in *grade*) ;; *) fail "the commands are: $commands" ;; esac
    for command in $commands; do
        expect 7 course $command 1
        is "$(/bin/cat out err)" "handed over: $command 1"
    done
    is "$(/usr/bin/wc -l <calls)" 0
}

# What shuts strangers' code away is asked for also where nothing else is new.
test_grade_asks_for_bubblewrap_though_nothing_is_new() {
    new_machine 0
    have_all
    make_sources
    expect 7 course list
    expect 7 course grade class --trust
    is "$(cat out err)" 'handed over: grade class --trust'
    expect 7 course grade class --yes
    says err 'this machine lacks: bubblewrap'
    expect 7 course grade class
    is "$(cat out err)" 'handed over: grade class'
}

test_what_is_new_is_built_first() {
    new_machine 0
    have_all
    make_sources
    expect 7 course list
    for file in tools/course/main.cpp tools/course/more.cpp include/state.hpp CMakeLists.txt \
        tools/cmake/new.cmake tools/processes/look.cpp tools/set_up.sh course; do
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

# Before it begins: a build may take its time.
test_a_build_is_told_before_it_is_waited_for() {
    new_machine 0
    have_all
    make_sources
    expect 7 course list
    touch checkout/tools/course/main.cpp
    mkdir -p checkout/tests/exercises/01_first/velocity_now
    echo '{"number": 1,' >checkout/tests/exercises/01_first/velocity_now/about.json
    cp bin/cmake bin/real_cmake
    fake cmake "cp '$folder/err' '$folder/told'; exec '$folder/bin/real_cmake' \"\$@\""
    expect 7 course hint velocity_now
    is "$(cat told)" 'course: bringing the course program up to date; that may take half a minute'
    touch checkout/tools/course/main.cpp
    expect 7 course check velocity_now
    is "$(cat told)" \
        'course: bringing the course program and the tests of velocity_now up to date; that may take half a minute'
}

# builds NUMBER TARGETS WORDS…: with something new, ./course WORDS builds so often, these targets, and tells the course
# program of those beside itself.
builds() {
    touch checkout/tools/course/main.cpp
    : >calls
    number=$1 targets=$2
    shift 2
    expect 7 course "$@"
    is "$* $(grep -c -e --build calls)" "$* $number"
    says calls "cmake --build $folder/checkout/build --target course${targets:+ $targets}"
    is "$(cat built)" "$targets"
}

test_what_a_check_needs_is_built_in_one_go_with_the_course_program() {
    new_machine 0
    have_all
    make_sources
    for room in 01_first/velocity_now 01_first/best_gap 03_third/top_step; do
        mkdir -p "checkout/tests/exercises/$room"
        echo '{"number": 1,' >"checkout/tests/exercises/$room/about.json"
    done
    echo '{"number": 2,' >checkout/tests/exercises/01_first/best_gap/about.json
    builds 1 ready_velocity_now check velocity_now
    builds 1 ready_velocity_now check --seed 1 exercises/01_first/velocity_now.cpp
    builds 1 ready_top_step check 3.1
    builds 1 ready_best_gap watch 1.2
    # What it does not know is left to the course program.
    for words in '' 1.3 7.1 '1.[' .. . '*' no_such --json; do
        builds 1 '' check "$words"
    done
    builds 1 '' hint velocity_now
    builds 1 '' list
    : >calls
    expect 7 course check velocity_now
    is "$(lines calls)" 0
    # With no build at all yet, too.
    rm -r checkout/build
    builds 1 ready_velocity_now check velocity_now
    is "$(grep -c -e '^cmake -S' calls)" 1
    : >build_fails
    touch checkout/tools/course/main.cpp
    expect 1 course check velocity_now
    says err 'course: the course program, or ready_velocity_now, could not be built'
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

test_after_two_dashes_the_words_are_the_chapters() {
    new_machine 0
    have_all
    expect 7 course run 3 -- --all --help 'two  words'
    is "$(cat out)" 'handed over: run 3 -- --all --help two  words'
    silent_on calls chromium
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

test_a_configuration_that_did_not_end_begins_afresh() {
    new_machine 0
    have_all
    make_sources
    for break in 'rm' 'truncate -s 0'; do
        expect 7 course list
        : >calls
        $break checkout/build/build.ninja
        expect 7 course list
        is "$break: $(grep -c -e '^cmake -S .* --fresh' calls)" "$break: 1"
    done
}

# Installed by setup or by hand: what CMake looks for may be there now.
test_an_installed_package_makes_cmake_look_again() {
    new_machine 0
    have_all
    make_sources
    : >packages
    expect 7 course test
    expect 0 course setup --all --yes
    for by in setup hand; do
        touch packages
        : >calls
        expect 7 course test
        is "$by: $(grep -c -e '^cmake -S' calls)" "$by: 1"
        : >calls
        expect 7 course test
        is "$by: $(grep -c -e '^cmake -S' calls)" "$by: 0"
    done
}

test_a_place_where_nothing_can_be_built_is_refused() {
    new_machine 0
    have_all
    for name in '#' '[' ']' ';' '"' '\' '<' '>' '|' 'a$(x)' '${x}' "$(printf 'a\tb')" "$(printf 'a\nb')" 'a
'; do
        mkdir "$name"
        cp -r checkout "$name"
        expect 2 env -i PATH="$folder/bin" COURSE_PLACES="$folder/usr" "$name/checkout/course" list
        is "$(lines err)" 1
        says err ': the course cannot be built here: '
        rm -r "$name"
    done
    is "$(lines calls)" 0
    for name in 'Doe, Jane' 'über uns' "it's" '$x&(!)%:=@*?`^~+{}'; do
        mkdir "$name"
        cp -r checkout "$name"
        expect 7 env -i PATH="$folder/bin" COURSE_PLACES="$folder/usr" sh "./$name/checkout/course" list
    done
}

test_files_from_the_future_are_dated_now() {
    new_machine 0
    have_all
    make_sources
    touch -d '+1 day' checkout/CMakeLists.txt checkout/tools/course/main.cpp
    expect 7 course list
    is "$(grep -c 'dated in the future; their date is set to now' err)" 1
    : >now
    is "$(find checkout -newer now)" ''
    expect 7 course list
    silent_on err future
    # A clock that was set back: what CMake wrote then it writes afresh.
    touch -d '+1 day' checkout/build/CMakeCache.txt
    touch checkout/course
    : >calls
    expect 7 course list
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
