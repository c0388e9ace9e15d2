# The learner's edition, made from the site and the exercises that the build has ready.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

make_kit() {
    FIXTURE_SOURCE=$checkout FIXTURE_BUILD=$real_build FIXTURE_CMAKE=true FIXTURE_CTEST=false \
        "$program" kit "$@"
}

# refused WORDS COMMAND…: with status 2, in one line with these words.
refused() {
    words=$1
    shift
    expect 2 "$@"
    is "$(grep -vc '^Building' err)" 1
    says err "$words"
}

# The one archive of the site holds what lies unpacked beside it, where it can be looked at.
open_archive() {
    mkdir unpacked
    (cd unpacked && cmake -E tar xf ../kit/site/take_home.zip) || fail 'take_home.zip cannot be unpacked'
    diff -r unpacked/take_home kit/site/take_home || fail 'take_home.zip holds something else'
    is "$(ls -A unpacked)" take_home
    rm kit/site/take_home.zip
}

velocity_now=exercises/01_derivatives/velocity_now.cpp
solved() { cp "$source/solutions/01_derivatives/velocity_now.cpp" "$1/$velocity_now"; }

test_it_holds_nothing_of_the_tests_and_the_solutions() {
    # The teacher's own copy is solved, and remembers it.
    mkdir -p teacher/.progress
    for part in "$source"/*; do
        [ "${part##*/}" = exercises ] || ln -s "$part" teacher
    done
    ln -s "$source/.gitignore" teacher
    cp -r "$source/exercises" teacher
    solved teacher
    printf 'velocity_now\tpassed\t0\n' >teacher/.progress/exercises.tsv
    checkout=$folder/teacher
    expect 0 make_kit kit
    says out 'no solution'
    open_archive
    "$leaks" "$source" kit || fail 'a leak'
    found=$(cd kit && find . -name 'mistakes*' -o -name 'correct.cpp' -o -name 'properties*' \
        -o -name tests -o -name solutions -o -name '.git' -o -name '.ci' -o -name .progress -o -name self_test)
    is "$found" ''
    is "$(find kit/exercises -type f | xargs grep -L 'return not_started;')" ''
    is "$(find kit/exercises -type f | wc -l)" "$(find "$source/solutions" -type f | wc -l)"
    is "$(nm kit/kit/check 2>&1 | grep -c ' T ')" 0
    # All sources that git knows are there: a new file, too. (The colours of dark pages are for the site alone.)
    git -C "$source" ls-files chapters include tools/bench tools/course tools/cmake tools/figures tools/lab \
        ':!:*/.*' ':!:tools/figures/dark.tsv' >files || return 0
    while read -r file; do
        cmp -s "$source/$file" "kit/$file" || fail "$file is not in the kit"
    done <files
}

# A teacher may pack the solutions. Then nothing else of what is hidden is in it.
test_with_solutions_it_shows_one_after_a_pass() {
    expect 0 make_kit kit --with-solutions
    says out 'kit/solutions'
    open_archive
    expect 1 "$leaks" "$source" kit
    is "$(grep -v -e '^kit/kit/solutions/' -e ' lines looked for in ' out)" ''
    is "$(grep -c '^kit/kit/solutions/' out)" "$(find "$source/solutions" -type f | wc -l)"
    sh kit/course --help | grep -q 'solution EXERCISE' || fail 'its help lacks solution'
    expect 1 kit/course solution velocity_now
    is "$(tail -n 1 err)" 'course: the solution is shown when your own answer has passed:  ./course check velocity_now'
    solved kit
    expect 0 kit/course check velocity_now
    says out './course solution velocity_now'
    expect 0 kit/course solution velocity_now
    says out 'return newer + (newer - older) / 2;'
    says out 'A difference that looks only backwards'  # the words why
    # An answer does not get there by including it.
    echo '#include "../../kit/solutions/01_derivatives/velocity_now.cpp"' >kit/$velocity_now
    expect 1 kit/course check velocity_now
    says out "An answer is to be one's own"
}

