# Submissions with odd names, and that are no submissions.

. "$(dirname "$0")/class.sh"

test_names_of_any_kind() {
    needs_isolation
    newline='new
line'
    for name in 'two words' "it's" '"quoted"' "$newline" -dash --help '$(touch touched)' '*' \
        '=1+1' "$(printf 'not\377utf8')" "$(printf 'escape\033[2J')" .hidden ..odd; do
        hand_in "$name" $solved
    done
    expect 1 course grade class
    says out '14 of 16 right'
    [ ! -e touched ] || fail 'a name was obeyed'
    says out 'new\nline'
    says out 'escape\x1b[2J'
    says class.grades/grades.csv "\"'=1+1\",1,1,pass"
    says class.grades/grades.csv "\"'-dash\",1,1,pass"
    command -v python3 >/dev/null || return 0
    python3 -c 'import json; assert len(json.load(open("class.grades/grades.json"))) == 16' || fail json
    expect 1 course grade class
    says err ' 16 were graded before'
}

test_what_is_no_file_is_refused() {
    needs_isolation
    mkdir class/link class/folder class/fifo class/far class/big class/device class/many class/two
    ln -s "$folder/$solved" class/link/velocity_now.cpp
    mkdir class/folder/velocity_now.cpp
    mkfifo class/fifo/velocity_now.cpp
    ln -s "$folder/class/alice" class/linked
    ln -s / class/far/root
    truncate -s 1G class/big/velocity_now.cpp
    mknod class/device/velocity_now.cpp c 1 5 2>/dev/null || mkfifo class/device/velocity_now.cpp
    mkdir class/two/a class/two/b
    cp $solved class/two/a/velocity_now.cpp
    cp $solved class/two/b/velocity_now.cpp
    cp $solved class/archive.zip
    expect 1 timeout 600 $(words) grade class
    for name in link folder fifo linked big device two archive.zip; do
        case $name in linked | archive.zip) continue ;; esac
        is "$name $(verdict_of $name)" "$name refused"
    done
    is "$(says_of link)" 'velocity_now: refused: velocity_now.cpp is a link, and links are not followed'
    is "$(says_of big)" 'velocity_now: refused: velocity_now.cpp is larger than 1 MB'
    is "$(says_of fifo)" 'velocity_now: refused: velocity_now.cpp is no regular file'
    case $(says_of two) in *'2 files answer it, a/velocity_now.cpp and b/velocity_now.cpp, and exercises/01_derivatives does not hold exactly one of them: keep only one'*) ;; *) fail "$(says_of two)" ;; esac
    is "$(verdict_of far)" missing
    is "$(verdict_of linked)" missing
    is "$(verdict_of archive.zip)" missing
    expect 1 course grade class --exercise velocity_now
    case $(says_of linked) in *'linked is a link'*) ;; *) fail "$(says_of linked)" ;; esac
    case $(says_of archive.zip) in *'unpacked first'*) ;; *) fail "$(says_of archive.zip)" ;; esac
}

# A class as it ought not to be, in one line: where is the one submission, where are the others?
test_answers_beside_folders_with_answers() {
    cp $solved class/velocity_now.cpp
    expect 2 course grade class
    says err "if it is one, ./course grade class --one"
    rm class/velocity_now.cpp
    expect 2 course grade class --out class/grades
    says err 'class/grades: the grades would lie among the submissions'
    cd class
    expect 2 course grade .
    says err 'the grades would lie among the submissions'
}

test_a_refused_answer_is_told() {
    needs_isolation
    rm class/bob/velocity_now.cpp
    ln -s "$folder/class/alice/velocity_now.cpp" class/bob/best_gap.cpp
    expect 1 course grade class
    says class.grades/grades.csv '"bob",0,2,missing,refused'
    expect 1 course grade class/bob --out bob
    says out 'best_gap.cpp is a link, and links are not followed'
}

