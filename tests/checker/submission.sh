# A submission and its verdict:  sh submission.sh FILE COURSE SOURCE BUILD
# The first line of FILE is  // EXERCISE VERDICT: words that the message must hold, if any
file=$1 course=$2 source=$3 build=$4
read -r _ exercise verdict words <"$file"
verdict=${verdict%:}
export FIXTURE_SOURCE="$source" FIXTURE_BUILD="$build" FIXTURE_CMAKE=true FIXTURE_CTEST=false
fail() { echo "$1, but it says:"; echo "$said"; exit 1; }

said=$("$course" check "$exercise" --file "$file") && status=0 || status=$?
expected=1
[ "$verdict" != pass ] || expected=0
[ "$status" -eq $expected ] || fail "the status must be $expected, not $status"
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
first=$(echo "$said" | head -n 1)
case $first in *"$title"*) ;; *) fail "the verdict must be $verdict" ;; esac
# shellcheck disable=SC2046,SC2116,SC2086  # the lines may break anywhere
flowing=$(set -f; echo $said)
case $flowing in *"$words"*) ;; *) fail "it must say \"$words\"" ;; esac
