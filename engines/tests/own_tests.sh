# Runs Box3D's own tests as it is and with each patch, in a copy of a checkout, which is left as it was:
#   sh own_tests.sh CHECKOUT [--out FOLDER] PATCH...
# Prints a table. A patch may change the golden records of the determinism test (after how many steps the bodies sleep,
# and a hash of where they lie): these are recorded anew. It must pass all else that Box3D passes as it is.
# With --out, what a page shows is left in FOLDER: own_tests.tsv, and the rows own_box3d... of numbers.tsv and checks.tsv.
# Ends with 0 if all passed, 1 if a patch broke a test, 2 if it was called wrongly.
set -eu

refuse() { echo "own_tests.sh: $*" >&2; exit 2; }
broken() { echo "own_tests.sh: $words: $*" >&2; exit 1; }

[ $# -gt 0 ] || refuse "the folder of a checkout of Box3D is missing"
checkout=$1
shift
for file in src/solver.c test/main.c test/test_determinism.c; do
    [ -f "$checkout/$file" ] || refuse "$checkout: must be a checkout of Box3D with its tests; there is no $file in it"
done
out=
if [ "${1-}" = --out ]; then
    [ -n "${2-}" ] || refuse "--out: must be the name of a folder"
    mkdir -p "$2" 2>/dev/null || refuse "--out $2: must be a folder that can be written"
    out=$(cd "$2" && pwd)
    shift 2
fi
[ $# -gt 0 ] || refuse "no patch to try"
for patch; do [ -f "$patch" ] || refuse "$patch: must be the file of a patch"; done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
cp -R "$checkout" "$work/box3d"
chmod -R u+w "$work/box3d"
rm -rf "$work/box3d/build"
records=$work/box3d/test/test_determinism.c
cp "$records" "$work/records"

words="Box3D"
build() { cmake --build "$work/build" --target test >"$work/built" 2>&1 || { tail -n 20 "$work/built" >&2; broken "does not compile"; }; }
# RelWithDebInfo: optimised, with Box3D's assertions.
cmake -S "$work/box3d" -B "$work/build" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DBOX3D_SAMPLES=OFF -DBOX3D_UNIT_TESTS=ON \
    >"$work/built" 2>&1 || { tail -n 20 "$work/built" >&2; broken "CMake cannot configure it"; }

# By lines, so that a test that aborts leaves what it has said.
by_lines=
! command -v stdbuf >/dev/null || by_lines="stdbuf -oL"
tests() (cd "$work" && $by_lines build/bin/test "$@" >said 2>&1)

passed() { grep -E '^ *(sub)?test passed: ' "$work/said" || true; }
cases() { grep -c 'subtest passed: ' "$1" || true; }
# What the determinism test expects without BOX3D_DOUBLE_PRECISION: its value of RAGDOLL_SLEEP_STEP, say.
recorded() { sed -n "/^#else/,/^#endif/ s/^#define $1 *//p" "$records"; }
write_down() { sed "/^#else/,/^#endif/ s/^\(#define $1 \).*/\1$2/" "$records" >"$work/new" && cat "$work/new" >"$records"; }
said() { printf '%s\n' "$line" | sed -n "s/.* $1=\([0-9A-Fa-fx]*\).*/\1/p"; }

# Records anew what the determinism test says is otherwise. Each record once: with more threads it must come out again.
record_anew() {
    anew=
    until tests DeterminismTest; do
        line=$(grep ' sleepStep=' "$work/said" | head -n 1)
        case $line in
        "  workers="*|"  cross-platform "*) record=RAGDOLL ;;
        "  wave pile "*) record=WAVE_PILE ;;
        "  query spawn "*) record=QUERY_SPAWN ;;
        "  mesh drop "*) record=MESH_DROP ;;
        *) tail -n 5 "$work/said" >&2; broken "its determinism test fails, and not by a golden record" ;;
        esac
        case " $anew" in *" $record "*) broken "$record comes out otherwise in a second run:$line" ;; esac
        [ "$(said sleepStep)" -gt 0 ] || broken "the bodies of $record do not fall asleep"
        write_down "${record}_SLEEP_STEP" "$(said sleepStep)"
        write_down "${record}_HASH" "$(said hash)"
        if [ $record = QUERY_SPAWN ]; then
            write_down QUERY_SPAWN_HIT_COUNT "$(said hits)"
            write_down QUERY_SPAWN_QUERY_HASH "$(said queryHash)"
        fi
        anew="$anew$record "
        build
    done
    anew=$(printf %s "$anew" | wc -w | tr -d ' ')
}

