# A submission and its verdict:  sh submission.sh FILE COURSE SOURCE BUILD
# The first line of FILE is  // EXERCISE VERDICT: words that the message must hold
file=$1 course=$2 source=$3 build=$4
read -r _ exercise verdict words <"$file"
verdict=${verdict%:}
export STAGE_SOURCE="$source" STAGE_BUILD="$build" STAGE_CMAKE=true STAGE_CTEST=false

begin=$(date +%s)
said=$("$course" check "$exercise" --file "$file" --json) && status=0 || status=$?
got=$(echo "$said" | sed -n 's/.*"verdict":"\([a-z_]*\)".*/\1/p')
[ "$got" = "$verdict" ] || { echo "must be $verdict, but is $said"; exit 1; }
expected=1
[ "$got" != pass ] || expected=0
[ "$got" != course_error ] || expected=3
[ "$status" -eq $expected ] || { echo "status $status instead of $expected"; exit 1; }
# shellcheck disable=SC2046,SC2116  # the lines may break anywhere
said=$(set -f; echo $("$course" check "$exercise" --file "$file"))
case $said in
*"$words"*) ;;
*) echo "must say \"$words\", but says:"; echo "$said"; exit 1 ;;
esac
end=$(date +%s)
[ $((end - begin)) -le 20 ] || { echo "two checks took $((end - begin)) s"; exit 1; }
