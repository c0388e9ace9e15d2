# A submission and its verdict:  sh submission.sh FILE COURSE SOURCE BUILD
# The first line of FILE is  // EXERCISE VERDICT: words that the message must hold, if any
file=$1 course=$2 source=$3 build=$4
read -r _ exercise verdict words <"$file"
verdict=${verdict%:}
export STAGE_SOURCE="$source" STAGE_BUILD="$build" STAGE_CMAKE=true STAGE_CTEST=false

# A verdict comes within 10 s. What a loaded machine takes longer is its own; but it comes.
allowed() {
    read -r load _ 2>/dev/null </proc/loadavg || load=0
    [ "${load%.*}" -lt "$(getconf _NPROCESSORS_ONLN)" ] && echo 10 || echo 40
}

# Checks the file, in `said`; `status` is the check's.
check() {
    begin=$(date +%s)
    said=$("$course" check "$exercise" --file "$file" "$@") && status=0 || status=$?
    taken=$(($(date +%s) - begin))
    [ $taken -le "$(allowed)" ] || { echo "a check took $taken s"; exit 1; }
}

check --json
got=$(echo "$said" | sed -n 's/.*"verdict":"\([a-z_]*\)".*/\1/p')
[ "$got" = "$verdict" ] || { echo "must be $verdict, but is $said"; exit 1; }
expected=1
[ "$got" != pass ] || expected=0
[ "$got" != course_error ] || expected=3
[ "$status" -eq $expected ] || { echo "status $status instead of $expected"; exit 1; }
[ -n "$words" ] || exit 0
check
# shellcheck disable=SC2046,SC2116,SC2086  # the lines may break anywhere
said=$(set -f; echo $said)
case $said in
*"$words"*) ;;
*) echo "must say \"$words\", but says:"; echo "$said"; exit 1 ;;
esac
