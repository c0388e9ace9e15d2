#!/bin/sh
# Compiles a source, unless the compiler would read what it has read already: but for comments and, where no
# source asks for its own lines, for where a line stands. A comment in a header that everything includes costs
# seconds then, not minutes.
#
#     sh compile_what_changed.sh g++ … -MF DEPENDENCIES -o OBJECT -c SOURCE
#
# CMake calls it in place of the compiler (CXX_COMPILER_LAUNCHER). OBJECT.read keeps a checksum of what was read, the
# files that ask for lines, and the compiler's list of all that it read. For g++, whose precompiled headers are objects
# of their own here; and for builds in which comments and lines do not count: a debugger's lines and warnings of a
# missing comment would be old.

object= depends= near= before= ready=
for word; do
    case $before in
    -o) object=$word ;;
    -MF) depends=$word ;;
    -c) near=${word%"${word##*/}"} ;;
    -include) ready=$word.gch ;;  # may have been compiled beforehand
    esac
    before=$word
done
case $near in */Unity/) near=/ ;; esac  # many sources as one, from anywhere
if [ "$ready" = "$object" ] || [ ! -e "$ready" ]; then ready=; fi
asking='source_location|__builtin_(LINE|FILE)|__LINE__'

# What the compiler read by its list $1: the system's files by their dates, all others without comments. A place that
# is looked up as the program is compiled (std::source_location, __LINE__) is the line of a call: where one may be, the
# lines of the files beside the source count, and of those that ask for places themselves. Sets read and asks.
look_at() {
    read= asks= list=$(sed 's/^[^:]*://; s/ *\\$//' "$1" | tr -s ' ' '\n') || return
    theirs=$(echo "$list" | grep '^/usr/')
    ours=$(echo "$list" | grep -v -e '^/usr/' -e '^$')
    # shellcheck disable=SC2046,SC2086  # lists of words; with a blank in a name, ls fails, and nobody knows what was read
    [ -z "$(ls -lL $(command -v "$compiler") $theirs $ours 2>&1 >/dev/null)" ] || return
    # shellcheck disable=SC2086
    asks=$(grep -lE "$asking" $ours | tr '\n' ' ')
    [ -z "$ready" ] || asks="$asks$(sed -n 2p "$ready.read" 2>/dev/null)"
    # shellcheck disable=SC2046,SC2086
    read=$({
        echo "$words"
        ls -lL $(command -v "$compiler") $theirs
        [ -z "$ready" ] || head -n 1 "$ready.read" 2>/dev/null || ls -lL "$ready"
        awk 'FNR == 1 { print "# 1 \"" FILENAME "\"" } { print }' $ours |
            "$compiler" -fpreprocessed -dD -E -x c++ - 2>/dev/null | awk -v near="$near" -v asks=" $asks" '
            /^# [0-9]+ "/ {
                line = $2
                file = $3
                gsub(/"/, "", file)
                counts = asks != " " && (near != "" && index(file, near) == 1 || index(asks, " " file " "))
                next
            }
            NF > 0 { print counts ? file ":" line : "", $0 }
            { ++line }'
    } | $sum)
}
# Was a file that the object depends on touched since we began? Then nobody knows what was read.
touched() {
    # shellcheck disable=SC2086  # a list of words
    changed=$(find $list -newer "$object.begun" -print -quit 2>&1)
    [ -n "$changed" ]
}

sum=$(command -v sha256sum || command -v cksum) || exec "$@"
: >"$object.begun" || exec "$@"
compiler=$1 words=$* known=
{ read -r known; } 2>/dev/null <"$object.read" || known=
if [ -s "$object" ] && [ -n "$known" ] && [ -n "$depends" ] && tail -n +3 "$object.read" >"$depends" &&
    look_at "$depends" && [ "$read" = "$known" ]; then
    rm -f "$object.begun"
    touch "$object"
    exit
fi
rm -f "$object.read"
"$@"
status=$?
if [ $status -eq 0 ] && [ -n "$depends" ] && look_at "$depends" && [ -n "$read" ] && ! touched; then
    { printf '%s\n%s\n' "$read" "$asks" && cat "$depends"; } >"$object.read" 2>/dev/null
fi
rm -f "$object.begun"
exit $status
