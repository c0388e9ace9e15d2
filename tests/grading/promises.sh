# Every test that the page of promises names is one of ours, and its limits are the checker's.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

test_every_test_they_name_exists() {
    "$ctest" --test-dir "$build" -N | sed -n 's/^ *Test *#[0-9]*: //p' | sort >tests
    sed -n 's/^|.*|\(.*\)|$/\1/p' "$source/docs/promises.md" | grep -o '`[^`]*`' | tr -d '`' |
        grep ' ' | sort -u >named
    [ "$(lines named)" -ge 25 ] || fail 'the page names hardly any test'
    is "$(comm -13 tests named)" ''
}

test_their_limits_are_those_of_the_checker() {
    seconds() { sed -n "s/.* $1 = \([0-9]*\);.*/\1/p" "$source/$2"; }
    says "$source/docs/promises.md" "each of a compiler's programs has $(seconds compiler_seconds tools/course/paths.hpp) s of work (with Eigen 18), \
a call $(($(seconds total_seconds tools/checker/remote.hpp) / 4)) s, \
all calls $(seconds total_seconds tools/checker/remote.hpp) s. \
By the clock, on which a busy machine is slow, a compiler has \
$(seconds compiler_seconds tools/course/paths.hpp)0 s and a call $(seconds clock_seconds tools/checker/remote.hpp) s."
}

ctest=$4 build=$5
begin "$@"
"$function"
