# An exercise the whole way:  sh whole_way.sh EXERCISE COURSE SOURCE BUILD
#
# A sample goes it: the stub, the course's answer, one of the other right ones, and two of the mistakes.
# That the hidden tests tell all of them apart is tested without a pipe (self_test). Which ones go is
# decided by what stands in the files, so that it changes with them.
exercise=$1 course=$2 source=$3 build=$4
room=$(echo "$source"/tests/exercises/*/"$exercise")
chapter=$(basename "$(dirname "$room")")
export FIXTURE_SOURCE="$source" FIXTURE_BUILD="$build" FIXTURE_CMAKE=true FIXTURE_CTEST=false
failures=0

# must FILE STATUS VERDICT MISCONCEPTION
must() {
    said=$("$course" check "$exercise" --file "$1" --json) && status=0 || status=$?
    [ "$status" -eq "$2" ] || { echo "$1: status $status instead of $2"; failures=1; }
    [ "$3" != wrong ] || said=$(echo "$said" | sed 's/"not_finite"/"wrong"/')  # so are some mistakes
    for part in "\"exercise\":\"$exercise\"" "\"verdict\":\"$3\"" "\"misconception\":$4"; do
        case $said in *"$part"*) ;; *) echo "$1: no $part in $said"; failures=1 ;; esac
    done
}

stub=$build/exercises/generated/${exercise}_stub.cpp
must "$stub" 1 not_started null
must "$source/solutions/$chapter/$exercise.cpp" 0 pass null
# sample NUMBER FILE: so many of the answers in it, as luck has it, but the same luck for the same file. Leaves each
# as a file of its own, and prints their names.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sample() {
    for name in $(sed -n 's/^namespace \([A-Za-z0-9_]*\) {$/\1/p' "$2"); do
        sh "$source/tests/exercises/variant.sh" "$2" "$name" >"$work/$name.cpp"
        # One that calls another mistake is no file of its own.
        ! grep -q "[a-z_]::$exercise(" "$work/$name.cpp" || rm "$work/$name.cpp"
    done
    (cd "$work" && cksum ./*.cpp) | sort -n | head -n "$1" | sed 's/.*\.\/\(.*\)\.cpp$/\1/'
}

for correct in $(sample 1 "$room/correct.cpp"); do
    must "$work/$correct.cpp" 0 pass null
done
rm "$work"/*.cpp
for mistake in $(sample 2 "$build/exercises/generated/${exercise}_mistakes.hpp"); do
    must "$work/$mistake.cpp" 1 wrong "\"$mistake\""
done
exit $failures
