#include "exercise.hpp"

// Says: The ball is put where it belongs, but "before" is left alone: the two heights do not tell the bounce.
// Hint: Verlet reads the velocity off the two heights. Compute now - before from your answer: does it point
//       up?
namespace only_now {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {before, floor + e * (floor - now)};
}

}  // namespace only_now

// Says: The ball is put on the floor, as a rope's points are. Its next step goes on falling, since "before"
//       is still up there.
// Hint: Moving one of the two positions changes the velocity, but only by chance into the right one. You may
//       move both.
namespace onto_the_floor {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {before, floor};
}

}  // namespace onto_the_floor

// Says: The speed is right, but the ball waits on the floor for the rest of the step.
// Hint: The impact was before the end of the step. From then on the ball has risen already: for how long?
namespace turned_at_the_floor {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {floor + e * (now - before), floor};
}

}  // namespace turned_at_the_floor

// Says: This is the bounce that loses nothing, whatever restitution is given: e is not used.
// Hint: A mirror keeps distances from the floor. With less speed, how far does the ball get in the same
//       time?
namespace loses_nothing {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {2 * floor - before, 2 * floor - now};
}

}  // namespace loses_nothing

// Says: The speed after the bounce is right, but the ball has risen to its new height as if at the old
//       speed.
// Hint: The velocity changes at the floor. All that the ball rises in the rest of this step, it rises with
//       the new one.
namespace too_high {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double high = 2 * floor - now;
    return {high + e * (now - before), high};
}

}  // namespace too_high

// Says: The two heights have changed places. That turns the velocity round, but puts the ball back to where
//       it came from, at full speed.
// Hint: Running the last step backwards is not a bounce. Follow the ball to the floor first, and then up
//       from there.
namespace swapped {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {now, before};
}

}  // namespace swapped

// Says: The heights are mirrored at zero, wherever the floor is.
// Hint: Heights above the floor are before - floor and now - floor. Mirror these, and go back.
namespace floor_at_zero {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {-e * before, -e * now};
}

}  // namespace floor_at_zero

// Says: Right, except for a ball that lay on the floor one step ago: it sinks, since you ask that it came
//       from above.
// Hint: A ball on the floor is not above it. What counts is only where the ball is now.
namespace only_from_above {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (before > floor && now < floor)
        return {floor - e * (before - floor), floor + e * (floor - now)};
    return {before, now};
}

}  // namespace only_from_above

// Says: The ball bounces in every step, even high above the floor.
// Hint: Ask first whether the ball is below the floor now.
namespace always {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    return {floor - e * (before - floor), floor + e * (floor - now)};
}

}  // namespace always

// Says: The ball is put where it belongs, and "before" is a step away from it, but on the wrong side: the
//       two heights tell the old velocity's direction, downwards.
// Hint: The velocity before the bounce, now - before, is negative. Write down the new one with its sign:
//       where was a ball that now rises a step ago, above or below?
namespace still_falling {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double risen = floor + e * (floor - now);
    return {risen - e * (now - before), risen};
}

}  // namespace still_falling

// Says: "now" is overwritten before the velocity is taken: the difference is that of the new height and the
//       old "before".
// Hint: The velocity of the fall is in the two heights that you were given. Take it before you change either
//       of them.
namespace velocity_too_late {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    now = floor + e * (floor - now);
    return {now + e * (now - before), now};
}

}  // namespace velocity_too_late

// Says: The new height is how far the ball has risen above the floor: the floor itself is missing, and all
//       heights are counted from zero.
// Hint: floor - now is a distance, and e times it is one, too. From which height on does the ball rise by
//       it?
namespace floor_not_added {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double risen = e * (floor - now);
    return {risen + e * (now - before), risen};
}

}  // namespace floor_not_added

// Says: "before" is put on the floor, or not let below it: the two heights tell only the part of the new velocity
//       that the ball has already used to rise.
// Hint: No ball was ever at the new "before". It stands for a velocity, and may lie anywhere.
namespace before_clamped {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {std::max(floor, floor - e * (before - floor)), floor + e * (floor - now)};
}

}  // namespace before_clamped

