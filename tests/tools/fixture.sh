# A fixture for the course program: a checkout with two small chapters, a build folder, and fakes
# for cmake (where it builds), gnuplot and the chapters' programs.

new_fixture() {
    program=$1 real_cmake=$2
    mkdir -p bin source/tools/cmake source/tools/figures build/site/html
    cp "$source"/tools/cmake/*.cmake source/tools/cmake
    : >source/tools/figures/style.gp
    new_chapter 01_fall 'A body falls' 'fall.svg' '["N01", "N02"]'
    new_chapter 03_swing 'A spring swings' 'swing.svg' '["N20"]'
    cat >bin/fixture_cmake <<END
#!/bin/sh
echo "\$*" >>'$folder/calls'
[ "\$1" = --build ] || exec '$real_cmake' "\$@"
cat '$folder/build_says'
exit \$(cat '$folder/build_status')
END
    echo 0 >build_status
    : >build_says
    : >calls
    # Draws the figures of the chapter it is called for, unless told otherwise.
    cat >bin/gnuplot <<END
#!/bin/sh
for word; do script=\$word; done
[ ! -e '$folder/gnuplot_complains' ] || { echo 'line 7: undefined variable: styel' >&2; exit 1; }
name=\$(basename "\$(dirname "\$script")")
[ "\$name" = study ] || [ -e '$folder/draws_nothing' ] || echo '<svg></svg>' >"\${name#*_}.svg"
END
    chmod +x bin/*
}

# new_chapter FOLDER TITLE FIGURE ROWS
new_chapter() {
    mkdir -p "source/chapters/$1" "build/chapters/$1/run"
    cat >"source/chapters/$1/about.json" <<END
{"title": "$2", "question": "Why?", "claims": $4, "picture": "$3"}
END
    mkdir "source/chapters/$1/study"
    : >"source/chapters/$1/figures.gp"
    : >"source/chapters/$1/study/figures.gp"
    echo '1234 ms' >"build/chapters/$1/run/seconds.txt"
    cat >"build/chapters/${1#*_}" <<'END'
#!/bin/sh
[ $# -eq 0 ] || exit 9
echo 'What the program says'
echo '0 1' >motion.dat
END
    cat >"build/chapters/${1#*_}_study" <<'END'
#!/bin/sh
out= options= full= blocked=
while [ $# -gt 0 ]; do
    case $1 in
    --help) echo 'the options of this chapter'; exit ;;
    --bad) echo 'swing: --bad: must be good' >&2; exit 2 ;;
    --odd) echo 'swing: --odd: unknown option (swing --help lists them)' >&2; exit 2 ;;
    --wrong) echo 'swing: does not hold: up is up' >&2; exit 1 ;;
    --crash) kill -SEGV $$ ;;
    --full) full=yes ;;
    --blocked) blocked=yes ;;
    --doubt) printf '%s\n' "swing: with these options the following, true with the page's options, does not hold:" '  up is up' >&2 ;;
    --interrupt) kill -INT 0; sleep 5 ;;
    --out) out=$2; shift ;;
    *) options="$options <$1>" ;;
    esac
    shift
done
[ -z "$full" ] || { echo "swing: $out/motion.tsv: cannot be written" >&2; exit 2; }
[ -z "$blocked" ] || mkdir "$out/run.txt"
echo "The output, with$options"
printf 't\tx\n0\t1\n' >"$out/motion.tsv"
printf 'n\t1\t\tone\n' >"$out/numbers.tsv"
END
    chmod +x "build/chapters/${1#*_}" "build/chapters/${1#*_}_study"
}

course() {
    FIXTURE_SOURCE=$folder/source FIXTURE_BUILD=$folder/build FIXTURE_CMAKE=$folder/bin/fixture_cmake \
        FIXTURE_CTEST=$ctest PATH=$folder/bin:$PATH "$program" "$@"
}
