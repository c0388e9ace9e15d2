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

test_it_holds_nothing_of_the_tests_and_the_solutions() {
    # The teacher's own copy is solved, and remembers it.
    mkdir -p teacher/.progress
    for part in "$source"/*; do
        [ "${part##*/}" = exercises ] || ln -s "$part" teacher
    done
    ln -s "$source/.gitignore" teacher
    cp -r "$source/exercises" teacher
    cp "$source/solutions/01_derivatives/velocity_now.cpp" teacher/exercises/01_derivatives
    printf 'velocity_now\tpassed\t0\n' >teacher/.progress/exercises.tsv
    checkout=$folder/teacher
    expect 0 make_kit kit
    "$leaks" "$source" kit || fail 'a leak'
    found=$(cd kit && find . -name 'mistakes*' -o -name 'correct.cpp' -o -name 'properties*' \
        -o -name tests -o -name solutions -o -name '.git' -o -name '.ci' -o -name .progress -o -name self_test)
    is "$found" ''
    is "$(find kit/exercises -type f | xargs grep -L 'return not_started;')" ''
    is "$(find kit/exercises -type f | wc -l)" "$(find "$source/solutions" -type f | wc -l)"
    is "$(nm kit/kit/check 2>&1 | grep -c ' T ')" 0
}

# A teacher may pack the solutions. Then nothing else of what is hidden is in it.
test_with_solutions_it_shows_one_after_a_pass() {
    expect 0 make_kit kit --with-solutions
    says out 'kit/solutions'
    says out 'after a pass'
    expect 1 "$leaks" "$source" kit
    is "$(grep -v -e '^kit/kit/solutions/' -e ' lines looked for in ' out)" ''
    is "$(grep -c '^kit/kit/solutions/' out)" "$(find "$source/solutions" -type f | wc -l)"
    is "$(find kit/exercises -type f | xargs grep -L 'return not_started;')" ''
    sh kit/course --help | grep -q 'solution EXERCISE' || fail 'its help lacks solution'
    cd kit
    course() {
        FIXTURE_SOURCE=$PWD FIXTURE_BUILD=$PWD/build FIXTURE_CMAKE=cmake FIXTURE_CTEST=ctest "$program" "$@"
    }
    file=exercises/01_derivatives/velocity_now.cpp
    expect 1 course solution velocity_now
    is "$(cat err)" 'course: the solution is shown when your own answer has passed:  ./course check velocity_now'
    is "$(lines out)" 0
    expect 0 course reset velocity_now
    cp "$source/solutions/01_derivatives/velocity_now.cpp" $file
    expect 0 course check velocity_now
    says out './course solution velocity_now'
    expect 0 course solution velocity_now
    says out "The course's"
    says out 'return newer + (newer - older) / 2;'
    silent_on out '[answer]'
    says out 'A difference that looks only backwards'  # the words why
    # An answer does not get there by including it.
    echo '#include "../../kit/solutions/01_derivatives/velocity_now.cpp"' >$file
    expect 1 course check velocity_now
    says out "An answer is to be one's own"
}

test_without_them_it_says_so() {
    expect 0 make_kit kit
    [ ! -e kit/kit/solutions ] || fail 'it has solutions'
    sh kit/course --help | grep 'solution EXERCISE' && fail 'its help offers solution'
    says out 'no solution'
}

# A kit that is mended, or a newer one in its place: what was graded by the old one is graded again.
test_a_mended_kit_grades_anew() {
    bwrap --ro-bind / / --unshare-all true 2>/dev/null || exit 77
    expect 0 make_kit kit
    mkdir -p class/ada class/ben
    cp "$source/solutions/01_derivatives/velocity_now.cpp" class/ada
    cp kit/exercises/01_derivatives/velocity_now.cpp class/ben
    grade() {
        expect 1 env FIXTURE_SOURCE="$folder/kit" FIXTURE_BUILD="$folder/kit/build" FIXTURE_CMAKE=cmake \
            FIXTURE_CTEST=ctest "$program" grade class
        says out '1 of 2 right'
    }
    grade
    grade
    says err ' 2 were graded before'
    for part in check libtimestep_worker.a workers/velocity_now_worker.o generated/velocity_now_mistakes.json \
        about/01_derivatives/velocity_now/about.json; do
        echo >>"kit/kit/$part"
        grade
        silent_on err 'graded before'
        grade
        says err ' 2 were graded before'
    done
}

test_a_new_file_is_in_the_next_one() {
    git -C "$source" ls-files chapters include tools/bench tools/course tools/cmake tools/figures \
        tools/processes >files
    [ -s files ] || exit 77
    expect 0 make_kit kit
    while read -r file; do
        cmp -s "$source/$file" "kit/$file" || fail "$file is not in the kit"
    done <files
}

