#!/bin/sh
# Compiles a source, unless the compiler would read what it has read already: but for comments and, where no
# source asks for its own lines, for where a line stands. A comment in a header that everything includes costs
# seconds then, not minutes.
#
#     sh compile_what_changed.sh g++ … -MF DEPENDENCIES -o OBJECT -c SOURCE
#
# CMake calls it in place of the compiler (CXX_COMPILER_LAUNCHER). A checksum of what was read is kept in
# OBJECT.read. For g++, which reads on through what was
# compiled beforehand when it only preprocesses; and for builds in which comments and lines do not count:
# a debugger's lines and warnings of a missing comment would be old.

object= depends= near= before=
for word; do
    case $before in -o) object=$word ;; -MF) depends=$word ;; -c) near=${word%"${word##*/}"} ;; esac
    before=$word
done

# The same command, to print what the compiler reads, without comments. A place that is looked up as the program is
# compiled (std::source_location, __builtin_LINE) is the line of a call: where one may be, the lines of the files
# beside the source count, and of those that ask for places themselves. The library's headers, which everything
# includes, know of no such function.
read_only() {
    left=$# before=
    while [ $left -gt 0 ]; do
        word=$1
        shift
        [ "$before" != -o ] || word=-
        set -- "$@" "$word"
        before=$word left=$((left - 1))
    done
    "$@" -E | awk -v near="$near" '
        /^# [0-9]+ "/ {
            match($0, /"[^"]*"/)
            file = substr($0, RSTART + 1, RLENGTH - 2)
            ours = substr($0, RSTART + RLENGTH) !~ /3/  # 3: a header of the system
            line = $2
            next
        }
        NF > 0 {
            print
            if (/source_location|__builtin_(LINE|FILE)/) { asked = 1; asks[file] = 1 }
            if (ours) { files[++count] = file; lines[count] = line }
        }
        { ++line }
        END {
            for (i = 1; asked && i <= count; ++i)
                if (index(files[i], near) == 1 || files[i] in asks) print files[i], lines[i]
        }' || echo "$$ is no sum of anything"  # the compiler says by itself what is wrong
}
# Was a file that the object depends on touched since we began? Then nobody knows what was read.
touched() {
    [ -n "$depends" ] || return 1
    # shellcheck disable=SC2046  # a list of words; with a blank in a name, find fails, and that counts
    changed=$(find $(sed 's/^[^:]*: //; s/ *\\$//' "$depends") -newer "$object.begun" -print -quit 2>&1)
    [ -n "$changed" ]
}

sum=$(command -v sha256sum || command -v cksum) || exec "$@"
: >"$object.begun" || exec "$@"
read=$({ printf '%s\n' "$@"; ls -lL "$(command -v "$1")"; read_only "$@" 2>/dev/null; } | $sum)
{ read -r known; } 2>/dev/null <"$object.read" || known=
if [ -s "$object" ] && [ -n "$read" ] && [ "$read" = "$known" ]; then
    rm -f "$object.begun"
    touch "$object"
    exit
fi
rm -f "$object.read"
"$@"
status=$?
if [ $status -eq 0 ] && ! touched; then
    printf '%s\n' "$read" >"$object.read" 2>/dev/null
fi
rm -f "$object.begun"
exit $status
