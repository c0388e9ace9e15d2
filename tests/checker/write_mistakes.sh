# The program that makes C++ of mistakes.diff refuses a wrong list of edits (every exercise tests what it makes):
#   sh write_mistakes.sh FUNCTION FOLDER SOURCE WRITE_MISTAKES

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

# refused EXPRESSION WORDS: with mistakes.diff edited by sed, the program says one line with these words, and writes nothing.
refused() {
    sed -i.bak "$1" mistakes.diff
    cmp -s mistakes.diff mistakes.diff.bak && fail "$1 changes nothing"
    expect 2 "$write_mistakes" velocity_now . solution.cpp correct.cpp mistakes.diff
    says err "$2"
    is "$(lines err)" 1
    [ ! -e velocity_now_mistakes.hpp ] || fail 'something is written'
    mv mistakes.diff.bak mistakes.diff
}

test_a_list_of_edits_that_is_wrong_is_refused_by_its_line() {
    room=$source/tests/exercises/01_derivatives/velocity_now
    cp "$room/mistakes.diff" "$room/correct.cpp" .
    cp "$source/solutions/01_derivatives/velocity_now.cpp" solution.cpp
    refused 's/^-    const double older = .*/-    return 2;/' "mistakes.diff:7: '    return 2;' must stand once in the solution"
    refused 's/(from weights)/(from way_5)/' "short_step_is_none: there is no answer 'way_5' above it"
    refused 's/(from weights)/(of weights)/' 'behind the name may stand (from ANOTHER) or (anew)'
    refused 's/^@@ middle$/@@ two_frames/' 'two_frames is the name of another mistake'
    refused 's/^Hint: It has order one.*//' "two_frames has no line 'Hint"
    refused '/^@@ forgot_h/,$d' 'must hold four mistakes or more'
}

begin "$1" "$2" "$3"
write_mistakes=$4
"$1"
