# A class: submissions of velocity_now, graded on a fixture of its own.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"
. "$here/../checker/fixture.sh"

# hand_in NAME FILE: a submission that is a folder.
hand_in() {
    mkdir -p "class/$1"
    cp "$2" "class/$1/velocity_now.cpp"
}

new_class() {
    stub=$folder/source/exercises/01_derivatives/velocity_now.cpp
    hand_in alice $solved
    hand_in bob "$mistake"
    hand_in carol $stub
}

# answer NAME: a submission with these lines in the function, right as far as its number goes.
answer() {
    mkdir -p "class/$1"
    cat >"class/$1/velocity_now.cpp" <<CODE
#include "exercise.hpp"
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
extern char** environ;
double velocity_now(double x0, double x1, double x2, double h) {
    static bool first = true;
    if (first) {
        first = false;
        $(cat)
    }
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
CODE
}

# verdict_of NAME, says_of NAME: as grades.json has them.
verdict_of() { sed -n "/\"submission\": \"$1\"/,/}/s/.*\"verdict\": \"\(.*\)\",/\1/p" class.grades/grades.json; }
says_of() { sed -n "/\"submission\": \"$1\"/,/}/s/.*\"says\": \"\(.*\)\",/\1/p" class.grades/grades.json; }

needs_isolation() {
    command -v bwrap >/dev/null && bwrap --ro-bind / / --unshare-all true 2>/dev/null && return
    echo 'bubblewrap is missing, or may not isolate here'
    exit 77
}

# grade_class FUNCTION FOLDER SOURCE COURSE BUILD: the test, with a class to grade.
grade_class() {
    program=$4 real_build=$5
    begin "$@"
    new_fixture
    new_class
    "$function"
}
