# Tests of ./course bench: what it refuses, that a run goes on where it was stopped, and that results of
# different setups are not mixed. The contest itself is the real one, of one scene or two.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

refuses() {
    what=$1
    shift
    expect 2 course bench "$@"
    is "$(lines err)" 1
    is "$(lines out)" 0
    says err "$what"
}

test_bad_use_of_bench_is_refused_in_one_line() {
    refuses 'bench: --scene sprin: must be one of' --scene sprin
    says err spring
    refuses 'bench: --scene' --scene spring --scene ''
    refuses '--scene' --scene
    refuses '--secne' --secne spring
    refuses 'spring' spring
    refuses "--out '': must be the name of a folder" --quick --scene spring --out ''
    refuses '--quick: bench loops does not take it' loops --quick
    refuses '--json: bench gyroscopic does not take it' --json gyroscopic
    refuses '--scene: bench latency does not take it' latency --scene spring
    [ ! -e build/runs ] || fail 'something was left'
}

test_bench_refuses_folders_that_cannot_be_written() {
    : >file
    refuses 'bench: --out file: cannot write there (Not a directory)' --quick --scene spring --out file
    refuses 'bench: --out file/below: cannot write there (Not a directory)' --quick --scene spring --out file/below
    [ ! -d /proc/self ] || refuses 'bench: --out /proc/self/new: cannot write there' --quick --scene spring --out /proc/self/new
    # A folder of the reader's own is in the way: nothing is left beside it.
    mkdir -p there/meta.json/mine
    refuses 'meta.json: cannot be written' --quick --scene spring --out there
    is "$(ls -A there)" meta.json
}

test_bench_json_is_for_programs() {
    no_gnuplot
    expect 0 course bench --quick --scene spring --json --out there
    cat >look.cmake <<'END'
file(READ out json)
string(JSON count LENGTH "${json}")
math(EXPR last "${count} - 1")
set(expected scene method library step error_final error_max seconds evaluations solves diverged instructions)
set(diverged 0)
foreach(i RANGE ${last})
  string(JSON keys LENGTH "${json}" ${i})
  if(NOT keys EQUAL 11)
    message(FATAL_ERROR "${keys} keys")
  endif()
  foreach(key IN LISTS expected)
    string(JSON type_${key} TYPE "${json}" ${i} ${key})
  endforeach()
  if(NOT "${type_scene} ${type_method} ${type_library}" STREQUAL "STRING STRING STRING" OR
     NOT "${type_step} ${type_seconds} ${type_evaluations} ${type_solves}" STREQUAL "NUMBER NUMBER NUMBER NUMBER" OR
     NOT "${type_diverged} ${type_instructions}" STREQUAL "BOOLEAN NULL")
    message(FATAL_ERROR "run ${i} is of other types")
  endif()
  string(JSON blown GET "${json}" ${i} diverged)
  if(blown)
    math(EXPR diverged "${diverged} + 1")
  elseif(NOT "${type_error_final} ${type_error_max}" STREQUAL "NUMBER NUMBER")
    message(FATAL_ERROR "run ${i} has no error")
  endif()
endforeach()
if(count LESS 100 OR diverged EQUAL 0)
  message(FATAL_ERROR "${count} runs, of which ${diverged} diverge")
endif()
file(READ there/meta.json about)
foreach(key effort compiler flags cpu program)
  string(JSON ${key} GET "${about}" ${key})
endforeach()
message("${effort}")
END
    is "$("$real_cmake" -P look.cmake 2>&1)" quick
    # A run a line, below the comments and the names of the columns.
    is "$(grep -c '^spring,' there/spring.csv)" "$(grep -c '"scene"' out)"
    says there/spring.csv '# compiler: '
    is "$(ls -A there | tr '\n' ' ')" 'meta.json spring.csv '
    # What is kept says the same again.
    mv out before
    expect 0 course bench --quick --scene spring --json --out there
    cmp before out || fail 'what was kept is told otherwise'
}

# Killed when the first of two scenes is there, it goes on with the second.
test_bench_goes_on_where_it_was_killed() {
    no_gnuplot
    ( export FIXTURE_SOURCE="$folder/source" FIXTURE_BUILD="$folder/build" FIXTURE_CMAKE="$folder/bin/fixture_cmake"
      PATH=$folder/bin:$PATH exec "$program" bench --quick --scene spring --scene damped_spring --out there ) \
        >out 2>err </dev/null &
    killed=$!
    waited=0
    until [ -e there/spring.csv ]; do
        sleep 0.1
        waited=$((waited + 1))
        [ $waited -lt 12000 ] || fail 'the first scene takes too long'
    done
    kill -9 $killed
    wait $killed && fail 'it was over before it was killed' || :
    [ ! -e there/damped_spring.csv ] || fail 'both scenes were over'
    cp there/spring.csv before
    expect 0 course bench --quick --scene spring --scene damped_spring --out there
    says err 'bench: 1 of 2 scenes are in there already; --again measures them, too'
    says out '(spring)'
    says out '(damped_spring)'
    cmp before there/spring.csv || fail 'the first scene was measured again'
}