# Runs in the kit, with nothing of the checkout in sight; what it is to check is in ../answers.
works() {
    expect 1 ./course check velocity_now
    says out 'not started'
    cp ../answers/mistake.cpp $velocity_now
    expect 1 ./course check velocity_now --seed 1
    says out 'Hint: Velocity is asked at the newest frame'
    expect 1 ./course check velocity_now --json
    says out '"misconception":"middle"'
    expect 1 sh -c 'cmake --build build --target check_velocity_now 2>&1'
    says out 'This is the central difference'
    cp ../answers/solution.cpp $velocity_now
    expect 0 ./course check velocity_now
    silent_on out './course solution'
    expect 0 ./course check world_acceleration --file ../answers/eigen.cpp
    refused 'it has no solutions' ./course solution velocity_now
    refused 'it has no tests' ./course test --all
    refused 'it is itself what' ./course kit elsewhere
    refused 'are added to the whole course' ./course new chapter my_topic
    refused 'are added to the whole course' ./course new exercise 1 my_function
    ./course --help | grep -e 'course new' -e 'solution EXERCISE' && fail 'its help offers what it has not'
    grep -rlF "$source" build/exercises/commands.json && fail 'it knows of the checkout'
    return 0
}

test_it_works_elsewhere_without_the_checkout() {
    expect 0 make_kit kit
    mkdir "Doe, Jane" "Doe, Jane/answers"
    mv kit "Doe, Jane/a kit of ours"
    answers="Doe, Jane/answers"
    cp "$source/solutions/01_derivatives/velocity_now.cpp" "$answers/solution.cpp"
    cp "$source/solutions/05_gyroscopic/world_acceleration.cpp" "$answers/eigen.cpp"
    sh "$source/tests/exercises/variant.sh" "$real_build/exercises/generated/velocity_now_mistakes.hpp" middle >"$answers/mistake.cpp"
    find 'Doe, Jane' -exec touch -d '+8 hours' {} +  # as from a zip made in another time zone
    cp "$here/kit.sh" "$here/../tools/expect.sh" .
    # Where the checkout and its build are, there is nothing (nor an engine's source that lies in them).
    env -u TIMESTEP_BOX3D -u TIMESTEP_JOLT bwrap --dev-bind / / --tmpfs /mnt --bind "$folder" /mnt/home --tmpfs "$source" --tmpfs "$real_build" \
        --unshare-net --die-with-parent --chdir "/mnt/home/Doe, Jane/a kit of ours" \
        sh -c '. /mnt/home/expect.sh
               source=$1 works=$(sed -n "/^velocity_now=/p; /^refused()/,/^}/p; /^works()/,/^}/p" /mnt/home/kit.sh)
               eval "$works"
               works' works "$source"
}

test_a_chapter_runs_in_it_also_after_an_interrupted_configuration() {
    expect 0 make_kit kit
    expect 0 kit/course run 1
    says out 'Its picture: '
    [ -e kit/build/runs/01_derivatives/slopes.svg ] || fail 'no picture'
    [ ! -e kit/build/chapters/derivatives_study ] || fail 'more was built than the program'
    rm kit/build/build.ninja
    expect 0 kit/course run 1
}

test_what_does_not_fit_this_machine_is_told() {
    expect 0 make_kit kit
    mkdir bin
    printf '#!/bin/sh\nexit 1\n' >bin/apt-get
    chmod +x bin/apt-get
    for change in 'compiler_version 9.1.0' 'processor abacus' 'glibc 9.99'; do
        cp "$real_build/exercises/machine.json" kit/kit/kit.json
        sed -i "s/\"${change% *}\": \".*\"/\"${change% *}\": \"${change#* }\"/" kit/kit/kit.json
        rm -rf kit/build
        expect 3 env PATH="$folder/bin:$PATH" kit/course setup
        is "$(grep -v '^Looking at the compiler' err | grep -c '')" 1
        says err "this learner's edition was made for"
        says err "${change#* }"
    done
}

test_nothing_is_written_over() {
    mkdir full empty
    : >full/file
    expect 0 make_kit empty
    [ -x empty/course ] || fail 'no kit'
    refused "'full' is there; a kit goes to a new or empty folder" make_kit full
    refused 'the folder it is to be in is not there' make_kit none/kit
}

program=$4 real_build=$5 leaks=$6
begin "$@"
checkout=$source
[ -e "$real_build/site_kit/html/index.html" ] || { echo 'skipped: the site is not made'; exit 77; }
case $function in *without_the_checkout)
    bwrap --dev-bind / / true 2>/dev/null || { echo 'skipped: bubblewrap does not work here'; exit 77; } ;;
esac
case $function in *solutions*)
    command -v python3 >/dev/null || { echo 'skipped: python3 is not installed'; exit 77; } ;;
esac
! command -v ninja >/dev/null || export CMAKE_GENERATOR=Ninja
"$function"
