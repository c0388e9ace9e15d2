# An exercise the whole way:  sh whole_way.sh EXERCISE COURSE SOURCE BUILD
#
# The stub, the course's answer, the first of the other right ones, and the first mistake are compiled, linked, and
# called through the pipe. self_test checks all of them, without a pipe.
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
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# first FILE: the first of the answers in it, as a file of its own.
first() {
    name=$(sed -n 's/^namespace \([A-Za-z0-9_]*\) {$/\1/p' "$1" | head -n 1)
    sh "$source/tests/exercises/variant.sh" "$1" "$name" >"$work/$name.cpp"
}

must "$build/exercises/generated/${exercise}_stub.cpp" 1 not_started null
must "$source/solutions/$chapter/$exercise.cpp" 0 pass null
first "$room/correct.cpp"
must "$work/$name.cpp" 0 pass null
first "$build/exercises/generated/${exercise}_mistakes.hpp"
must "$work/$name.cpp" 1 wrong "\"$name\""
exit $failures