# What others read must stay readable, whatever one learner prints.
test_signs_that_no_file_may_hold() {
    needs_isolation
    command -v python3 >/dev/null || exit 77
    hand_in "$(printf 'name\357\277\277')" $solved
    echo 'std::puts("\357\277\277\357\277\276 \001 \033[31m ]]> \200\377");' | answer dave
    hand_in "$(printf 'not\377utf8')" "$mistake"
    hand_in "$(printf 'not\376utf8')" "$mistake"
    expect 1 course grade class
    cp class.grades/grades.csv first.csv
    expect 1 course grade class
    cmp -s class.grades/grades.csv first.csv || fail 'other names the second time'
    says first.csv 'not\xffutf8'
    says first.csv 'not\xfeutf8'
    python3 - <<'PYTHON' || fail 'what is written'
import csv, json, xml.etree.ElementTree as tree
assert len(tree.parse("class.grades/junit.xml").getroot()[0]) == 7
assert len(json.load(open("class.grades/grades.json"))) == 7
assert len(list(csv.reader(open("class.grades/grades.csv", encoding="utf-8")))) == 8
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

test_a_journal_that_somebody_else_has_written() {
    needs_isolation
    expect 1 course grade class --seed 7
    for line in '{"edition":5}' '[]' '{"edition":"x","seed":"y"}' '{"edition":"x","seed":-3}' 'nonsense'; do
        echo "$line" >class.grades/journal.jsonl
        expect 1 course grade class
        says out '1 of 3 right'
    done
}

test_ten_thousand_files_are_looked_through() {
    needs_isolation
    mkdir -p class/many/deep/exercises/01_derivatives class/endless
    (cd class/many/deep && seq -f 'file%.0f.cpp' 10000 | xargs touch)
    (cd class/endless && seq -f 'file%.0f.cpp' 20001 | xargs touch)
    cp $solved class/many/deep/exercises/01_derivatives/velocity_now.cpp
    cp "$mistake" class/many/velocity_now.cpp  # the one at its place counts
    expect 1 course grade class
    is "$(verdict_of many)" pass
    both='velocity_now: deep/exercises/01_derivatives/velocity_now.cpp is graded, velocity_now.cpp is left out'
    says out "    $both"
    case $(says_of many) in *"$both"*) ;; *) fail "$(says_of many)" ;; esac
    is "$(says_of endless)" \
        'velocity_now: refused: the submission holds more than 20000 files and folders'
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
    rm flat/bob.cpp
    expect 0 course grade flat --one --exercise velocity_now
    cp "$mistake" flat/bob.cpp
    expect 1 course grade flat --exercise velocity_now
    says flat.grades/grades.csv '"alice_velocity.cpp",1,1,pass'
    says flat.grades/grades.csv '"bob.cpp",0,1,wrong'
    mkdir class/ida
    cp $solved class/ida/best_gap.cpp  # of another exercise, by its name
    expect 1 course grade class --exercise velocity_now
    is "$(verdict_of ida)" missing
}

test_bad_use_in_one_line() {
    mkdir empty
    for words in '' 'missing' "''" 'class --out=' 'empty' 'class --exercise none' 'class --jobs 0' 'class --seed x' \
        'class --out class/alice/velocity_now.cpp' 'class --bad' '/dev/null'; do
        # shellcheck disable=SC2086
        expect 2 course grade $words
        is "$words: $(lines err)" "$words: 1"
    done
    [ ! -e class.grades ] || fail 'there are grades'
}

# On a file system that is too small, the grades of before are still there.
test_a_full_disk_costs_nothing() {
    needs_isolation
    [ "$(id -u)" -eq 0 ] || exit 77
    mkdir small
    mount -t tmpfs -o size=64k tmpfs small 2>/dev/null || exit 77
    trap 'umount "$folder/small"' EXIT
    expect 1 course grade class --out small/grades
    cp small/grades/grades.csv before
    head -c 1000000 /dev/zero >small/filler 2>/dev/null
    hand_in dave $solved
    got=0
    course grade class --out small/grades >out 2>err || got=$?
    is "$got $(lines err)" '2 1'
    cmp -s before small/grades/grades.csv || fail 'the grades of before are gone'
    rm small/filler
    expect 1 course grade class --out small/grades
    says out '2 of 4 right'
}

words() {
    echo "env FIXTURE_SOURCE=$folder/source FIXTURE_BUILD=$folder/build FIXTURE_CMAKE=$(command -v true)" \
        "FIXTURE_CTEST=false $program"
}

program=$4 real_build=$5
begin "$@"
new_fixture
new_class
"$function"