# Runs in the kit, with nothing of the checkout in sight; what it is to check is in ../answers.
works() {
    cmake -S . -B build >said 2>&1 || { cat said; fail 'it cannot be configured'; }
    course() {
        FIXTURE_SOURCE=$PWD FIXTURE_BUILD=$PWD/build FIXTURE_CMAKE=cmake FIXTURE_CTEST=ctest \
            ../course_with_fakes "$@"
    }
    file=exercises/01_derivatives/velocity_now.cpp
    expect 1 course check velocity_now
    says out 'not started'
    cp ../answers/mistake.cpp $file
    expect 1 course check velocity_now --seed 1
    says out 'This is the central difference'
    says out 'Hint: Velocity is asked at the newest frame'
    expect 1 course check velocity_now --json
    says out '"misconception":"middle"'
    expect 1 sh -c 'cmake --build build --target check_velocity_now 2>&1'
    says out 'This is the central difference'
    cp ../answers/solution.cpp $file
    expect 0 course check velocity_now
    says out 'right'
    silent_on out './course solution'
    expect 0 cmake --build build --target check_velocity_now
    expect 0 course check world_acceleration --file ../answers/eigen.cpp
    expect 0 course list
    says out '1 of '
    expect 0 course hint velocity_now
    expect 0 course reset velocity_now
    cmp -s $file build/exercises/generated/velocity_now_stub.cpp || fail 'reset'
    expect 0 course site
    [ -e site/index.html ] || fail 'no site'
    refused 'it has no solutions' course solution velocity_now
    refused 'it has no tests' course test
    refused 'it has no tests' sh ./course test --all
    refused 'it is itself what' sh ./course kit elsewhere
    refused 'are added to the whole course' course new chapter my_topic
    refused 'are added to the whole course' sh ./course new exercise 1 my_function
    sh ./course --help | grep 'course new' && fail 'its help offers new'
    refused 'it has no solutions' course bench latency
    grep -rlF "$source" build/exercises/commands.json && fail 'it knows of the checkout'
    return 0
}

test_it_works_elsewhere_without_the_checkout() {
    expect 0 make_kit kit
    mkdir "some folder" "some folder/answers"
    mv kit "some folder/a kit of ours"
    cp "$program" "some folder/course_with_fakes"
    answers="some folder/answers"
    cp "$source/solutions/01_derivatives/velocity_now.cpp" "$answers/solution.cpp"
    cp "$source/solutions/05_gyroscopic/world_acceleration.cpp" "$answers/eigen.cpp"
    sh "$source/tests/exercises/variant.sh" "$real_build/exercises/generated/velocity_now_mistakes.hpp" middle >"$answers/mistake.cpp"
    cp "$here/kit.sh" "$here/../tools/expect.sh" .
    # Where the checkout and its build are, there is nothing (nor an engine's source that lies in
    # them); the folder has another name.
    env -u TIMESTEP_BOX3D -u TIMESTEP_JOLT bwrap --dev-bind / / --tmpfs /mnt --bind "$folder" /mnt/home --tmpfs "$source" --tmpfs "$real_build" \
        --unshare-net --die-with-parent --chdir "/mnt/home/some folder/a kit of ours" \
        sh -c '. /mnt/home/expect.sh
               source=$1 works=$(sed -n "/^refused()/,/^}/p; /^works()/,/^}/p" /mnt/home/kit.sh)
               eval "$works"
               works' works "$source"
}

test_its_course_program_comes_built() {
    expect 0 make_kit "a kit"
    mkdir bin
    for tool in cmake c++ g++ ninja; do
        printf '#!/bin/sh\n[ "$1" != --version ] || { echo cmake version 3.25.1; exit; }\necho %s; exit 1\n' $tool >bin/$tool
        chmod +x bin/$tool
    done
    kit_course() { PATH="$folder/bin:$PATH" "a kit/course" "$@"; }
    expect 0 kit_course list
    says out 'velocity_now'
    expect 0 kit_course hint velocity_now
    expect 0 kit_course site
    says out "$(printf '%s' "$folder/a kit/site/index.html" | sed 's/ /%20/g')"
    [ ! -e 'a kit/build/CMakeCache.txt' ] || fail 'something was configured'
    # Where it is now, it is.
    mv 'a kit' 'another place'
    expect 0 'another place/course' site
    says out 'another%20place/site/index.html'
}

test_a_chapter_runs_in_it() {
    expect 0 make_kit kit
    expect 0 kit/course run 1
    says out 'Its picture: '
    [ -e kit/build/runs/01_derivatives/slopes.svg ] || fail 'no picture'
    [ ! -e kit/build/chapters/derivatives_study ] || fail 'more was built than the program'
    expect 0 kit/course run 1 --study
    says out 'Data, numbers and figures: '
    [ -e kit/build/runs/01_derivatives/numbers.tsv ] || fail 'no numbers'
}

test_its_first_check_makes_ready_what_it_needs() {
    expect 0 make_kit kit
    expect 1 kit/course check velocity_now
    says out 'not started'
    cp "$source/solutions/01_derivatives/velocity_now.cpp" kit/exercises/01_derivatives
    expect 0 kit/course check velocity_now
    says out 'right'
}

test_a_configuration_that_did_not_end_begins_afresh() {
    expect 0 make_kit kit
    expect 3 env CXX="$folder/no_compiler" kit/course check velocity_now
    expect 1 kit/course check velocity_now
    says out 'not started'
    rm -r kit/build/exercises/found_ready kit/build/build.ninja
    expect 1 kit/course check velocity_now
    says out 'not started'
}

