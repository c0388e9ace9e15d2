# The submissions by the verdict that they must get:  sh table.sh
cd "$(dirname "$0")/submissions" || exit 1
for file in *.cpp; do
    read -r _ _ verdict _ <"$file"
    echo "${verdict%:} $(basename "$file" .cpp | tr _ ' ')"
done | sort | awk '{
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