// Says: e is taken for the part of the energy that is left: the speed comes out as its root.
// Hint: The task says what e is a ratio of. With e = 0.25, by which part does the speed shrink?
namespace share_of_the_energy {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double kept = std::sqrt(e);
    return {floor - kept * (before - floor), floor + kept * (floor - now)};
}

}  // namespace share_of_the_energy

// Says: e is taken for the part of the speed that is lost, so a ball with e = 1 lies still.
// Hint: Read off the task what a restitution of 1 means, and what 0 means.
namespace part_lost {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {floor - (1 - e) * (before - floor), floor + (1 - e) * (floor - now)};
}

}  // namespace part_lost

// Says: The new velocity is right, but the ball rises for the part of the step before the impact, not for the
//       part after it.
// Hint: At which part of its way down does the ball hit the floor? What is left of the step then?
namespace time_before_the_impact {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double risen = floor + e * (before - floor);
    return {risen + e * (now - before), risen};
}

}  // namespace time_before_the_impact

// Says: The two heights are right, but returned in the wrong order: the ball falls again.
// Hint: Which of your two heights is that of now? A ball that rises is higher now than before.
namespace wrong_order {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {floor + e * (floor - now), floor - e * (before - floor)};
}

}  // namespace wrong_order

// Says: The new height is right, but the ball leaves with all of its old speed, whatever the restitution.
// Hint: Compute now - before from your answer, and compare it with the fall. Where is e?
namespace full_speed {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double risen = floor + e * (floor - now);
    return {risen + (now - before), risen};
}

}  // namespace full_speed

// Says: Right, except for a ball that lies on the floor just now: it is not below it, and both heights must
//       be left as they are.
// Hint: Its velocity is still the old one, and the next step will take it through the floor. Which comparison
//       leaves it alone?
namespace on_the_floor_too {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now > floor) return {before, now};
    return {floor - e * (before - floor), floor + e * (floor - now)};
}

}  // namespace on_the_floor_too

// Says: The speed shrinks by the square of e: as the energy does, or because e comes in twice.
// Hint: The task says what e is a ratio of. With e = 0.5, is half of the speed left, or a quarter?
namespace squared {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {floor - e * e * (before - floor), floor + e * e * (floor - now)};
}

}  // namespace squared

// Says: The comparison is the wrong way round: balls in the air bounce, and those below the floor sink on.
// Hint: When is there something to do: if now is above the floor, or below it?
namespace upside_down {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now < floor) return {before, now};
    return {floor - e * (before - floor), floor + e * (floor - now)};
}

}  // namespace upside_down

// Says: The ball is put on the floor and stopped, whatever the restitution.
// Hint: With e = 0 that is right. What is the speed after the bounce if e is 1?
namespace stopped {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {floor, floor};
}

}  // namespace stopped

// Says: The ball is mirrored at the floor without e, and "before" is left alone, so that its velocity is no
//       bounce's.
// Hint: Two heights tell a velocity. Which two tell the one after the bounce?
namespace only_mirrored {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {before, 2 * floor - now};
}

}  // namespace only_mirrored

// Says: The floor is taken to be at zero: both in the question whether the ball is below it, and in the mirror.
// Hint: floor may be any height. Where does it stand in your code?
namespace no_floor {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= 0) return {before, now};
    return {-e * before, -e * now};
}

}  // namespace no_floor

// Says: The bounce is right, but the question is whether the ball is below zero, and not below the floor.
// Hint: floor may be any height. With what is now to be compared?
namespace asks_for_zero {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= 0) return {before, now};
    return {floor - e * (before - floor), floor + e * (floor - now)};
}

}  // namespace asks_for_zero

// Says: The velocity is turned round where the ball is, below the floor. The new pair has the right speed, but
//       the ball starts from where it has sunk to.
// Hint: At the floor itself the ball turns round. Where would it be now, had it done so there?
namespace turned_below {

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double last = now - before;
    return {now, now - e * last};
}

}  // namespace turned_below
