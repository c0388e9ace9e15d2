# What no submission in a file can hold: it needs to know where things are, or is no text.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

course() {
    FIXTURE_SOURCE=${checkout:-$source} FIXTURE_BUILD=$real_build FIXTURE_CMAKE=true FIXTURE_CTEST=false \
        "$program" "$@"
}

# The verdict on answer.cpp must be this, and the words these.
must_be() {
    course check velocity_now --file answer.cpp --json >out 2>err && fail 'it passes'
    says out "\"verdict\":\"$1\""
    course check velocity_now --file answer.cpp >out 2>err && fail 'it passes'
    says out "$2"
}

# Every way to change a file, at every place named in the file `victims`.
attack() {
    cat <<CODE
#include "exercise.hpp"
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/xattr.h>
#include <unistd.h>
static int changes = 0;
static void attempt(long result) { changes += result >= 0; }
static void attack(const std::string& victim) {
    const char* const file = victim.c_str();
    const std::string beside = victim + ".new", folder = victim.substr(0, victim.rfind('/'));
    attempt(open(file, O_WRONLY));
    attempt(open(file, O_RDWR | O_APPEND));
    attempt(open(file, O_RDONLY | O_TRUNC));
    attempt(open(beside.c_str(), O_RDONLY | O_CREAT, 0600));
    attempt(open(folder.c_str(), O_TMPFILE | O_RDWR, 0600));
    attempt(openat(AT_FDCWD, file, O_WRONLY));
    attempt(syscall(SYS_openat2, AT_FDCWD, file, nullptr, 0));
    attempt(creat(beside.c_str(), 0600));
    attempt(truncate(file, 0));
    attempt(link(file, beside.c_str()));
    attempt(symlink(file, beside.c_str()));
    attempt(mkdir(beside.c_str(), 0700));
    attempt(mkfifo(beside.c_str(), 0600));
    attempt(chmod(file, 0777));
    attempt(fchmodat(AT_FDCWD, file, 0777, AT_SYMLINK_NOFOLLOW));
    attempt(syscall(452, AT_FDCWD, file, 0777, 0));  // fchmodat2, of a newer kernel
    attempt(chown(file, 1, 1));
    attempt(utimes(file, nullptr));
    attempt(setxattr(file, "user.a", "b", 1, 0));
    attempt(rename(file, beside.c_str()));
    attempt(syscall(SYS_renameat2, AT_FDCWD, file, AT_FDCWD, beside.c_str(), 0));
    const int read_only = open(file, O_RDONLY);
    attempt(fchmod(read_only, 0777));
    attempt(fchown(read_only, 1, 1));
    attempt(futimens(read_only, nullptr));
    attempt(ftruncate(read_only, 0));
    attempt(write(read_only, file, 1));
    attempt(unlink(file));
    attempt(rmdir(folder.c_str()));
}
double velocity_now(double x0, double x1, double x2, double h) {
    static bool done = false;
$(sed 's/.*/    if (!done) attack("&");/' victims)
    if (!done) std::printf("%d changes\n", changes);
    done = true;
    return ${1:-(3 * x2 - 4 * x1 + x0) / (2 * h)};
}
CODE
}

# Names, rights, times and contents.
picture() {
    while read -r victim; do
        find "$(dirname "$victim")" -maxdepth 1 -name "$(basename "$victim")*" -printf '%p %m %u %T@\n' \
            -exec cksum {} \; -exec stat -c %Y {} \;
    done <victims
}

test_nothing_outside_of_the_checkers_folder_is_touched() {
    mkdir -p beside home source/exercises source/solutions source/tests/exercises source/chapters
    checkout=$folder/source
    cp -r "$source/chapters/01_derivatives" source/chapters
    cp -r "$source/tests/exercises/01_derivatives" source/tests/exercises
    temporary=$(mktemp /tmp/victim_XXXXXX)
    in_build=$(mktemp "$real_build/exercises/victim_XXXXXX")
    trap 'rm -f "$temporary"* "$in_build"*' EXIT
    printf '%s\n' "$folder/beside/file" "$folder/home/.profile" "$folder/source/exercises/file.cpp" \
        "$folder/source/README" "$temporary" "$in_build" >victims
    while read -r victim; do echo precious >"$victim"; done <victims
    picture >before
    attack >answer.cpp
    HOME=$folder/home expect 0 course check velocity_now --file answer.cpp
    says out '0 changes'
    picture >after
    cmp before after || { diff before after; fail 'files have changed'; }
    # And the other way round: without rules these attempts do change files.
    sed 's/^double velocity_now.*/int main() { double x0 = 0, x1 = 0, x2 = 0, h = 1;/' answer.cpp >main.cpp
    c++ -std=c++20 -w -I"$source/tools/checker/learner" -I"$source/include" main.cpp -o main
    ./main >out || true
    picture >after
    ! cmp -s before after || fail 'the attempts do nothing even where they may'
}

test_text_of_other_systems_is_right() {
    { printf '\357\273\277'; sed 's/$/\r/' "$source/solutions/01_derivatives/velocity_now.cpp"; } >answer.cpp
    expect 0 course check velocity_now --file answer.cpp
}

