#include "exercise.hpp"

// Says: It is one step too few, so nearly every step is too long: rounded down, or a loop that ends one too early?
// Hint: Say the frame holds 3.2 of the longest steps: do three do? Conversion to int drops what stands behind the
//       point; a loop goes on until omega h is small enough.
namespace rounded_down {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(omega * frame / (2 * share)));
}

}  // namespace rounded_down

// Says: The count is rounded to the nearest whole number: half of the time the steps are too long.
// Hint: Too many steps cost a little, too few blow up. Only one way of rounding is safe.
namespace rounded {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::lround(omega * frame / (2 * share))));
}

}  // namespace rounded

// Says: This is one step more than needed, in every frame: one that is added to a count rounded up already, or a
//       loop that ends one too late?
// Hint: Say the frame holds 3.2 of the longest steps: how many does your code make of it, and which is the first
//       that will do?
namespace one_too_many {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return static_cast<int>(std::ceil(omega * frame / (2 * share))) + 1;
}

}  // namespace one_too_many

// Says: Right, but a crate that nothing pulls gets no step at all: it hangs in the air for ever.
// Hint: What does rounding up make of zero? Even a free crate has to move.
namespace none {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return static_cast<int>(std::ceil(omega * frame / (2 * share)));
}

}  // namespace none

// Says: These are springs in a row, one hung on the other: each more makes the whole softer.
// Hint: Side by side every spring pulls at the crate itself. Do two pull harder than one, or less?
namespace springs_in_a_row {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(stiffness / springs / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace springs_in_a_row

// Says: Only one of the springs counts.
// Hint: All of them pull the crate back, at once.
namespace one_spring {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace one_spring

// Says: The omega of one spring is taken times the number of springs.
// Hint: It is the forces that add up, so the stiffnesses, and not the angular frequencies. Where does the
//       number stand then?
namespace springs_outside_the_root {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = springs * std::sqrt(stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace springs_outside_the_root

// Says: What you call omega is omega squared.
// Hint: Stiffness over mass has the unit 1/s². omega is in 1/s.
namespace no_root {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = springs * stiffness / mass;
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace no_root

// Says: Mass and stiffness have changed places: stiffer springs would need fewer steps.
// Hint: A stiff spring swings fast, a heavy crate slowly. Which of the two stands above the line?
namespace upside_down {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(mass / (springs * stiffness));
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace upside_down

// Says: This takes 1 for the limit of omega h: twice as many steps as needed.
// Hint: Without damping, semi-implicit Euler goes farther. Look at the map, on its left.
namespace limit_one {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / share)));
}

}  // namespace limit_one

// Says: The margin is forgotten: these steps go up to the limit itself, whatever share is.
// Hint: omega h may be as large as 2 share. With half the share the steps have to be half as long.
namespace no_margin {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / 2)));
}

}  // namespace no_margin

// Says: A smaller share makes for fewer steps here. It should make for more.
// Hint: A / B * C is not A / (B * C). Or solve omega frame / n = 2 share for n again.
namespace share_multiplied {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / 2 * share)));
}

}  // namespace share_multiplied

// Says: You count oscillations a second: omega is divided by 2 pi.
// Hint: The limit is one of omega, in radians a second. The root of stiffness over mass is just that.
namespace hertz {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double frequency = std::sqrt(springs * stiffness / mass) / (2 * std::numbers::pi);
    return std::max(1, static_cast<int>(std::ceil(frequency * frame / (2 * share))));
}

}  // namespace hertz

// Says: Nearly right, but close to the limit the count is one off: numbers have gone through float, or you
//       rounded with a tolerance that is too wide.
// Hint: Keep everything in double until the count is rounded up, and round up what comes out as it is.
namespace single_precision {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const float omega = std::sqrt(static_cast<float>(springs * stiffness / mass));
    const float least = omega * static_cast<float>(frame) / (2 * static_cast<float>(share));
    return std::max(1, static_cast<int>(std::ceil(least)));
}

}  // namespace single_precision

// Says: The count is doubled until it is safe: you only ever answer 1, 2, 4, 8 and so on. A frame that needs
//       five steps gets eight.
// Hint: Fewer may do. The least count can be computed, or found by going up one by one.
namespace doubled {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    int steps = 1;
    while (omega * frame / steps > 2 * share) steps *= 2;
    return steps;
}

}  // namespace doubled

// Says: The steps are counted per second: the length of the frame is not in it.
// Hint: How long may a step be? How many of these fill the frame, and not a second?
namespace no_frame {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega / (2 * share))));
}

}  // namespace no_frame

// Says: The mass of the crate is not in your omega.
// Hint: A heavy crate on the same springs swings more slowly. What stands below the stiffness?
namespace no_mass {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace no_mass

// Says: Every crate gets the three steps of the example.
// Hint: Begin with the omega of the crate.
namespace example {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    return 3;
}

}  // namespace example

// Says: What needs a little more than a whole number of steps is given that number: a small slack is taken off before
//       the count is rounded up.
// Hint: Rounding up needs no help. With the slack omega h is above what is allowed, wherever it was just above.
namespace rounded_up_with_slack {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share) - 1e-3)));
}

}  // namespace rounded_up_with_slack

// Says: A slack of a millionth is taken off before the count is rounded up: what needs so little more than a whole
//       number of steps is given too few.
// Hint: A part in a billion is all that is left open. std::ceil alone keeps to that.
namespace rounded_up_with_less_slack {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share) - 1e-6)));
}

}  // namespace rounded_up_with_less_slack

// Says: omega is multiplied by 2 pi, as if it were in oscillations a second.
// Hint: The root of k/m is in radians per second already, and so is the limit of 2.
namespace radians_twice {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = 2 * std::numbers::pi * std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace radians_twice

// Says: What you call omega is omega squared; where it is too large for an int, it is limited.
// Hint: What is the unit of springs times stiffness over mass? And that of omega?
namespace no_root_below_a_limit {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = springs * stiffness / mass;
    return std::max(1, static_cast<int>(std::min(1e9, std::ceil(omega * frame / (2 * share)))));
}

}  // namespace no_root_below_a_limit

// Says: One spring is in the count, whatever their number, if there are any. They all pull at once, and so the
//       oscillation is faster.
// Hint: Four springs side by side are one that is four times as stiff. What of omega?
namespace one_of_any_number {

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = springs > 0 ? std::sqrt(stiffness / mass) : 0;
    return std::max(1, static_cast<int>(std::ceil(omega * frame / (2 * share))));
}

}  // namespace one_of_any_number
