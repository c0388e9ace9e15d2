// In which order, and for how long, each part acts.

// Says: All of gravity acts at the beginning. Then the step does not read the same from both ends, and its
//       order is one.
// Hint: Give gravity half of its time before the spins, and half after them.
namespace gravity_first {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 1}, {0, 0.5}, {1, 0.5}, {2, 1}, {1, 0.5}, {0, 0.5}});
}

}  // namespace gravity_first

// Says: Gravity acts for half the step only.
// Hint: Each part must act for h altogether. Add up the times of each.
namespace gravity_once {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 0.5}, {1, 0.5}, {2, 1}, {1, 0.5}, {0, 0.5}});
}

}  // namespace gravity_once

// Says: The spins act one after the other and not back again: x, y, z. That has order one.
// Hint: Read your step from its end. It should say the same: half of x and of y belong behind z.
namespace one_way {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 1}, {1, 1}, {2, 1}, {3, 0.5}});
}

}  // namespace one_way

// Says: Behind z, x and y come in the same order as before it. The step does not read the same from both
//       ends.
// Hint: The way back is the way there in a mirror: what was last comes first.
namespace not_mirrored {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 0.5}, {1, 0.5}, {2, 1}, {0, 0.5}, {1, 0.5}, {3, 0.5}});
}

}  // namespace not_mirrored

// Says: The spin about z acts for half the step only: it stands in the middle, but once.
// Hint: Add up the times of each part. Each must act for h altogether.
namespace z_halved {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 0.5}, {1, 0.5}, {2, 0.5}, {1, 0.5}, {0, 0.5}, {3, 0.5}});
}

}  // namespace z_halved

// Says: The spins about x and y act for two steps.
// Hint: What comes twice must act for half the time.
namespace all_whole {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 1}, {1, 1}, {2, 1}, {1, 1}, {0, 1}, {3, 0.5}});
}

}  // namespace all_whole

// Says: Each part acts once, for the whole step, gravity first. That has order one.
// Hint: Halve every part but the one in the middle, and go back the way you came.
namespace each_once {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 1}, {0, 1}, {1, 1}, {2, 1}});
}

}  // namespace each_once

// Says: Nothing is halved: gravity and the spins about x and y act for two steps.
// Hint: What comes twice must act for half of h each time. Only z comes once.
namespace nothing_halved {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 1}, {0, 1}, {1, 1}, {2, 1}, {1, 1}, {0, 1}, {3, 1}});
}

}  // namespace nothing_halved

// Says: The step reads the same from both ends, but its order is another one: gravity stands in the middle.
// Hint: The task says what comes first and last, and what is in the middle. Then the same game gives the same dance.
namespace gravity_in_the_middle {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{2, 0.5}, {1, 0.5}, {0, 0.5}, {3, 1}, {0, 0.5}, {1, 0.5}, {2, 0.5}});
}

}  // namespace gravity_in_the_middle

// Says: The spins come in the wrong order: z and y first, and x in the middle.
// Hint: After gravity x acts, then y, and z in the middle of the step.
namespace z_first {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {2, 0.5}, {1, 0.5}, {0, 1}, {1, 0.5}, {2, 0.5}, {3, 0.5}});
}

}  // namespace z_first

// Says: The step reads the same from both ends, but y comes before x.
// Hint: Which of the spins comes next to gravity, at either end?
namespace y_before_x {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {1, 0.5}, {0, 0.5}, {2, 1}, {0, 0.5}, {1, 0.5}, {3, 0.5}});
}

}  // namespace y_before_x

// Says: Gravity acts once, in the middle of the step, between the two halves of the spin about z.
// Hint: Gravity acts twice, for half a step each time. When, says the task.
namespace gravity_innermost {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{0, 0.5}, {1, 0.5}, {2, 0.5}, {3, 1}, {2, 0.5}, {1, 0.5}, {0, 0.5}});
}

}  // namespace gravity_innermost

// Says: The spins come as x, y, z and again as x, y, z. The way back must be the way there in a mirror: z, y,
//       x.
// Hint: Read the step from its end. Is it the same as from its beginning?
namespace twice_one_way {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 0.5}, {1, 0.5}, {2, 0.5}, {0, 0.5}, {1, 0.5}, {2, 0.5}, {3, 0.5}});
}

}  // namespace twice_one_way