test_bench_does_not_mix_results_of_different_setups() {
    no_gnuplot
    expect 0 course bench --quick --scene spring --out there
    is "$(lines err)" 0
    # So it would look had another compiler been at work, or had the file been cut off.
    sed -i 's/^# compiler: .*/# compiler: another/' there/spring.csv
    expect 0 course bench --quick --scene spring --out there
    is "$(cat err)" 'bench: results in there are of another compiler: these scenes are measured anew'
    silent_on there/spring.csv another
    head -c 2000 there/spring.csv >cut
    cp cut there/spring.csv
    expect 0 course bench --quick --scene spring --out there
    says err 'of another form'
    is "$(tail -c 1 there/spring.csv | wc -l)" 1
}

test_bench_tells_people_and_names_what_is_not_installed() {
    rm bin/gnuplot
    gnuplot_there=$(command -v gnuplot || :)
    expect 0 course bench --quick --scene spring --out there
    says out 'compiler  '
    says out 'cpu  '
    says out 'a spring, one oscillation a second (spring)'
    for accuracy in '10 %' '1 %' '0.1 %' 1e-6; do
        grep -qE "^  $accuracy  .*, .* [0-9.e+]+ +[0-9.]+ (ns|µs|ms)\$" out || fail "no line for $accuracy"
    done
    says out "$folder/there"
    # The list that CMake made, with | between its names.
    echo "$missing" | tr '|' '\n' | while read -r peer; do
        [ -z "$peer" ] || says out "Not installed, so not measured: $peer"
    done
    [ -n "$missing" ] || silent_on out 'Not installed'
    if [ -n "$gnuplot_there" ]; then
        says there/spring.svg '</svg>'
        is "$(ls -A there | tr '\n' ' ')" 'meta.json spring.csv spring.svg '
    fi
    no_gnuplot
    expect 0 course bench --quick --scene spring --out there
    says out 'No figures: gnuplot is not installed (package gnuplot-nox)'
    draws_badly
    expect 2 course bench --quick --scene spring --out there
    says err 'spring.svg: could not be drawn'
}

test_a_full_output_is_no_success_of_bench() {
    [ -e /dev/full ] || exit 77
    no_gnuplot
    for words in '' --json; do
        got=0
        # shellcheck disable=SC2086
        course bench --quick --scene spring --out there $words >/dev/full 2>err </dev/null || got=$?
        is "$got" 2
        says err 'standard output: cannot be written'
    done
}

test_the_tables_of_targets_come_from_a_program_a_set_of_flags() {
    for name in loops gyroscopic; do
        for flags in O2 O3_native; do
            printf '#!/bin/sh\necho "%s with %s"\n' $name $flags >build/tools/bench/bench_${name}_$flags
            chmod +x build/tools/bench/bench_${name}_$flags
        done
        expect 0 course bench $name
        is "$(cat out)" "$name with O2
$name with O3_native"
        says calls "--target bench_${name}_O2 bench_${name}_O3_native"
    done
    for flags in O2 O2_native O3_native; do
        printf '#!/bin/sh\necho "many with %s"\n' $flags >build/tools/bench/bench_many_$flags
        chmod +x build/tools/bench/bench_many_$flags
    done
    expect 0 course bench many
    is "$(cat out)" "many with O2
many with O2_native
many with O3_native"
    printf '#!/bin/sh\necho "Bullet is not installed" >&2\nexit 3\n' >build/tools/bench/bench_gyroscopic_O2
    expect 3 course bench gyroscopic
    is "$(cat err)" 'Bullet is not installed'
}

test_bench_engines_hands_its_words_over() {
    mkdir -p build/engines/measure
    printf '#!/bin/sh\necho "$@"\n' >build/engines/measure/bench_engines
    chmod +x build/engines/measure/bench_engines
    expect 0 course bench engines --quick --scene top --scene cost --engine ODE --out there
    is "$(cat out)" '--out there --quick --engine ODE --scene top --scene cost'
    says calls '--target bench_engines'
    expect 0 course bench engines
    is "$(cat out)" "--out $folder/build/runs/engines"
    refuses '--again: bench engines does not take it' engines --again
}

# Fails as a shell does that finds none.
no_gnuplot() { printf '#!/bin/sh\nexit 127\n' >bin/gnuplot; chmod +x bin/gnuplot; }
draws_badly() { printf '#!/bin/sh\necho no\nexit 1\n' >bin/gnuplot; chmod +x bin/gnuplot; }

ctest=$6 missing=$8
begin "$@"
new_fixture "$4" "$5"
mkdir -p build/tools/bench
ln -s "$7" build/tools/bench/bench
"$function"
