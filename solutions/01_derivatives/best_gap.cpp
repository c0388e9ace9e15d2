// Chapter 1, exercise 6: which two frames to subtract
//
// Another player throws a ball, and your game takes its velocity from two positions that arrived
// some frames apart: their difference, divided by the time between them. You use it as the
// velocity of the moment in the middle. Frames too close divide the noise by too short a time,
// frames too far cut off too much. How many frames apart should the two be?
//
//   frame        time between two frames, in seconds (above zero)
//   noise        how far off each position may be, to either side, in metres (zero or more)
//   jerk         the largest |x‴|, the third derivative of the position by time, in metres per
//                second cubed (zero or more; noise and jerk are not both zero)
//   most         you keep so many frames that the two are at most this far apart (1 or more)
//   returns      the number of frames from one position to the other, at least 1 and at most most,
//                for which the worst error of the velocity is smallest
//
// The worst error is, as in the chapter, the sum of two: the leading term of what the formula cuts
// off, with the largest jerk, and the noise at its worst in both positions. Where two numbers of
// frames are equally good, return either.
//
// Example: `best_gap(0.01, 0.0005, 12, 60)` is 10. The same with $most = 8$ is 8.
//
// What is checked: without noise, neighbouring frames; without jerk, frames as far apart as can
// be; no other number of frames has a smaller worst error, also where the optimal step size lies
// between two whole numbers, and where thousands of frames lie in between; on a real swing with the
// worst noise, no other number is much better.

#include "exercise.hpp"

int best_gap(double frame, double noise, double jerk, int most) {
    // [answer]
    // A central difference whose step is half the gap.
    const auto worst = [&](int frames) {
        const double h = frames * frame / 2;
        return jerk * h * h / 6 + noise / h;
    };
    int frames = 1;
    while (frames < most && worst(frames + 1) < worst(frames)) ++frames;  // it falls, then it rises
    return frames;
    // [answer]
}
