# The program that makes C++ of mistakes.diff refuses a wrong list of edits (every exercise tests what it makes):
#   sh write_mistakes.sh FUNCTION FOLDER SOURCE WRITE_MISTAKES

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

# An exercise with two right answers and four mistakes, in the folder.
new_exercise() {
    printf '%s\n' '#include "exercise.hpp"' '' 'double twice(double x) {' '    // [answer]' '    return x + x;' '    // [answer]' '}' >solution.cpp
    for way in '2 * x' '3 * x - x'; do
        printf '%s\n' "namespace way_${way%% *} {" 'double twice(double x) {' "    return $way;" '}' "}  // namespace way_${way%% *}"
    done >correct.cpp
    cat >mistakes.diff <<'DIFF'
@@ once
Says: That is once.
Hint: Add one more.
-    return x + x;
+    return x;

@@ four_times (from way_2)
Says: That is four times.
Hint: A factor is too large.
-    return 2 * x;
+    return 4 * x;

@@ four_times_and_more (from four_times)
Says: That is four times, and one.
Hint: Two things are wrong.
-    return 4 * x;
+    return 4 * x + 1;

@@ nothing (anew)
Says: That is nothing.
Hint: Begin.
+double twice(double) { return 0; }
DIFF
}
# refused EXPRESSION WORDS: with mistakes.diff edited by sed, the program says one line with these words, and writes nothing.
refused() {
    sed -i.bak "$1" mistakes.diff
    cmp -s mistakes.diff mistakes.diff.bak && fail "$1 changes nothing"
    expect 2 "$write_mistakes" twice . solution.cpp correct.cpp mistakes.diff
    says err "$2"
    is "$(lines err)" 1
    [ ! -e twice_mistakes.hpp ] || fail 'something is written'
    mv mistakes.diff.bak mistakes.diff
}

test_a_list_of_edits_that_is_wrong_is_refused_by_its_line() {
    new_exercise
    refused 's/^-    return x + x;/-    return 2;/' "mistakes.diff:4: '    return 2;' must stand once in the solution"
    refused 's/^-    return x + x;//' 'mistakes.diff:5: no line says where these are put in'
    refused 's/(from way_2)/(from way_5)/' "mistakes.diff:7: four_times: there is no answer 'way_5' above it"
    refused 's/(from way_2)/(of way_2)/' 'behind the name may stand (from ANOTHER) or (anew)'
    refused 's/^@@ four_times (/@@ once (/' 'once is the name of another mistake'
    refused 's/^Hint: Begin.$//' "nothing has no line 'Hint"
    refused 's/^Hint: Begin.$/Hint: Add one more./' 'its Hint is that of another mistake'
    refused '/^@@ nothing/,$d' 'must hold four mistakes or more'
    refused 's/^Hint: Begin.$/Hint: Begin.\nAnd go on./' 'must begin with @@, Says:, Hint:, -, + or ='
    refused '/^+double twice/,$d' 'nothing changes nothing'
}

begin "$1" "$2" "$3"
write_mistakes=$4
"$1"
