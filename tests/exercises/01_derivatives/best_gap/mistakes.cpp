#include "exercise.hpp"

// From one frame on, as long as one more is better, and no further than most.
static int best_of(const auto& worst, int most) {
    int frames = 1;
    while (frames < most && worst(frames + 1) < worst(frames)) ++frames;
    return frames;
}

// Says: This is the optimal step size in frames, rounded to the nearest whole number. It is almost always right.
// Hint: Compare the worst errors of one frame and of two when the optimal step size says 1.47. Which is smaller?
namespace rounded {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::round(ideal), 1.0, 1.0 * most));
}

}  // namespace rounded

// Says: The optimal step size in frames is rounded down, even where one more frame is better.
// Hint: There are two whole numbers beside the optimal step size. Let their worst errors decide.
namespace rounded_down {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::floor(ideal), 1.0, 1.0 * most));
}

}  // namespace rounded_down

// Says: The optimal step size in frames is rounded up, even where one frame less is better.
// Hint: Between a whole number and the next, either may be the best. Compute the worst error of each.
namespace rounded_up {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::ceil(ideal), 1.0, 1.0 * most));
}

}  // namespace rounded_up

// Says: The whole gap is taken for the step of the central difference, so the answer is half of what it
//       should be.
// Hint: The central difference at the middle looks one step ahead and one step back. How far apart are its
//       two positions?
namespace gap_for_step {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap * gap / 6 + noise / gap;
    };
    return best_of(worst, most);
}

}  // namespace gap_for_step

// Says: This is the bound of a backward difference, whose error grows with the gap itself, and it has the
//       jerk in place of the acceleration.
// Hint: The velocity is asked for the moment between the two frames. Which difference are they for that
//       moment, and of which order?
namespace velocity_now {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap / 2 + 2 * noise / gap;
    };
    return best_of(worst, most);
}

}  // namespace velocity_now

// Says: Beside the truncation error, the noise has half of its weight: is it that of one position alone, is it
//       divided by twice the gap, or is only one of the two factors of the half gap halved?
// Hint: At the worst, by how much does the difference of the two positions err, and by which time is it divided?
//       Then put half a gap into jerk h²/6, with brackets.
namespace noise_once {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap * gap / 24 + noise / gap;
    };
    return best_of(worst, most);
}

}  // namespace noise_once

// Says: The truncation error is a sixth of the jerk times the square of the whole gap, but the step in the
//       series is half of the gap.
// Hint: The noise is counted rightly here. In the other part, measure from the middle moment to either of
//       the two frames.
namespace one_series {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap * gap / 6 + 2 * noise / gap;
    };
    return best_of(worst, most);
}

}  // namespace one_series

// Says: The number of frames that you keep is not looked at: the answer goes beyond it.
// Hint: Where the best gap is longer than most, what is the best that you can still have?
namespace forgot_most {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    const int below = static_cast<int>(std::clamp(ideal, 1.0, 1e9));
    const double cube = ideal * ideal * ideal, half_way = (below + 0.5) * below * (below + 1.0);
    return cube > half_way ? below + 1 : below;
}

}  // namespace forgot_most

// Says: Two neighbouring frames, whatever the noise: the jagged line with which the chapter begins. Is the noise
//       not divided by the time, does a loop end at its first step, or is this a number of seconds?
// Hint: Divide twice the noise by the time of one frame, then of ten. Weigh that against what the jerk costs, and
//       see what your code makes of it.
namespace neighbours {

int best_gap(double frame, double noise, double jerk, int most) {
    return 1;
}

}  // namespace neighbours

// Says: Frames as far apart as can be, whatever the jerk. Does a loop go on where the error rises, or is the
//       truncation error missing, or zero, as by a 1 / 6 in C++?
// Hint: The truncation error grows with the square of the gap. Print it: from where on does it cost more than the
//       noise gains?
namespace farthest {

int best_gap(double frame, double noise, double jerk, int most) {
    return most;
}

}  // namespace farthest

// Says: This is the optimal step size of the central difference, rounded to whole frames. The gap between its two
//       positions is twice the step.
// Hint: A central difference looks one step ahead and one step back. You were asked for the frames from one
//       position to the other, and should choose among whole gaps, not round a step.
namespace step_rounded {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double step = std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::round(step), 1.0, 1.0 * most));
}

}  // namespace step_rounded

// Says: The optimal step size is rounded to whole frames, and the number of frames that you keep is not
//       looked at: the answer may be more than most.
// Hint: Nobody has the frame that you ask for. First keep within most, then let the errors of the two whole
//       numbers decide.
namespace rounded_beyond_most {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::round(ideal), 1.0, 1e9));
}

}  // namespace rounded_beyond_most

// Says: The time comes from a square root, but noise over jerk is seconds to the third power.
// Hint: The slope of the bound has jerk times the gap in it, and noise over its square. Multiply, and count
//       the powers.
namespace square_root {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = std::sqrt(24 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::round(ideal), 1.0, 1.0 * most));
}

}  // namespace square_root

// Says: This finds the gap with the largest error, not the one with the smallest.
// Hint: Turn the comparison round. And where must the least that you have seen begin, so that the first gap
//       is taken?
namespace largest {

int best_gap(double frame, double noise, double jerk, int most) {
    int worst = 1;
    double largest = 0;
    for (int frames = 1; frames <= most; ++frames) {
        const double gap = frames * frame, error = jerk * gap * gap / 24 + 2 * noise / gap;
        if (error > largest) {
            largest = error;
            worst = frames;
        }
    }
    return worst;
}

}  // namespace largest

