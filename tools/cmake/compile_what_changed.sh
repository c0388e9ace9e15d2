#!/bin/sh
# Compiles a source, unless the compiler would read what it has read already: but for comments and for
# where a line stands. A comment in a header that everything includes costs seconds then, not minutes.
#
#     sh compile_what_changed.sh g++ … -MF DEPENDENCIES -o OBJECT -c SOURCE
#
# CMake calls it in place of the compiler (CXX_COMPILER_LAUNCHER). A checksum of what was read is kept in
# OBJECT.read. For g++, which reads on through what was
# compiled beforehand when it only preprocesses; and for builds in which comments and lines do not count:
# a debugger's lines and warnings of a missing comment would be old.

object= depends= before=
for word; do
    case $before in -o) object=$word ;; -MF) depends=$word ;; esac
    before=$word
done

# The same command, to print what the compiler reads, without comments (-P: and without the lines' places).
read_only() {
    left=$# before=
    while [ $left -gt 0 ]; do
        word=$1
        shift
        [ "$before" != -o ] || word=-
        set -- "$@" "$word"
        before=$word left=$((left - 1))
    done
    # A place that is looked up as the program is compiled does not show here: no two of those are alike.
    "$@" -E -P | sed "s/source_location/& $$ $(date +%s)/" || echo "$$ is no sum of anything"  # the compiler says by itself what is wrong
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
