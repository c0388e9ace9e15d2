// Chapter 7, exercise 2: does the replay still fit?
//
// Every night your game's physics replays a flight and compares it with the recorded truth, at some
// marks. If it is too far off, somebody broke it. Errors are shares of the size of the scene: in a
// scene of 20 m, 0.2 m are 0.01.
//
//   x          heights at the marks, as replayed, in metres; some may be NaN or infinite, and there
//              are fewer than in exact, perhaps none, if the replay broke off
//   exact      true heights at the same marks, in metres: one or more, all finite
//   size       of the scene, in metres (1e-4 to 1e5)
//   accuracy   the largest error that is allowed, as a share of the size (0, or 1e-9 to 1)
//   returns    true if the replay is within the accuracy at every mark, and has every mark; false
//              if not
//
// An error as large as the accuracy, to the last bit, is within. A height that is NaN or infinite
// is not, whatever the accuracy.
//
// Example: `replay_fits({3, 5.5, 1}, {3, 5, 1}, 20, 0.01)` is false: in the middle 0.5 m are
// 0.025. With an accuracy of 0.1 it is true.
//
// What is checked: a perfect replay; replays off everywhere by more and by less than is allowed, to
// either side; one bad mark, be it the first, the last or between; NaN and infinities at each of
// these; replays that broke off; errors just as large as the accuracy, and larger by a hair; other
// units, and flights moved to another height.

#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    // [answer]
    if (x.size() != exact.size()) return false;
    for (std::size_t mark = 0; mark < x.size(); ++mark) {
        const double error = std::fabs(x[mark] - exact[mark]);
        if (!(error <= accuracy * size)) return false;  // NaN is not at most anything
    }
    return true;
    // [answer]
}
