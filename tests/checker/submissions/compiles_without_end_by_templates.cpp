// velocity_now does_not_compile: had not come to an end after 9 s of work
#include "exercise.hpp"

template <int depth, long path>
struct Tree {
    static constexpr int size =
        Tree<depth - 1, 2 * path>::size + Tree<depth - 1, 2 * path + 1>::size;
};
template <long path>
struct Tree<0, path> {
    static constexpr int size = 1;
};

double velocity_now(double, double, double, double) {
    return Tree<40, 1>::size;
}