test_what_is_no_text() {
    solution=$source/solutions/01_derivatives/velocity_now.cpp
    head -c 300000 /dev/urandom >answer.cpp
    must_be does_not_compile 'answer.cpp:'
    for code in UTF-16 UTF-16LE UTF-16BE; do
        iconv -t $code "$solution" >answer.cpp
        must_be does_not_compile 'Save it as UTF-8'
    done
    head -c 100000 /dev/zero >answer.cpp
    must_be does_not_compile 'The file has no function'
    head -c 1000000 /dev/zero | tr '\0' '(' >answer.cpp  # no compiler bears that
    must_be does_not_compile 'does not compile'
    cp "$real_build/exercises/hidden/velocity_now" answer.cpp
    course check velocity_now --file answer.cpp >out 2>err && fail 'it passes'
    is "$(grep -vc -e "^Waiting for " -e "^Building what " err)" 1  # a slow machine is waited for
}

test_the_solution_by_other_ways() {
    solution=$source/solutions/01_derivatives/velocity_now.cpp
    for name in linked 'a$b $$(c) #d' 'back\slash\ \#' "$(printf 'a\ttab')"; do
        ln -s "$solution" "$name.hpp"
    done
    for name in "$solution" "$folder"/*.hpp "$source/tests/../solutions/./01_derivatives/velocity_now.cpp"; do
        printf '#include "%s"\n' "$name" >answer.cpp
        must_be does_not_compile 'The file includes solutions/01_derivatives/velocity_now.cpp.'
    done
}

# No list for make tells where these names end. What it seems to say is there, too, and harmless.
test_names_that_no_list_can_hold() {
    solution=$source/solutions/01_derivatives/velocity_now.cpp
    for name in 'ends in\' 'ends in two\\' 'ends\ in\ a\' '\'; do
        ln -s "$solution" "$name"
        : >"${name%\\} "
        printf '#include "%s"\n' "$name" >answer.cpp
        must_be does_not_compile 'The file includes solutions/01_derivatives/velocity_now.cpp.'
    done
    rm '\'
    newline='
'
    # What stands below build/tests, as this test's folder does, is the course's own.
    outside=$(mktemp -d)
    trap 'rm -r "$outside"' EXIT
    cd "$outside"
    : >new
    for name in "new${newline}line" "and${newline} blanks\\" "back\\$newline" "all\\ \\$newline of"; do
        mkdir "$name"
        ln -s "$solution" "$name/name.hpp"
        echo '#include "name.hpp"' >"$name/answer.cpp"
        course check velocity_now --file "$name/answer.cpp" >out 2>err && fail 'it passes'
        says out 'The file includes solutions/01_derivatives/velocity_now.cpp.'
        cp "$solution" "$name/answer.cpp"
        expect 0 course check velocity_now --file "$name/answer.cpp"
    done
}

test_bytes_of_the_course() {
    grep -q incbin "$real_build/exercises/commands.json" || exit 77
    for name in "$source/solutions/01_derivatives/velocity_now.cpp" "$real_build/exercises/hidden/velocity_now" \
        "$source/tests/exercises/01_derivatives/velocity_now/properties.cpp"; do
        {
            echo '#include "exercise.hpp"'
            echo "asm(\".data\n.global bytes\nbytes: .incbin \\\"$name\\\"\n.text\");" |
                sed ':a;N;$!ba;s/\n/\\n/g'
            echo 'double velocity_now(double, double, double, double) { return 0; }'
        } >answer.cpp
        must_be does_not_compile 'The file includes '
    done
}

test_a_pipe_that_is_included() {
    mkfifo pipe
    echo "#include \"$folder/pipe\"" >answer.cpp
    must_be does_not_compile 'The compiler waits for something that does not come.'
}

# Ten digits do not tell what float does from what is right: then more are printed.
test_a_call_that_is_shown_is_wrong_as_it_is_printed() {
    sed 's/points\[i\]\[1\] < points\[worth/float(points[i][1]) < float(points[worth/; s/points\[i\] == points\[worth.back()\]/(points[i][0] == points[worth.back()][0] \&\& float(points[i][1]) == float(points[worth.back()][1]))/; s/\(worth.back()\]\[1\]\) ||/\1) ||/' \
        "$source/solutions/07_error_against_run_time/worth_having.cpp" >answer.cpp
    is "$(grep -c float answer.cpp)" 2
    for seed in 16146074820862296456 1 2 3; do
        expect 1 course check worth_having --file answer.cpp --seed $seed
        shown=$(tr '\n' ' ' <out | tr -s ' ' | sed 's/.*worth_having({{\([^)]*\)}}).*/\1/; s/}, {/;/')
        case $shown in *[0-9]\;[0-9]*) ;; *) fail "no two settings: $shown" ;; esac
        [ "${shown%;*}" != "${shown#*;}" ] || fail "seed $seed: twice {$shown}"
    done
}

test_a_wrong_result_does_not_look_right() {
    sed 's|/ 2;|/ 2 + 3e-11 * newer;|' "$source/solutions/01_derivatives/velocity_now.cpp" >answer.cpp
    for seed in 1 2 3; do
        expect 1 course check velocity_now --file answer.cpp --seed $seed
        shown=$(tr '\n' ' ' <out | tr -s ' ' | sed 's/.* returned \([^ ]*\)[; ].*/\1/')
        [ ${#shown} -gt 11 ] || fail "seed $seed: $shown"
    done
}

program=$4 real_build=$5
begin "$@"
"$function"