scenes="RAGDOLL WAVE_PILE QUERY_SPAWN MESH_DROP"
head="engine: rule	cases passed	golden records anew	steps until asleep: ragdolls	wave pile	query spawn	mesh drop"
numbers=
row() {  # of the rule $1, whose name in numbers.tsv is $2
    line="Box3D: $1	$(cases "$work/passed")	$anew"
    for scene in $scenes; do
        steps=$(recorded "${scene}_SLEEP_STEP")
        line="$line	$steps"
        scene=$(echo "$scene" | tr A-Z a-z)
        numbers="${numbers}own_box3d_${scene}_$2	$steps		Box3D's own tests, $1: steps until all bodies of $scene are asleep
"
    done
    echo "$line" >>"$work/table"
    echo "$line"
}

echo "$head" | tee "$work/table"
words="as it is"
build
tests || { tail -n 5 "$work/said" >&2; broken "Box3D does not pass its own tests on this machine, so they say nothing of a patch"; }
passed >"$work/as_it_is"
cp "$work/as_it_is" "$work/passed"
all=$(cases "$work/as_it_is")
[ "$all" -gt 0 ] || broken "Box3D's tests name no case"
anew=0
row "as it is" as_it_is

most=0 tried=
for patch; do
    name=$(basename "$patch" .patch)
    name=${name#box3d_}
    case $name in
    half_step) words="half-step Jacobian, before" ;;
    after_contacts) words="calm, after or in halves" ;;
    *) words=$name ;;
    esac
    patch=$(cd "$(dirname "$patch")" && pwd)/$(basename "$patch")
    apply() { (cd "$work/box3d" && GIT_CEILING_DIRECTORIES=$work git apply "$@" "$patch"); }
    apply || broken "the patch does not apply to $checkout"
    build
    record_anew
    tests || true
    passed >"$work/passed"
    if ! cmp -s "$work/as_it_is" "$work/passed"; then
        tail -n 5 "$work/said" >&2
        broken "$(cases "$work/passed") of $all cases passed; first of those that did not: $(diff "$work/as_it_is" "$work/passed" | sed -n 's/^< *\(sub\)\{0,1\}test passed: //p' | head -n 1)"
    fi
    row "$words" "$name"
    [ "$anew" -le "$most" ] || most=$anew
    tried="$tried${tried:+, }$name"
    apply -R
    cat "$work/records" >"$records"
done

[ -n "$out" ] || exit 0
# Rows of other commands stay.
leave() {  # $1: a file of the folder, $2: its first line, $3: the rows
    { [ -f "$out/$1" ] && grep -v '^own_box3d_' "$out/$1" || echo "$2"; printf %s "$3"; } >"$work/new"
    cp "$work/new" "$out/$1"
}
cp "$work/table" "$out/own_tests.tsv"
leave numbers.tsv "name	value	unit	meaning" "own_box3d_cases	$all		Box3D's own tests: cases that pass as it is and with each patch
own_box3d_anew	$most		Box3D's own tests: golden records of its determinism test that a patch changes, at most
$numbers"
leave checks.tsv "name	statement" "own_box3d_pass	Box3D with its patches ($tried) passes every case of its own tests, as it does as it is; only golden records of its determinism test are recorded anew, and they come out the same with each number of threads that the test tries
"
