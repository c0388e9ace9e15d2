# A panel with every control at either of its ends, in all combinations:  sh extremes.sh PANEL
# Whatever blows up is said, and no place that is no number is ever drawn. (A readout may be infinite: a price that no
# step rate pays; the page shows ∞.)
panel=$1
run() {
    said=$("$panel" "$@") || { echo "exit status $?: $panel $*"; exit 1; }
    case $said in *'no number'* | *'too large'* | *nan*) echo "$panel $*"; echo "$said"; exit 1 ;; esac
}
ends=$("$panel" --controls | awk 'BEGIN { n = 1; all[0] = "" }
    { for (i = 0; i < n; ++i) { all[n + i] = all[i] " " $1 "=" $3; all[i] = all[i] " " $1 "=" $2 } n *= 2 }
    END { for (i = 0; i < n; ++i) print all[i] }')
echo "$ends" | {
    while read -r words; do
        # shellcheck disable=SC2086  # several words
        run $words steps=100 grab=0,0 drag=1e3,-1e3 steps=20 let_go steps=60
        number=$((number + 1))
    done
    echo "$number combinations"
    [ "$number" -ge 2 ]
}