test_it_works_in_a_folder_with_a_comma_and_with_files_from_the_future() {
    expect 0 make_kit 'Doe, Jane'
    cp "$source/solutions/01_derivatives/velocity_now.cpp" 'Doe, Jane/exercises/01_derivatives'
    find 'Doe, Jane' -exec touch -d '+8 hours' {} +
    expect 0 'Doe, Jane/course' check velocity_now
    says err 'dated in the future; their date is set to now'
    is "$(ls 'Doe, Jane/build/exercises/ready' | grep -c '[.][0-9]')" 0
}

# Setup and everything after it look for the same: with no compiler of its kind both say so.
test_setup_says_what_does_not_fit() {
    command -v clang++ >/dev/null || exit 77
    expect 0 make_kit kit
    for command in setup 'check velocity_now'; do
        # shellcheck disable=SC2086
        expect 3 env CXX=clang++ kit/course $command
        is "$(grep -c '^course: this learner.s edition was made for .* ask whoever' err)" 1
    done
    mkdir bin
    ln -s "$(command -v clang++)" bin/c++  # as where c++ is another than g++
    expect 0 env PATH="$folder/bin:$PATH" kit/course setup
    says err 'course: everything that is needed is there. Next: ./course list'
    expect 1 env PATH="$folder/bin:$PATH" kit/course check velocity_now
    says out 'not started'
}

test_on_another_kind_of_machine_it_says_so() {
    expect 0 make_kit kit
    mkdir bin
    printf '#!/bin/sh\nexit 1\n' >bin/apt-get
    chmod +x bin/apt-get
    for change in 'compiler_version 9.1.0' 'compiler Other' 'processor abacus' 'glibc 9.99' \
        'libstdcxx 20991231'; do
        cp "$real_build/exercises/machine.json" kit/kit/kit.json
        sed -i "s/\"${change% *}\": \".*\"/\"${change% *}\": \"${change#* }\"/" kit/kit/kit.json
        rm -rf kit/build
        expect 3 env PATH="$folder/bin:$PATH" sh kit/course check velocity_now
        is "$(grep -c 'this learner.s edition was made for' err)" 1
        is "$(grep -v '^Looking at the compiler' err | grep -c '')" 1
        says err "${change#* }"
        says err 'here is '
    done
}

test_nothing_is_written_over() {
    mkdir empty
    expect 0 make_kit empty
    [ -x empty/course ] || fail 'not in the empty folder'
    refused "'empty' is there and is not empty" make_kit empty
    : >file
    refused "'file' is there and is no folder" make_kit file
    refused 'the folder it is to be in is not there' make_kit none/kit
    mkdir -p course/chapters
    checkout=$folder/course
    refused 'is in the course itself' make_kit course/chapters/kit
    refused 'DIR is required' make_kit
    is "$(ls -A)" "$(printf '%s\n' course empty err file out)"
}

test_odd_names() {
    for name in 'two words' "it's \"quoted\"" 'a$b;c#d' './-x' 'ünï'; do
        expect 0 make_kit "$name"
        [ -x "$name/course" ] || fail "no kit in $name"
    done
    refused "'' is no name of a folder" make_kit ''
    refused "'a?b' has a control character" make_kit "$(printf 'a\nb')"
    expect 2 make_kit -x
    is "$(grep -c '' err)" 1
}

test_a_full_disk_leaves_nothing() {
    mkdir disk
    expect 2 bwrap --dev-bind / / --size 2000000 --tmpfs "$folder/disk" env FIXTURE_SOURCE="$checkout" \
        FIXTURE_BUILD="$real_build" FIXTURE_CMAKE=true FIXTURE_CTEST=false \
        sh -c '"$1" kit disk/kit; status=$?; ls -A disk; exit $status' kit "$program"
    is "$(grep -v '^Building' err | grep -c 'cannot be written (.*is the disk full')" 1
    is "$(cat out)" ''
}

test_an_interrupt_leaves_nothing() {
    default_signals=
    ! env --default-signal=INT true 2>/dev/null || default_signals=--default-signal=INT
    FIXTURE_SOURCE=$checkout FIXTURE_BUILD=$real_build FIXTURE_CMAKE=true FIXTURE_CTEST=false \
        env $default_signals "$program" kit kit >out 2>err &
    running=$!
    while kill -0 $running 2>/dev/null; do
        ls -d .unfinished_kit_* >/dev/null 2>&1 && break
        sleep 0.005
    done
    kill -INT $running
    wait $running && got=0 || got=$?
    is "$got" 130
    is "$(ls -A)" "$(printf '%s\n' err out)"
}

program=$4 real_build=$5 leaks=$6
begin "$@"
checkout=$source
[ -e "$real_build/site_kit/html/index.html" ] || { echo 'skipped: the site is not made'; exit 77; }
case $function in *without_the_checkout | *full_disk*)
    bwrap --dev-bind / / true 2>/dev/null || { echo 'skipped: bubblewrap does not work here'; exit 77; } ;;
esac
! command -v ninja >/dev/null || export CMAKE_GENERATOR=Ninja
"$function"
