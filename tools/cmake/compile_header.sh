#!/bin/sh
# Compiles a header beforehand, by the command given: sh compile_header.sh COMPILED COMMAND…
# COMPILED is there as a whole or not at all, whoever else compiles it and whenever this is killed.
compiled=$1
shift
for part in "$compiled".[0-9]*; do
    kill -0 "${part##*.}" 2>/dev/null || rm -f "$part"  # of one that was killed
done
whole=$compiled.$$
trap 'rm -f "$whole"; exit 130' INT TERM HUP
"$@" -o "$whole" && mv -f "$whole" "$compiled" && exit
status=$?
rm -f "$whole"
exit $status
