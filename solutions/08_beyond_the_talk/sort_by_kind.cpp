// Chapter 8, exercise 1: sort the bodies, so that no loop asks
//
// Ten thousand bodies tumble in your game. Balls need no gyroscopic torque, tops a short formula,
// and all others a long one. In a loop that asks each body what it is, the processor guesses wrong
// again and again. So sort them by kind once, before the first step: then each group has a loop of
// its own.
//
//   kinds    what each body is: `kinds[i]` is the kind of body $i$, from 0 to $count − 1$; from
//            no body at all to 10000
//   count    how many kinds there are, 1 to 100; some may have no body
//   returns  `{order, begins}`. order[p] is the number of the body that stands at place $p$ after
//            sorting, both counted from 0. begins has $count + 1$ numbers: the bodies of kind $k$
//            stand at the places from begins[k] to before begins[k + 1], and the last number is
//            how many bodies there are
//
// Bodies of one kind stay in the order they had: a stable sort. Then the same game gives the same
// order on each machine.
//
// Example: `sort_by_kind({2, 0, 2, 0, 2}, 4)` is `{{1, 3, 0, 2, 4}, {0, 2, 2, 5, 5}}`: bodies 1
// and 3 are of kind 0, none is of kind 1, bodies 0, 2 and 4 are of kind 2, and none is of kind 3.
//
// What is checked: every body is there once; each group holds its own kind, from where it begins to
// where the next begins; bodies of one kind keep their order; kinds without a body, and no body at
// all; what is sorted stays as it is.

#include "exercise.hpp"

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>& kinds, int count) {
    // [answer]
    // How many there are of each kind, moved up by one; summed up, where the groups begin.
    const int n = static_cast<int>(kinds.size());
    std::vector<int> begins(count + 1);
    for (int kind : kinds) ++begins[kind + 1];
    for (int k = 0; k < count; ++k) begins[k + 1] += begins[k];
    // Each group's next free place.
    std::vector<int> next = begins, order(n);
    for (int i = 0; i < n; ++i) order[next[kinds[i]]++] = i;
    return {order, begins};
    // [answer]
}
