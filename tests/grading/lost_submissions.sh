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
    # And beside files.
    rm -r class/*
    : >class/bob.zip
    cp $solved class/velocity_now.cpp
    refused velocity_now.cpp bob.zip
}

# A class one folder further down than was named would be one submission, too.
test_a_class_further_down_is_asked_about() {
    mkdir parent
    mv class parent/everybody
    cp $solved parent/everybody/bob/best_gap.cpp
    rm parent/everybody/bob/velocity_now.cpp
    expect 2 course grade parent
    is "$(cat err)" "course: parent: 'everybody' in it may be a class, with 'alice' and 'bob': if it is, \
name that folder; if it is one submission, ./course grade parent --one"
}

# What lies in a folder that is left out, however much, refuses no answer.
test_what_is_left_out_refuses_nobody() {
    needs_isolation
    mkdir -p class/alice/.git
    (cd class/alice/.git && seq 20001 | xargs touch)
    : >class/alice/.git/velocity_now
    expect 1 course grade class --exercise velocity_now
    silent_on out 'refused'
}

# What belongs to one submission is nobody else's: other exercises, hidden files, a whole kit.
test_one_submission_stays_one() {
    mkdir -p one/.git one/.kim one/exercises/01_derivatives kit/include/timestep kit/exercises/01_derivatives kit/docs
    cp $solved one/exercises/01_derivatives/velocity_now.cpp
    cp $solved kit/exercises/01_derivatives/velocity_now.cpp
    : >one/notes.txt
    : >kit/course
    expect 0 course grade one --trust
    says out 'Left out: .git, .kim'
    expect 0 course grade kit --trust
    mkdir one/kim
    expect 2 course grade one
    says err "'kim' beside it may be another's"
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
