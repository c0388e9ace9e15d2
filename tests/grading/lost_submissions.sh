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
    # A folder that is called like a part of the course is somebody, where no course is.
    mkdir flat/kit
    expect 2 course grade flat
    says err "'kit' beside it may be another's"
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
    expect 1 course grade class
    silent_on err 'graded before'
    expect 1 course grade class
    says err ' 3 were graded before'
    for part in worker.a build/exercises/generated/velocity_now_mistakes.json; do
        echo >>$part
        expect 1 course grade class
        silent_on err 'graded before'
        says out '1 of 3 right'
    done
}

grade_class "$@"
