# Submissions with odd names, and what is no submission.

. "$(dirname "$0")/class.sh"

# Pairs that one way of writing or another makes one of: the raw bytes of the first against the second's.
test_names_that_differ_stay_different() {
    needs_isolation
    command -v python3 >/dev/null || exit 77
    rm -r class/*
    i=0
    for name in '\377' '\\\\xff' '\\\\\\\\xff' '\376' 'u\342\200\256v' 'u?v' '\357\277\276' '\357\277\277' 'tab\t' \
        'tab\\\\t' 'tab ' 'tab' 'new\nline' '=1' "'=1" 'a&b' 'a&amp;b' '"q"' '\033[2J' 'cr\r'; do
        i=$((i + 1))
        name=$(printf "$name."; )  # a command's value loses the newlines at its end
        hand_in "${name%.}" "$(if [ $((i % 2)) -eq 0 ]; then echo $solved; else echo $stub; fi)"
    done
    expect 1 course grade class
    is "$(grep -c ' of 1' out)" $i
    is "$(sed -n 's/  *[01] of 1.*//p' out | LC_ALL=C sort -u | grep -c '')" $i
    python3 - $i <<'PYTHON' || fail 'two names became one'
import csv, json, sys, unicodedata, xml.etree.ElementTree as tree
number = int(sys.argv[1])
names = {
    "xml": [case.get("classname") for case in tree.parse("class.grades/junit.xml").getroot()[0]],
    "json": [grade["submission"] for grade in json.load(open("class.grades/grades.json"))],
    "csv": [row[0] for row in csv.reader(open("class.grades/grades.csv", encoding="utf-8"))][1:],
}
for kind, found in names.items():
    assert len(found) == len(set(found)) == number, (kind, sorted(found))
    for name in found:  # as a reader sees them, too
        assert all(c == " " or unicodedata.category(c)[0] not in "CZ" for c in name), (kind, ascii(name))
        assert name == name.strip(), (kind, name)
assert names["xml"] == names["json"]
PYTHON
}

# An answer may say what the system says when it is in trouble: it gets its verdict all the same.
test_words_of_the_system_are_not_believed() {
    needs_isolation
    for words in 'No space left on device' 'bwrap: cannot'; do
        { echo "#error $words"; cat $solved; } >words.cpp
        hand_in "$words" words.cpp
    done
    { cat $solved; echo 'static int unused() { return 0; }  // No space left on device'; } >words.cpp
    hand_in right words.cpp
    expect 1 course grade class
    is "$(verdict_of 'No space left on device')" does_not_compile
    is "$(verdict_of 'bwrap: cannot')" does_not_compile
    is "$(verdict_of right)" pass
}

test_files_by_the_names_of_people() {
    needs_isolation
    mkdir flat
    cp $solved flat/alice_velocity.cpp
    cp "$mistake" flat/bob.cpp
    expect 2 course grade flat
    says err 'flat: holds no answer: no file has the name of an exercise'
    expect 1 course grade flat --one --exercise velocity_now  # which of the two?
    says out 'nothing was handed in'
    expect 1 course grade flat --exercise velocity_now
    says flat.grades/grades.csv '"alice_velocity.cpp",1,1,pass'
    says flat.grades/grades.csv '"bob.cpp",0,1,wrong'
}

test_bad_use_in_one_line() {
    mkdir empty
    for words in 'missing' "''" 'class --out=' 'empty' 'class --exercise none' \
        'class --out class/alice/velocity_now.cpp' '/dev/null'; do
        # shellcheck disable=SC2086
        expect 2 course grade $words
        is "$words: $(lines err)" "$words: 1"
    done
    [ ! -e class.grades ] || fail 'there are grades'
}

grade_class "$@"