// Says: This is one frame more than the best: does a loop go on one too far, or are the positions counted, the
//       first one too?
// Hint: Three positions in a row are two frames apart. And compare the worst error of your answer with that of one
//       frame less.
namespace one_more {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap * gap / 24 + 2 * noise / gap;
    };
    return std::min(best_of(worst, most) + 1, most);
}

}  // namespace one_more

// Says: It is one frame too few: does a loop end one too early, or is the best rounded down, or one taken off it?
// Hint: Compare the worst error of your answer with that of one frame more. How does your code see that, where the
//       best gap is two?
namespace one_less {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap * gap / 24 + 2 * noise / gap;
    };
    return std::max(best_of(worst, most) - 1, 1);
}

}  // namespace one_less

// Says: This is the best gap in seconds, rounded to a whole number: it has not been divided by the time of
//       a frame.
// Hint: The noise and the jerk know nothing of frames. How many of them fit into the time that you found?
namespace seconds {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double seconds = 2 * std::cbrt(3 * noise / jerk);
    return static_cast<int>(std::clamp(std::round(seconds), 1.0, 1.0 * most));
}

}  // namespace seconds

// Says: Beside the truncation error, the noise has twice its weight: is it counted twice for each position, or
//       divided by half the gap? Or are the two errors made equal, where their sum must be smallest?
// Hint: Write down both errors for a gap of one second: which factors have noise and jerk then? And for which gap
//       is the slope of their sum zero?
namespace noise_four_times {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap * gap / 24 + 4 * noise / gap;
    };
    return best_of(worst, most);
}

}  // namespace noise_four_times

// Says: The optimal step size is rounded to whole frames without any limit: it may be zero frames, or more
//       than you keep.
// Hint: Two positions are one frame apart at least. And where the best is out of reach, what is the best
//       that you can have?
namespace no_limits {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::round(std::min(ideal, 1e9)));
}

}  // namespace no_limits

// Says: The optimal step size in whole frames, and one more: these are the positions that take part, the
//       first one counted.
// Hint: From the fourth frame to the ninth it is five frames, though six positions. Which number is asked?
namespace positions_for_frames {

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::round(ideal) + 1, 1.0, 1.0 * most));
}

}  // namespace positions_for_frames

// Says: Without jerk the largest gap is the best. Here there is no optimal step size then, and the answer is one frame.
// Hint: What is noise over a jerk of zero? Look at that case before you divide.
namespace one_without_jerk {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](double n) { return jerk * n * n * frame * frame / 24 + 2 * noise / (n * frame); };
    const double ideal = std::cbrt(24 * noise / jerk) / frame;
    if (!(ideal < HUGE_VAL) || ideal < 1) return 1;
    if (ideal >= most) return most;
    const double below = std::floor(ideal);
    return static_cast<int>(worst(below) <= worst(below + 1) ? below : below + 1);
}

}  // namespace one_without_jerk

// Says: Here the larger of the two errors is as small as can be, which is where the two are about equal. Their sum
//       is smallest elsewhere.
// Hint: At the worst both errors point the same way: what do you do with them then?
namespace larger_for_sum {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double h = frames * frame / 2;
        return std::max(jerk * h * h / 6, noise / h);
    };
    int best = 1;
    for (int frames = 2; frames <= most; ++frames)
        if (worst(frames) < worst(best)) best = frames;
    return best;
}

}  // namespace larger_for_sum

// Says: This is the optimal step size in frames, rounded to the nearest whole number. And without jerk it is infinite,
//       which is no int.
// Hint: Compare the worst errors of neighbouring numbers of frames, and look at a jerk of zero first.
namespace rounded_even_without_jerk {

int best_gap(double frame, double noise, double jerk, int most) {
    const double frames = std::round(2 * std::cbrt(3 * noise / jerk) / frame);
    return frames < 2e9 ? std::clamp(static_cast<int>(frames), 1, most) : 1;
}

}  // namespace rounded_even_without_jerk

// Says: The two errors are added as if they were independent, by the root of the sum of their squares.
// Hint: The worst error is asked, where noise and truncation point the same way. What is their sum then?
namespace root_of_squares {

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return std::hypot(jerk * gap * gap / 24, 2 * noise / gap);
    };
    return best_of(worst, most);
}

}  // namespace root_of_squares

// Says: Without noise you return as many frames as you keep. That is the answer without jerk; without noise the shortest gap
//       is the best.
// Hint: Put noise = 0 into the sum of the two errors. Does what is left grow or fall with the gap?
namespace farthest_without_noise {

int best_gap(double frame, double noise, double jerk, int most) {
    if (noise == 0) return most;
    return best_of([&](int frames) { return jerk * frames * frames * frame * frame / 24 + 2 * noise / (frames * frame); }, most);
}

}  // namespace farthest_without_noise

// Says: Where a gap of no frames would be the best, as without noise, you return two frames and not one.
// Hint: Without noise neighbouring frames are best. From which number on do you try gaps, or to which do you round?
namespace two_without_noise {

int best_gap(double frame, double noise, double jerk, int most) {
    if (noise == 0) return std::min(2, most);
    return best_of([&](int frames) { return jerk * frames * frames * frame * frame / 24 + 2 * noise / (frames * frame); }, most);
}

}  // namespace two_without_noise
