// Chapter 8, exercise 3: a body leaves its pack
//
// Your game keeps the spins of its bodies in packs: so many bodies at once as the processor adds in
// one instruction. A body is shot and must go. The last body takes its place, so that no lane has a
// hole and nothing else moves.
//
//   packs    one pack after the other. A pack of width bodies is `3 * width` numbers: the $x$ of
//            all its lanes, then the $y$ of all its lanes, then the $z$. Body $b$, counted from
//            0, is in lane $b$ % width of pack $b / width$
//   width    the lanes of a pack: 1, 2, 4, 8 or 16
//   n        how many bodies there are, 1 to 1000. The packs hold them and no more: only the last
//            pack may have lanes left over. Each of those is a copy of the last body, body
//            $n − 1$
//   i        the body that goes, 0 to $n − 1$
//   returns  the packs of the $n − 1$ bodies that stay, made by the same rules
//
// So lanes left over are copies of the body that is the last now, and a pack without a body is not
// there any more. No other body changes its place, and no number is computed: all are copied.
//
// Example: of three bodies (1, 2, 3), (4, 5, 6) and (7, 8, 9), in packs of two, the first one
// goes: `despawn({1, 4, 2, 5, 3, 6, 7, 7, 8, 8, 9, 9}, 2, 3, 0)` is `{7, 4, 8, 5, 9, 6}`.
//
// What is checked: how many packs there are; which bodies stay where they were; the last body in
// its new place; the lanes left over; the last body itself goes, the one before it goes, and the
// only one goes; packs of one lane; bodies that go one after another.

#include "exercise.hpp"

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    return not_started;  // your answer
}
