#!/bin/sh
# Compiles a source, unless the compiler would read what it has read already: but for comments and for
# where a line stands. A comment in a header that everything includes costs seconds then, not minutes.
#
#     sh compile_what_changed.sh g++ … -o OBJECT -c SOURCE
#
# CMake calls it in place of the compiler (CXX_COMPILER_LAUNCHER). What was read is kept as a checksum in
# OBJECT.read. For g++, which reads on through what was compiled beforehand when it only preprocesses.

object= before=
for word; do
    [ "$before" != -o ] || object=$word
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
    "$@" -E -P || echo "$$ is no sum of anything"  # the compiler says by itself what is wrong
}

sum=$(command -v sha256sum || command -v cksum) || exec "$@"
read=$({ echo "$*"; ls -lL "$(command -v "$1")"; read_only "$@" 2>/dev/null; } | $sum)
if [ -e "$object" ] && [ "$read" = "$(cat "$object.read" 2>/dev/null)" ]; then
    touch "$object"
    exit
fi
rm -f "$object.read"
"$@" || exit
echo "$read" >"$object.read"
