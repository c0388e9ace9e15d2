# Tests of `course where`: from a name on a page to the line that wrote it.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"
. "$here/fixture.sh"

# A run of chapter 3, and what shows it.
new_run() {
    run=build/chapters/03_swing/run room=source/chapters/03_swing
    mkdir -p source/docs
    printf 'name\tvalue\tunit\tmeaning\nmean\t1.5\tm\tthe mean\nhard\t\t\tinstructions\nwins\tEuler\t\twhich wins\n' >$run/numbers.tsv
    printf 'name\tstatement\nmean\tthe mean is\n' >$run/checks.tsv
    cat >$run/places.tsv <<'END'
name	kind	place
mean	number	chapters/03_swing/study/swing.cpp:2
hard	number	chapters/03_swing/study/swing.cpp:3
wins	number	chapters/03_swing/study/swing.cpp:4
mean	check	chapters/03_swing/study/swing.cpp:5
swing.tsv	data	chapters/03_swing/study/swing.cpp:6
END
    printf 't\tx\n0\t1\n' >$run/swing.tsv
    : >$run/motion.dat
    : >$run/swing.svg
    printf 'out.number("mean")\n' >$room/study/swing.cpp
    printf '// a swing\n\nstd::ofstream data("motion.dat");\n' >$room/swing.cpp
    printf 'load style\ncall figure "swing.svg" 640 480\nplot "motion.dat"\n' >$room/figures.gp
    printf 'plot "swing.tsv" using 1:2, "other_swing.tsv"\n' >$room/study/figures.gp
    printf 'It is {{mean}}, {{mean.value}}\nor $%s$.{{check\nmean}}\n{{figure swing.svg N20: at {{mean}}}}\n' '{{hard}}' >$room/chapter.md
    printf 'See {{03_swing/mean}}, not {{mean}}.\n\n{{table 03_swing/swing.tsv}}\n' >source/docs/start.md
    : >$run/done
}

test_a_number_leads_to_its_line_and_its_uses() {
    new_run
    for name in swing/hard '{{hard}}' hard.value; do
        expect 0 course where "$name"
        is "$(cat out)" 'chapters/03_swing/study/swing.cpp:3
  number 03_swing/hard = not measured here: instructions
  used at chapters/03_swing/chapter.md:2'
    done
    # Of one name there may be a number and a check.
    expect 0 course where 3/mean
    is "$(grep -v 'used at' out)" 'chapters/03_swing/study/swing.cpp:2
  number 03_swing/mean = 1.5 m: the mean
chapters/03_swing/study/swing.cpp:5
  check 03_swing/mean: the mean is'
    says out 'used at docs/start.md:1'
}

test_data_and_figures_lead_to_theirs() {
    new_run
    expect 0 course where 3/swing.tsv
    is "$(cat out)" 'chapters/03_swing/study/swing.cpp:6
  data 03_swing/swing.tsv
  used at chapters/03_swing/study/figures.gp:1
  used at docs/start.md:3'
    expect 0 course where 3/motion.dat
    is "$(cat out)" 'chapters/03_swing/swing.cpp:3
  data 03_swing/motion.dat
  used at chapters/03_swing/figures.gp:3'
    expect 0 course where swing.svg
    is "$(cat out)" 'chapters/03_swing/figures.gp:2
  figure 03_swing/swing.svg
  used at chapters/03_swing/chapter.md:4'
}

test_an_unknown_name_is_one_line_with_near_ones() {
    new_run
    for other in 01_fall instructions programs; do
        mkdir -p build/chapters/$other/run
        : >build/chapters/$other/run/done
    done
    expect 2 course where maen
    is "$(cat err)" "course: 'maen': no run has a number, check, data file or figure of that name; near to it: mean"
    expect 2 course where 3/
    is "$(lines err)" 1
}

test_without_a_run_the_command_that_makes_it_is_told() {
    new_run
    rm $run/done
    expect 3 course where 3/mean
    is "$(cat err)" "course: '3/mean': no run that was made here has that name; ./course tour makes those of 03_swing"
}

ctest=$6
begin "$@"
new_fixture "$4" "$5"
"$function"
