# Tests of ./course on a machine of fakes: what it understands, builds, hands over and says.

here=$(dirname "$0")
. "$here/expect.sh"
. "$here/machine.sh"

test_alone_and_with_help_it_only_talks() {
    new_machine 0
    for words in '' --help -h help 'list --help' 'setup --help'; do
        # shellcheck disable=SC2086  # no word is no argument
        expect 0 course $words
        says out './course tour'
    done
    is "$(lines calls)" 0
    [ ! -e checkout/build ] || fail 'something was built'
    have_all
    expect 7 course list
    expect 7 course list --help  # once built, the program has more to say
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
    expect 7 course run 3 -- --all --help 'two  words'  # after -- the words are the chapter's
    is "$(cat out)" 'handed over: run 3 -- --all --help two  words'
    silent_on calls chromium
}

test_unknown_words_are_refused_before_anything_is_installed() {
    new_machine 0
    expect 2 course turo
    is "$(cat err)" "course: there is no command 'turo': ./course --help shows those that there are"
    expect 2 course setup --al
    says err "course: setup: '--al': it takes --all and --yes, nothing else"
    is "$(lines calls)" 0
}

# A checkout with what the course program is made of.
make_sources() {
    mkdir -p checkout/tools/course checkout/tools/cmake checkout/include
    : >checkout/CMakeLists.txt
    : >checkout/tools/CMakeLists.txt
    : >checkout/tools/course/main.cpp
    : >checkout/include/state.hpp
}

test_only_what_is_new_is_built() {
    new_machine 0
    have_all
    make_sources
    expect 7 course list
    for file in tools/course/more.cpp include/state.hpp CMakeLists.txt tools/cmake/new.cmake tools/set_up.sh course; do
        : >calls
        touch "checkout/$file"
        expect 7 course list
        is "$file: $(cat calls)" "$file: cmake --build $folder/checkout/build --target course"
        is "$(cat err)" 'course: bringing the course program up to date; that may take half a minute'
        : >calls
        expect 7 course list
        is "$(lines calls)" 0
    done
    rm checkout/tools/course/more.cpp
    expect 7 course list
    says calls '--target course'
}

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
    sleep 0.3
    expect 7 course list
    says err 'course: another ./course is building here; waiting for it'
    wait
}

test_it_works_through_a_link_from_any_folder_and_when_it_has_moved() {
    new_machine 0
    have_all
    mkdir elsewhere
    cd elsewhere || exit 1
    for place in checkout 'moved checkout'; do
        [ -e "../$place" ] || mv ../checkout "../$place"
        ln -sf "$folder/$place/course" ../bin/course_link
        expect 7 env -i PATH="$folder/bin" COURSE_PLACES="$folder/usr" ../bin/course_link list
        is "$(cat out)" 'handed over: list'
        says "$folder/calls" "cmake -S $folder/$place -B $folder/$place/build -D TIMESTEP_COURSE=ON --fresh"
    done
}

test_an_interrupted_configuration_begins_afresh() {
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

test_an_installed_package_makes_cmake_look_again() {
    new_machine 0
    have_all
    make_sources
    : >packages
    expect 7 course test
    touch packages
    for times in 1 0; do
        : >calls
        expect 7 course test
        is "$(grep -c -e '^cmake -S' calls)" $times
    done
}

test_a_place_where_nothing_can_be_built_is_refused() {
    new_machine 0
    have_all
    for name in ';' "$(printf 'a\nb')"; do
        mkdir "$name"
        cp -r checkout "$name"
        expect 2 env -i PATH="$folder/bin" COURSE_PLACES="$folder/usr" "$name/checkout/course" list
        is "$(lines err)" 1
        says err ': the course cannot be built here: '
    done
    is "$(lines calls)" 0
    name="it's "'$x&(!)%:=@*?`^~+{}'
    mkdir "$name"
    cp -r checkout "$name"
    expect 7 env -i PATH="$folder/bin" COURSE_PLACES="$folder/usr" sh "./$name/checkout/course" list
}

test_a_build_that_cannot_be_made_says_why() {
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
    rm build_fails
    expect 7 course list  # what failed is tried again
    rm -r checkout/build
    : >checkout/build
    expect 2 course list
    says err "$folder/checkout/build"
    is "$(lines err)" 1
}

begin "$@"
"$function"
