# What the program refuses that makes C++ of mistakes.diff (what it makes is tested with every exercise):  sh write_mistakes.sh FUNCTION FOLDER SOURCE WRITE_MISTAKES

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../tools/expect.sh"

# An exercise with two right answers and four mistakes, in the folder.
new_exercise() {
    cat >solution.cpp <<'END'
// The task.
#include "exercise.hpp"

double twice(double x) {
    // [answer]
    const double sum = x + x;
    return sum;
    // [answer]
}
END
    cat >correct.cpp <<'END'
namespace product {
double twice(double x) {
    return 2 * x;
}
}  // namespace product

namespace left_over {
double twice(double x) {
    return 3 * x - x;
}
}  // namespace left_over
END
    cat >mistakes.diff <<'END'
For readers.
+constexpr int for_all = 1;

@@ once
Says: That is
      "once".
Hint: Add one more.
-    const double sum = x + x;
+    const double sum = x;

@@ thrice (from product)
Says: That is thrice.
Hint: A factor is too large.
-    return 2 * x;
+    return 3 * x;

@@ thrice_and_more (from thrice)
Says: That is thrice, and one.
Hint: Two things are wrong.
-    return 3 * x;
+    return 3 * x + 1;

@@ nothing (anew)
Says: That is nothing.
Hint: Begin.
+double twice(double) {
+    return 0;
+}
END
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
    refused 's/^-    const double sum = x + x;/-    double sum = x + x;/' "mistakes.diff:8: '    double sum = x + x;' must stand once in the solution"
    refused 's/^-    const double sum.*//' 'mistakes.diff:9: no line says where these are put in'
    refused 's/(from product)/(from sum)/' "mistakes.diff:11: thrice: there is no answer 'sum' above it"
    refused 's/(from product)/(of product)/' 'behind the name may stand (from ANOTHER) or (anew)'
    refused 's/^@@ thrice (/@@ once (/' 'once is the name of another mistake'
    refused 's/^Says: That is thrice.$//' "thrice has no line 'Says"
    refused 's/^Hint: Begin.$//' "nothing has no line 'Hint"
    refused 's/^Hint: Begin.$/Hint: Add one more./' 'its Hint is that of another mistake'
    refused 's/^@@ nothing (anew)/@@ nothing/' 'no line says where these are put in'
    refused '/^@@ nothing/,$d' 'must hold four mistakes or more'
    refused 's/^Hint: Begin.$/Hint: Begin.\nAnd go on./' 'must begin with @@, Says:, Hint:, -, + or ='
    refused '/^+double twice/,$d' 'nothing changes nothing'
    sed -i '/^namespace left_over/,$d' correct.cpp
    refused 's/ANY/ANY/; s/Begin/Start/' 'correct.cpp: must hold two right answers or more'
}

begin "$1" "$2" "$3"
write_mistakes=$4
"$1"
