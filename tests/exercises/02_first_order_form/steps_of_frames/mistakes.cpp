#include "exercise.hpp"

#include <functional>

// Frame by frame, with the time that is owed: `take` it, and say how many steps these are.
static std::vector<int> each_frame(const std::vector<double>& frames, const std::function<int(double&)>& take) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) steps.push_back(take(owed += passed));
    return steps;
}

// Says: Each frame counts its steps for itself: the part of a step that remains is forgotten.
// Hint: Frames shorter than a step would never take one. What must a frame hand on to the next?
namespace no_remainder {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    for (const double passed : frames)
        steps.push_back(std::min(static_cast<int>(passed / step), most_steps));
    return steps;
}

}  // namespace no_remainder

// Says: A step that is owed in full has to wait for the next frame: the comparison is strict.
// Hint: What should happen when exactly one step is owed?
namespace late_when_exact {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        int count = 0;
        for (owed += passed; owed > step; owed -= step)
            if (count < most_steps) ++count;
        steps.push_back(count);
    }
    return steps;
}

}  // namespace late_when_exact

// Says: A step comes when it is nearly owed in full: there is a tolerance, in a comparison or before a rounding,
//       and the simulation gets ahead of the clock by it.
// Hint: Compare what is owed with the step, without any slack. A step that lacks a billionth of a second
//       comes with the next frame.
namespace with_a_tolerance {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        int count = 0;
        for (; owed >= step - 1e-9 && count < most_steps; ++count) owed -= step;
        owed = std::fmod(owed, step);
        return count;
    });
}

}  // namespace with_a_tolerance

// Says: A step that is nearly owed is taken: what is owed is kept in single precision, or compared with a tolerance.
// Hint: A float has seven digits, a double sixteen. To the last of them: is the step owed in full?
namespace single_precision {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    float owed = 0;
    for (const double passed : frames) {
        owed += static_cast<float>(passed);
        int count = 0;
        for (; owed >= static_cast<float>(step); owed -= static_cast<float>(step))
            if (count < most_steps) ++count;
        steps.push_back(count);
    }
    return steps;
}

}  // namespace single_precision

// Says: A frame takes one step at most, however many it owes: does an if stand where a loop should, or does the
//       loop end after its first round?
// Hint: A slow frame owes several steps, and pays all of them at once, up to the cap.
namespace one_at_most {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const int taken = owed >= step ? 1 : 0;
        owed = std::fmod(owed, step);
        return taken;
    });
}

}  // namespace one_at_most

// Says: The number of steps is rounded to the nearest, so the simulation is ahead of the clock half of the
//       time.
// Hint: Only whole steps that have passed are taken: which way must a fraction be rounded?
namespace rounded {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const int due = static_cast<int>(std::lround(owed / step));
        const int taken = std::min(due, most_steps);
        owed -= due * step;
        return taken;
    });
}

}  // namespace rounded

// Says: The remainder is right, but the steps are rounded to the nearest: half a step that is owed is taken
//       too soon, and once more when it is owed in full.
// Hint: std::round goes up from one half on. Which function always goes down?
namespace rounded_to_the_nearest {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const double due = std::round(owed / step);
        const int taken = static_cast<int>(std::min<double>(due, most_steps));
        owed = std::fmod(owed, step);
        return taken;
    });
}

}  // namespace rounded_to_the_nearest

// Says: A step that is owed in full is not taken, and then it is dropped with what the cap leaves: it never comes.
// Hint: After the loop, less than a step must be owed, unless the cap has stopped it. Which comparison sees
//       to that?
namespace lost_when_exact {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        int count = 0;
        for (; owed > step && count < most_steps; ++count) owed -= step;
        owed = std::fmod(owed, step);
        return count;
    });
}

}  // namespace lost_when_exact

// Says: Every frame takes one step at least, owed or not: by a do loop that looks only after the first, or by a
//       limit from below?
// Hint: A frame that is shorter than a step may take none, and what is owed may not fall below zero. What does
//       yours do with it?
namespace at_least_one {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        int count = 0;
        do {
            owed -= step;
            ++count;
        } while (owed >= step && count < most_steps);
        if (owed >= step) owed = std::fmod(owed, step);
        return count;
    });
}

}  // namespace at_least_one

// Says: The numbers go on growing: these are the steps since the game began.
// Hint: Each frame has its own number. Where must the counter begin anew?
namespace since_the_start {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    int all = 0;
    for (const double passed : frames) {
        owed += passed;
        int count = 0;
        for (; owed >= step && count < most_steps; ++count) owed -= step;
        owed = std::fmod(owed, step);
        steps.push_back(all += count);
    }
    return steps;
}

}  // namespace since_the_start

// Says: The number of steps is rounded up: a part of a step that is owed counts as a whole one.
// Hint: A step is taken when all of it is owed. Which function goes down to a whole number?
namespace rounded_up {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const double due = std::ceil(owed / step);
        const int taken = static_cast<int>(std::min<double>(due, most_steps));
        owed = std::fmod(owed, step);
        return taken;
    });
}

}  // namespace rounded_up

// Says: A frame that takes no step is left out of the list.
// Hint: There must be one number for every frame: 0 for one that takes none.
namespace only_with_steps {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps = each_frame(frames, [&](double& owed) {
        const int taken = static_cast<int>(std::min<double>(std::floor(owed / step), most_steps));
        owed = std::fmod(owed, step);
        return taken;
    });
    std::erase(steps, 0);
    return steps;
}

}  // namespace only_with_steps

// Says: A step is taken as soon as anything at all is owed: the simulation runs ahead of the clock.
// Hint: A step is paid when it is owed in full. With what must the owed time be compared?
namespace ahead_of_the_clock {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        int count = 0;
        for (; owed > 0 && count < most_steps; ++count) owed -= step;
        if (owed > 0) owed = std::fmod(owed, step);
        return count;
    });
}

}  // namespace ahead_of_the_clock

// Says: The simulation is a step ahead from the first: does the game begin with a whole step owed, or is a step
//       taken where the clock has only reached its beginning?
// Hint: How much is owed before the first frame? And which end of a step must the clock have passed, when it is
//       taken?
namespace owed_at_the_start {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    bool first = true;
    return each_frame(frames, [&](double& owed) {
        if (first) owed += step;
        first = false;
        int count = 0;
        for (; owed >= step && count < most_steps; ++count) owed -= step;
        owed = std::fmod(owed, step);
        return count;
    });
}

}  // namespace owed_at_the_start

// Says: The first frame is left out: its time is never added.
// Hint: With which index does your loop begin? And the time of that frame?
namespace first_frame_left_out {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    bool first = true;
    return each_frame(frames, [&](double& owed) {
        if (first) owed = 0;
        first = false;
        int count = 0;
        for (; owed >= step && count < most_steps; ++count) owed -= step;
        owed = std::fmod(owed, step);
        return count;
    });
}

}  // namespace first_frame_left_out

// Says: Where whole steps are dropped at the cap, the comparison is strict: if just one whole step is left, it stays owed.
// Hint: Less than one step may stay owed after a frame. What does your comparison do with exactly one?
namespace one_whole_step_kept {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        int count = 0;
        for (; owed >= step && count < most_steps; ++count) owed -= step;
        if (owed > step) {
            const double rest = std::fmod(owed, step);
            owed = rest == 0 ? step : rest;
        }
        steps.push_back(count);
    }
    return steps;
}

}  // namespace one_whole_step_kept
