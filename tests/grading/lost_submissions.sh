# Nobody is lost: neither among the submissions, nor by a name, nor behind an old grade.

. "$(dirname "$0")/class.sh"

# refused STRAY OTHER: with that in the class, and that beside it, it is asked what is meant; nothing is graded.
refused() {
    expect 2 course grade class
    is "$(lines err) $(lines out)" '1 0'
    is "$(cat err)" "course: class: '$1' in it makes it one submission, and '$2' beside it may be another's: \
if it is one, ./course grade class --one; if it is a class, take '$1' out of it"
    [ ! -e class.grades ] || fail 'there are grades'
}

test_a_folder_named_exercises_beside_students_is_asked_about() {
    mkdir class/exercises
    refused exercises alice
    mkdir class/exercises/01_derivatives
    cp $solved class/exercises/01_derivatives/velocity_now.cpp
    refused exercises alice
    rm -r class/alice class/bob/velocity_now.cpp class/carol  # he has handed in nothing yet, and is somebody
    refused exercises bob
}

test_anything_named_exercises_beside_students_is_asked_about() {
    for odd in ': >' 'ln -s nowhere' 'ln -s alice' mkfifo; do
        eval "$odd class/exercises"
        refused exercises alice
        rm class/exercises
    done
}

test_one_answer_beside_students_is_asked_about() {
    cp $solved class/velocity_now.cpp
    refused velocity_now.cpp alice
    # Beside folders of which none holds what is looked for, and beside files.
    rm -r class/*
    mkdir class/alice class/bob
    echo 'double f();' >class/alice/homework.cpp
    cp $solved class/velocity_now.cpp
    refused velocity_now.cpp alice
    for beside in alice.cpp bob.zip carol.tar.gz; do
        rm -r class/*
        : >"class/$beside"
        cp $solved class/velocity_now.cpp
        refused velocity_now.cpp $beside
    done
}

test_the_command_that_is_named_does_what_it_says() {
    needs_isolation
    mv class "it's a class"
    cp $solved "it's a class/velocity_now.cpp"
    expect 2 course grade "it's a class"
    named=$(sed -n "s/.*if it is one, \(.*\); if it is a class.*/\1/p" err)
    is "$named" "./course grade 'it'\\''s a class' --one"
    eval "set -- ${named#./course }"
    rm -r "it's a class"/*/
    expect 0 course "$@"
}

# A class one folder further down than was named would be one submission, too.
test_a_class_further_down_is_asked_about() {
    for name in exercises everybody; do
        mkdir parent
        mv class "parent/$name"
        cp -r "parent/$name" class
        rm class/bob/velocity_now.cpp
        : >"parent/$name/notes.txt"
        expect 2 course grade parent
        is "$(cat err)" "course: parent: '$name' in it may be a class, with 'alice' and 'bob': if it is, \
./course grade parent/$name; if it is one submission, ./course grade parent --one"
        rm -r parent
        cp $solved class/bob/best_gap.cpp  # other exercises than the first's
    done
    # Folders of one's own are no class.
    mkdir -p one/exercises/01_derivatives one/exercises/02_first_order_form two/drafts/first two/drafts/.second
    cp $solved one/exercises/01_derivatives
    cp $stub one/exercises/02_first_order_form
    cp $solved two/drafts/first
    cp $solved two/drafts/.second
    for own in one two; do expect 0 course grade $own --trust; done
}

# What belongs to one submission is nobody else's: a kit of the course, other exercises, hidden files.
test_one_submission_stays_one() {
    needs_isolation
    mkdir -p one/.git one/exercises/01_derivatives
    cp $solved one/exercises/01_derivatives/velocity_now.cpp
    expect 0 course grade one
    for part in chapters docs include/timestep tools kit site build .progress/answers .github/workflows; do
        mkdir -p "one/$part"
    done
    touch one/course one/CMakeLists.txt one/CMakePresets.json one/LICENSE one/README.md one/.gitignore
    cp $solved one/.progress/answers/velocity_now_1.cpp
    cp $solved one/tools/main.cpp
    expect 0 course grade one
    silent_on out 'README.md'
    expect 0 course grade one --exercise velocity_now
    : >one/notes.txt
    mkdir one/.kim
    expect 0 course grade one
    says out 'Left out: .git, .kim, notes.txt'
    mkdir one/kim
    expect 2 course grade one
    says err "'kim' beside it may be another's"
    mkdir flat
    cp $solved flat/velocity_now.cpp
    cp $stub flat/best_gap.cpp
    expect 0 course grade flat --exercise velocity_now
    # A folder that is called like a part of the course is somebody, where no course is.
    mkdir flat/kit
    expect 2 course grade flat
    says err "'kit' beside it may be another's"
}

test_what_is_left_out_is_named() {
    needs_isolation
    mkdir class/.git class/__MACOSX class/.svn
    : >class/.DS_Store
    : >class/Thumbs.db
    : >class/._alice
    expect 1 course grade class
    says out '1 of 3 right'
    says out 'Left out: .DS_Store, ._alice, .git, .svn, Thumbs.db, __MACOSX'
    is "$(lines class.grades/grades.csv)" 4
    rm -r class/alice class/bob class/carol
    expect 2 course grade class
    is "$(cat err)" 'course: class: holds no submission, only .DS_Store, ._alice, .git, .svn, Thumbs.db, __MACOSX'
    expect 1 course grade class --one
    # A folder of such a name that holds an answer may be somebody's.
    hand_in __MACOSX $solved
    expect 2 course grade class
    says err "'__MACOSX' holds an answer"
}

# refused_with NAME TEXT: that is the grade of NAME, and it says so; nobody else has lost his.
refused_with() {
    is "$1 $(verdict_of "$1")" "$1 refused"
    case $(says_of "$1") in *"velocity_now: refused: $2"*) ;; *) fail "$1: $(says_of "$1")" ;; esac
    says out "velocity_now: refused: $2"
    is "$(verdict_of alice)" pass
}

test_an_answer_in_a_folder_that_is_left_out_is_named() {
    needs_isolation
    for place in gus/__MACOSX fay/.git hal/src/.hidden/deep ivy/.svn; do
        mkdir -p class/$place
        cp $solved class/$place/velocity_now.cpp
    done
    cp $solved class/ivy/velocity_now.cpp  # who has one where it is looked for, too
    mkdir class/ivy/.DS_Store class/gus/.DS_Store
    expect 1 course grade class
    refused_with gus "__MACOSX/velocity_now.cpp lies where nothing is graded, in '__MACOSX': move it"
    refused_with fay ".git/velocity_now.cpp lies where nothing is graded, in '.git': move it"
    refused_with hal "src/.hidden/deep/velocity_now.cpp lies where nothing is graded, in 'src/.hidden': move it"
    is "$(verdict_of ivy)" pass
    says out 'Left out: 2 times .DS_Store in submissions, fay/.git, hal/src/.hidden, ivy/.svn, gus/__MACOSX'
    # Where one exercise is asked for and another file could be its answer, too.
    cp $mistake class/gus/main.cpp
    expect 1 course grade class --exercise velocity_now
    refused_with gus '__MACOSX/velocity_now.cpp lies'
    # As one submission: what lies in it is named once.
    expect 1 course grade class/fay --one
    says out "velocity_now: refused: .git/velocity_now.cpp lies where nothing is graded, in '.git': move it"
    is "$(grep -c 'Left out: .git$' out)" 1
}

test_an_answer_in_other_letters_is_named() {
    needs_isolation
    mkdir class/gus class/fay
    cp $solved class/gus/Velocity_Now.CPP
    cp $solved class/fay/velocity_now.cpp
    cp $mistake class/fay/VELOCITY_NOW.cpp
    cp $solved class/Velocity_now.cpp
    expect 1 course grade class
    refused_with gus 'Velocity_Now.CPP must be named velocity_now.cpp, in exactly these letters: rename it'
    refused_with Velocity_now.cpp 'Velocity_now.cpp must be named velocity_now.cpp, in exactly these letters: rename it'
    is "$(verdict_of fay)" pass
    says out '    velocity_now: velocity_now.cpp is graded, VELOCITY_NOW.cpp is left out'
    # Of one exercise the only file of C++ is the answer, whatever it is called.
    rm class/Velocity_now.cpp class/fay/VELOCITY_NOW.cpp
    expect 1 course grade class --exercise velocity_now
    is "$(verdict_of gus)" pass
    cp $solved class/gus/main.cpp
    expect 1 course grade class --exercise velocity_now
    refused_with gus 'Velocity_Now.CPP must be named'
}

test_other_endings_of_cpp_are_taken_and_others_named() {
    needs_isolation
    for name in velocity_now.cc velocity_now.CPP velocity_now.cxx velocity_now.C++; do
        mkdir "class/of_$name"
        cp $solved "class/of_$name/$name"
    done
    mkdir class/text class/two
    cp $solved class/text/velocity_now.txt
    cp $solved class/two/velocity_now.cpp
    cp "$mistake" class/two/velocity_now.cc
    expect 1 course grade class
    for name in velocity_now.cc velocity_now.CPP velocity_now.cxx velocity_now.C++; do is "$name $(verdict_of "of_$name")" "$name pass"; done
    refused_with text 'velocity_now.txt does not have the name of a C++ file: rename it to velocity_now.cpp'
    refused_with two '2 files answer it, velocity_now.cc and velocity_now.cpp, and exercises/01_derivatives does not hold exactly one of them: keep only one'
    # One file is a submission, too.
    expect 0 course grade class/of_velocity_now.cc/velocity_now.cc
}

# An archive that was packed on a Mac brings of each file another, which is none.
test_what_a_mac_leaves_hides_no_answer() {
    needs_isolation
    mkdir -p class/dora/__MACOSX
    cp $solved class/dora/main.cpp
    : >class/dora/__MACOSX/._main.cpp
    : >class/dora/._main.cpp
    expect 1 course grade class --exercise velocity_now
    is "$(verdict_of dora)" pass
}

# Pairs that one way of writing or another makes one of: the raw bytes of the first against the second's.
test_names_that_differ_stay_different() {
    needs_isolation
    command -v python3 >/dev/null || exit 77
    rm -r class/*
    i=0
    for name in '\377' '%%FF' '\\\\xff' '\\\\\\\\xff' '\376' \
        'u\342\200\256v' 'u\342\200\255v' 'u???v' 'u?v' '\357\277\276' '\357\277\277' '?' '\357\277\275' \
        '\355\240\200' '\355\240\201' '\340\200\257' '\360\200\200\257' '\364\220\200\200' '\364\220\200\201' \
        'tab\t' 'tab\\\\t' 'tab ' 'tab' ' tab' 'new\nline' 'new\\\\nline' '\001' '\002' '\177' '\302\205' '\302\206' \
        '=1' "'=1" "''=1" 'z\342\200\213w' 'zw' 'z\357\273\277w' 'z\302\255w' 'a&b' 'a&amp;b' '"q"' '""q""' \
        'cr\r' 'cr\\\\r' '\033[2J' '\342\200\250' '\342\200\251' '\363\240\201\201'; do
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
    expect 1 course grade class
    says err " $i were graded before"
}

# What a verdict depends on besides the answer, changed: nothing of before counts.
test_a_changed_checker_makes_old_grades_stale() {
    needs_isolation
    own_build
    rm build/exercises/generated
    cp -r "$real_build/exercises/generated" build/exercises/generated
    words='s|.*"worker": "\(.*\)",$|\1|p'
    cp "$(sed -n "$words" build/exercises/commands.json)" worker.a
    sed -i "s|\"worker\": \".*\"|\"worker\": \"$folder/worker.a\"|" build/exercises/commands.json
    cp "$program" course_program
    program=$folder/course_program
    expect 1 course grade class
    silent_on err 'graded before'
    expect 1 course grade class
    says err ' 3 were graded before'
    for part in worker.a course_program build/exercises/generated/velocity_now_mistakes.json \
        build/exercises/generated/velocity_now_declared.hpp build/exercises/commands.json \
        source/tests/exercises/01_derivatives/velocity_now/about.json; do
        echo >>$part
        expect 1 course grade class
        silent_on err 'graded before'
        says out '1 of 3 right'
        expect 1 course grade class
        says err ' 3 were graded before'
    done
}

program=$4 real_build=$5
begin "$@"
new_fixture
new_class
"$function"
