// At the cap.

// Says: Nothing limits the steps of a frame: this game can spiral to death.
// Hint: After a hitch the frame may take most_steps and no more.
namespace no_cap {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const int taken = static_cast<int>(owed / step);
        owed = std::fmod(owed, step);
        return taken;
    });
}

}  // namespace no_cap

// Says: At the cap everything owed is dropped, the part of a step included.
// Hint: Dropping whole steps keeps the rhythm. What is left when all whole steps have been taken away?
namespace all_dropped {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const int due = static_cast<int>(owed / step);
        const int taken = std::min(due, most_steps);
        owed = due > most_steps ? 0 : owed - due * step;
        return taken;
    });
}

}  // namespace all_dropped

// Says: At the cap nothing is dropped: the frames after a hitch go on paying for it.
// Hint: The game should run slower for a moment, and not race to catch up. What is owed after a frame must
//       be less than a step.
namespace nothing_dropped {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const int count = std::min(static_cast<int>(owed / step), most_steps);
        owed -= count * step;
        return count;
    });
}

}  // namespace nothing_dropped

// Says: At the cap only one step is dropped, or some fixed number, however many are still owed: after a long
//       hitch the frames go on paying.
// Hint: An if drops one step, a counted loop its count. What must be done until less than a step is owed, or
//       what gives the remainder at once?
namespace one_step_dropped {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        int count = 0;
        for (; owed >= step && count < most_steps; ++count) owed -= step;
        if (owed >= step) owed -= step;
        return count;
    });
}

}  // namespace one_step_dropped

// Says: The long frame is cut to most_steps before it is added: the part of a step that it brought is lost.
// Hint: Add the whole frame first. The cap is on the steps, and the remainder is that of all the time that
//       has passed.
namespace frame_cut_short {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += std::min(passed, most_steps * step);
        const int due = static_cast<int>(owed / step);
        steps.push_back(std::min(due, most_steps));
        owed = std::fmod(owed, step);
    }
    return steps;
}

}  // namespace frame_cut_short

// Says: At the cap a frame takes one step more than it may: the loop still begins one when most_steps have
//       been taken.
// Hint: Let the cap be 1 and go through the loop by hand: how many steps have been taken when it stops?
namespace one_too_many {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        int count = 0;
        for (; owed >= step && count <= most_steps; ++count) owed -= step;
        owed = std::fmod(owed, step);
        return count;
    });
}

}  // namespace one_too_many

// Says: A frame that takes most_steps loses the part of a step that it still owes, even where no whole step
//       had to be dropped.
// Hint: Reaching the cap is no reason to drop anything. Look only at what is owed beyond it, and keep less
//       than a step of that.
namespace dropped_when_all_taken {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        int count = 0;
        for (; owed >= step && count < most_steps; ++count) owed -= step;
        if (count == most_steps) owed = 0;
        return count;
    });
}

}  // namespace dropped_when_all_taken

// Says: No frame takes more than twenty steps, or some other number of your own, whatever most_steps says.
// Hint: The cap is an argument, and may be large. Where else do you end the loop?
namespace own_cap {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return each_frame(frames, [&](double& owed) {
        const double due = std::floor(owed / step);
        const int taken = static_cast<int>(std::min<double>(due, std::min(most_steps, 20)));
        owed = std::fmod(owed, step);
        return taken;
    });
}

}  // namespace own_cap
