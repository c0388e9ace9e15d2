# What the lab does for every study: it refuses bad options in one line, and leaves files that are whole or none. All
# studies read their options and write their files by it, so it is tested once, on a small study.

tools=$(cd "$(dirname "$0")/../tools" && pwd)
. "$tools/expect.sh"

# refuses LINE ARGUMENT…: says this line, ends with 2, prints nothing and leaves nothing.
refuses() {
    line=$1
    shift
    expect 2 "$sample" --out new "$@"
    is "$(cat err)" "sample: $line"
    is "$(lines out)" 0
    [ ! -e new ] || fail "left a folder: $*"
}

test_a_value_that_is_no_number_is_named() {
    for value in abc 1x +-1 ++1 + '1 2' 0x10 1,5 -- --help= ' 1' '1 '; do
        refuses "--omega $value: is no number (must be finite and greater than zero)" --omega "$value"
        refuses "--omega $value: is no number (must be finite and greater than zero)" "--omega=$value"
    done
    refuses '--omega "": is no number (must be finite and greater than zero)' --omega=
    refuses '--omega 1\x0a: is no number (must be finite and greater than zero)' --omega '1
'
}

test_a_value_out_of_range_is_named_with_its_rule() {
    for value in nan -nan inf 1e999 0 -0 -0.001; do
        refuses "--omega $value: must be finite and greater than zero" --omega $value
    done
    for value in nan -1; do refuses "--damping $value: must be finite and zero or more" --damping $value; done
    for value in nan -inf 1e999; do refuses "--shift $value: must be a finite number" --shift $value; done
    for value in 0 11 1.5 1e3 99999999999999999999 abc; do
        refuses "--steps $value: must be a whole number from 1 to 10" --steps $value
    done
    refuses '--method other: must be one of explicit, implicit' --method other
    expect 0 "$sample" --omega +1e300 --damping 1e-300 --shift -1e300 --steps 10 --method=implicit
}

test_an_unknown_option_is_refused() {
    for word in --no-such-option --omega2=1 -x word 42 - --OMEGA; do
        refuses "$word: unknown option (sample --help lists them)" "$word"
    done
    refuses 'a\x0ab: unknown option (sample --help lists them)' 'a
b'
    refuses '"": unknown option (sample --help lists them)' ''
    refuses '--omega: needs a value' --omega
    refuses '--omega: must be given once only' --omega 2 --omega=2
    refuses '--out: must be given once only' --out new
}

test_an_output_folder_must_be_a_folder() {
    echo older >file
    for folder in file file/below /dev/null; do
        expect 2 "$sample" --out $folder
        is "$(cat err)" "sample: --out $folder: must be a folder, or the name of a new one"
    done
    expect 2 "$sample" --out=
    says err '--out "": must be a folder'
    is "$(cat file)" older
    [ ! -d /proc/self ] || { expect 2 "$sample" --out /proc/none; says err '/proc/none: the folder cannot be written to'; }
}

test_help_states_each_option_its_value_and_its_rule() {
    expect 0 "$sample" --help
    says out '--omega     angular frequency, rad/s (1; must be finite and greater than zero)'
    says out '--steps     steps taken (3; must be a whole number from 1 to 10)'
    says out '--method    the method (explicit; must be one of explicit, implicit)'
}

# The line of the sample's source that holds these words.
line_of() { grep -nF "$1" "$source/tests/programs/sample.cpp" | cut -d: -f1; }

test_a_run_leaves_numbers_checks_tables_and_the_lines_that_wrote_them() {
    expect 0 "$sample" --out here
    is "$(lines err)" 0
    is "$(cd here && echo .[!.]* *)" '.[!.]* checks.tsv numbers.tsv places.tsv steps.tsv'
    is "$(cat here/numbers.tsv)" "$(printf 'name\tvalue\tunit\tmeaning
omega\t1\trad/s\tthe angular frequency\nthird\t0.333\tm\ta third\nmethod\texplicit\t\tthe method')"
    is "$(cat here/checks.tsv)" "$(printf 'name\tstatement\nslow\tomega is below 5 rad/s')"
    is "$(cat here/steps.tsv)" "$(printf 'step\tx\n0\t0\n1\t0.5\n2\t1')"
    is "$(cat here/places.tsv)" "$(printf 'name\tkind\tplace\nomega\tnumber\tsample.cpp:%s\nthird\tnumber\tsample.cpp:%s
method\tnumber\tsample.cpp:%s\nslow\tcheck\tsample.cpp:%s\nsteps.tsv\tdata\tsample.cpp:%s' "$(line_of '"omega",')" \
        "$(line_of '"third",')" "$(line_of 'out.text(')" "$(line_of 'out.check(')" "$(line_of 'out.table(')")"
}

test_a_check_that_fails_fails_the_run_of_the_page_alone() {
    SAMPLE=fails expect 1 "$sample" --out new
    is "$(cat err)" 'sample: does not hold: omega is below 5 rad/s'
    [ ! -e new ] || fail 'it left its files'
    expect 0 "$sample" --omega 9 --out new
    is "$(cat err)" 'sample: does not hold with these options: omega is below 5 rad/s'
    says new/numbers.tsv 'the angular frequency'
    SAMPLE=nan expect 2 "$sample" --out none
    is "$(cat err)" 'sample: a NaN or an infinity was written'
}

test_a_full_disk_leaves_the_older_files() {
    expect 0 "$sample" --out here
    mkdir here/.unfinished && echo mine >here/.unfinished/mine
    cp -r here before
    # Standard error is a file, too: what it says cannot be kept.
    got=0
    ( trap '' XFSZ; ulimit -f 0; exec "$sample" --omega 2 --out here >/dev/null 2>&1 ) || got=$?
    is "$got" 2
    diff -r here before || fail 'the files changed'
}

test_a_full_output_is_refused() {
    [ -e /dev/full ] || exit 77
    for word in --help --omega=2; do
        "$sample" $word --out new >/dev/full 2>err && fail 'it says that all is well'
        is "$(cat err)" 'sample: standard output: cannot be written'
    done
    [ ! -e new ] || fail 'it left its files'
}

test_runs_into_one_folder_do_not_trouble_each_other() {
    for i in 1 2 3 4 5 6; do "$sample" --out here >/dev/null & all="$all $!"; done
    for one in $all; do wait "$one" || fail 'a run failed'; done
    is "$(cd here && echo .[!.]* *)" '.[!.]* checks.tsv numbers.tsv places.tsv steps.tsv'
}

begin "$@"
sample=$4
"$function"
