// Chapter 8, exercise 2: a replay that keeps only the spins
//
// Your game records flying wreckage. Orientations need four numbers a frame and spins three, so you
// keep only the spins, with the time of each frame, and the orientation at the first. The replay
// must find the orientation at the last frame, with an error that falls as the square of the gaps
// between the frames. From frame to frame, let the mean of the two spins turn the body: by its angle,
// by Cayley's formula or half and half, as all these are of order two.
//
//   q        orientation at the first frame, of length one: `q * v` is in world coordinates what
//            $v$ is in the body's
//   times    of the frames, in s: 1 to 1000 of them, none before the one before it, but several in
//            a row may be equal (the game was paused)
//   spins    the spin at each frame, as many as times, in the body's own axes, in rad/s; may be
//            zero
//   returns  the orientation at the last frame, of length one
//
// The frames come at uneven times. From one to the next the body turns by 0.1 radians at most.
// $q$ and $−q$ are one orientation, and you may return either. `Quaterniond(w, x, y, z)` has the
// cosine first.
//
// Example: q = `Quaterniond(1, 0, 0, 0)`, times = `{5, 5.01, 5.03}` and spins =
// `{(2, 0, 0), (4, 0, 0), (2, 0, 0)}` turn by 0.09 radians about $x$: the answer is
// `Quaterniond(0.9990, 0.0450, 0, 0)`, rounded.
//
// What is checked: one frame, a pause, no spin, and a spin that reverses in a gap; the length; a
// constant spin, about which axis and by what angle; a clock that was started at another time; two
// replays, one after the other; the replay backwards, to twelve digits; half the gaps leave a
// quarter of the error.

#include "exercise_eigen.hpp"

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    // [answer]
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d mean = (spins[i - 1] + spins[i]) / 2;
        // In the body's axes, so the turn stands on the right.
        const Vector3d turn = (times[i] - times[i - 1]) * mean;
        now = (now * Eigen::AngleAxisd(turn.norm(), turn.normalized())).normalized();
    }
    return now;
    // [answer]
}
