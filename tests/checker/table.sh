# The submissions by the verdict that they must get:  sh table.sh
cd "$(dirname "$0")/submissions" || exit 1
awk '/^\/\/ ---- / { name = substr($0, 9); getline; sub(":$", "", $3); print $3, name }' *.cpp | sort | awk '{
    verdict = $1; $1 = ""
    if (verdict != last) { printf "%s%s\n", last ? "\n" : "", verdict; last = verdict }
    print "   " $0
    ++all[verdict]
} END {
    print ""
    for (verdict in all) { printf "%4d %s\n", all[verdict], verdict | "sort -rn"; sum += all[verdict] }
    close("sort -rn")
    printf "%4d in all\n", sum
}'
