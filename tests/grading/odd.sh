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
    expect 1 timeout 120 $(words) grade class
    for name in link folder fifo linked big device two archive.zip; do
        case $name in linked | archive.zip) continue ;; esac
        is "$name $(verdict_of $name)" "$name refused"
    done
    is "$(says_of link)" 'velocity_now: refused: velocity_now.cpp is a link, and links are not followed'
    is "$(says_of big)" 'velocity_now: refused: velocity_now.cpp is larger than 1 MB'
    is "$(says_of fifo)" 'velocity_now: refused: velocity_now.cpp is no regular file'
    case $(says_of two) in *'2 files are named velocity_now.cpp'*) ;; *) fail "$(says_of two)" ;; esac
    is "$(verdict_of far)" missing
    is "$(verdict_of linked)" missing
    is "$(verdict_of archive.zip)" missing
    expect 1 course grade class --exercise velocity_now
    case $(says_of linked) in *'is a link'*) ;; *) fail "$(says_of linked)" ;; esac
    case $(says_of archive.zip) in *'unpacked first'*) ;; *) fail "$(says_of archive.zip)" ;; esac
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
    expect 1 course grade flat --one --exercise velocity_now
    says out 'nothing was handed in'
    expect 1 course grade flat --exercise velocity_now
    says flat.grades/grades.csv '"alice_velocity.cpp",1,1,pass'
    says flat.grades/grades.csv '"bob.cpp",0,1,wrong'
}

test_bad_use_in_one_line() {
    mkdir empty
    for words in '' 'missing' 'empty' 'class --exercise none' 'class --jobs 0' 'class --seed x' \
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
    echo "env STAGE_SOURCE=$folder/source STAGE_BUILD=$folder/build STAGE_CMAKE=$(command -v true)" \
        "STAGE_CTEST=false $program"
}

program=$4 real_build=$5
begin "$@"
new_stage
new_class
"$function"
