# Tests of ./course bench: what it refuses, and what it leaves. The contest itself is the real one, of one scene.

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
    refuses "--out '': must be the name of a folder" --quick --scene spring --out ''
    refuses '--quick: bench loops does not take it' loops --quick
    [ ! -e build/runs ] || fail 'something was left'
}

test_bench_refuses_folders_that_cannot_be_written() {
    : >file
    refuses 'bench: --out file/below: cannot write there (Not a directory)' --quick --scene spring --out file/below
}

test_bench_tells_people_and_names_what_is_not_installed() {
    rm bin/gnuplot
    gnuplot_there=$(command -v gnuplot || :)
    expect 0 course bench --quick --scene spring --out there
    says out 'compiler  '
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
    # One run per line, below the comments and the names of the columns.
    [ "$(grep -c '^spring,".*,true$' there/spring.csv)" -ge 1 ] || fail 'no run diverges'
    [ "$(grep -c '^spring,' there/spring.csv)" -ge 100 ] || fail 'runs are missing'
    says there/spring.csv '# effort: quick'
    is "$(ls -A there | tr '\n' ' ')" "spring.csv ${gnuplot_there:+spring.svg }"
    if [ -n "$gnuplot_there" ]; then says there/spring.svg '</svg>'; fi
}

test_each_set_of_flags_has_a_program_of_its_own() {
    for name in loops_O2 loops_O3_native many_O2 many_O2_native many_O3_native; do
        printf '#!/bin/sh\necho %s\n' $name >build/tools/bench/bench_$name
        chmod +x build/tools/bench/bench_$name
    done
    expect 0 course bench loops
    is "$(cat out)" "$(printf 'loops_O2\nloops_O3_native')"
    says calls '--target bench_loops_O2 bench_loops_O3_native'
    expect 0 course bench many
    is "$(cat out)" "$(printf 'many_O2\nmany_O2_native\nmany_O3_native')"
}

test_bench_engines_hands_its_words_over() {
    mkdir -p build/engines/measure
    printf '#!/bin/sh\necho "$@"\n' >build/engines/measure/bench_engines
    chmod +x build/engines/measure/bench_engines
    expect 0 course bench engines --quick --scene top --scene cost --engine ODE --out there
    is "$(cat out)" '--out there --quick --scene top --scene cost --engine ODE'
    says calls '--target bench_engines'
    expect 0 course bench engines
    is "$(cat out)" "--out $folder/build/runs/engines"
}

ctest=$6 missing=$8
begin "$@"
new_fixture "$4" "$5"
mkdir -p build/tools/bench
ln -s "$7" build/tools/bench/bench
"$function"
