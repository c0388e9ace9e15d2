# A submission and its verdict:  sh submission.sh FILE COURSE SOURCE BUILD
# The first line of FILE is  // EXERCISE VERDICT: words that the message must hold, if any
file=$1 course=$2 source=$3 build=$4
read -r _ exercise verdict words <"$file"
verdict=${verdict%:}
export FIXTURE_SOURCE="$source" FIXTURE_BUILD="$build" FIXTURE_CMAKE=true FIXTURE_CTEST=false
fail() { echo "$1, but it says:"; echo "$said"; exit 1; }

[ -n "$words" ] && json= || json=--json
said=$("$course" check "$exercise" --file "$file" $json) && status=0 || status=$?
# A verdict takes 30 s of a processor at most, too slow an answer 8 s: its own two, and the compiler's. What
# the clock says is the machine's own: others may be at work. The last line of `times` is of all that this shell has waited for: "1m2.3s 0m0.4s".
times >"${TMPDIR:-/tmp}/times_$$"
taken=$(tail -n 1 "${TMPDIR:-/tmp}/times_$$" | tr 'ms' '  ' | awk '{print int(60 * $1 + $2 + 60 * $3 + $4)}')
rm "${TMPDIR:-/tmp}/times_$$"
[ "$verdict" = too_slow ] && allowed=8 || allowed=30
[ "$taken" -le $allowed ] || fail "it took $taken s of a processor"

expected=1
[ "$verdict" != pass ] || expected=0
[ "$status" -eq $expected ] || fail "the status must be $expected, not $status"

# The verdict, for programs or in words.
case $verdict in
    pass) title=': right' ;;
    does_not_compile) title=': does not compile' ;;
    not_started) title=': not started' ;;
    wrong) title=': not yet' ;;
    not_finite) title=': not a number' ;;
    crash) title=': crashes' ;;
    too_slow) title=': too slow' ;;
    too_much_memory) title=': too much memory' ;;
    left_early) title=': does not return' ;;
esac
[ -z "$json" ] || title="\"verdict\":\"$verdict\""
first=$(echo "$said" | head -n 1)
case $first in *"$title"*) ;; *) fail "the verdict must be $verdict" ;; esac

# shellcheck disable=SC2046,SC2116,SC2086  # the lines may break anywhere
flowing=$(set -f; echo $said)
case $flowing in *"$words"*) ;; *) fail "it must say \"$words\"" ;; esac
