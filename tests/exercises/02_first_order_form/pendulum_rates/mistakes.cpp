#include "exercise.hpp"

// Says: The pull is proportional to the angle: this is the spring that a pendulum resembles only in small
//       swings.
// Hint: Hang the lamp a quarter turn up, then half a turn: gravity's share along the arc must be all of it,
//       and then none.
namespace small_angle {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * s.x - drag * length * std::abs(s.v) * s.v};
}

}  // namespace small_angle

// Says: The two rates are in the wrong order: first the acceleration, then the velocity.
// Hint: The rates stand in the same order as the unknowns, the angle first.
namespace swapped_rates {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {-g / length * std::sin(s.x) - drag * length * std::abs(s.v) * s.v, s.v};
}

}  // namespace swapped_rates

// Says: The drag is the plain square of the velocity, which has lost its direction: swinging back, the air
//       pushes the lamp.
// Hint: A square is never negative. The force must change its sign with the velocity.
namespace square_without_sign {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) - drag * length * s.v * s.v};
}

}  // namespace square_without_sign

// Says: The drag points along the motion: this air drives the lamp.
// Hint: Look at a lamp that passes its lowest point: which sign must its acceleration have?
namespace air_pushes {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) + drag * length * std::abs(s.v) * s.v};
}

}  // namespace air_pushes

// Says: The drag lacks a length: is it taken of the angular velocity, as if radians per second were metres per
//       second, or divided by the length once too often?
// Hint: The coefficient belongs to the speed u of the lamp through the air. Write u by the length and v, and
//       count how many lengths remain.
namespace drag_of_the_angle {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) - drag * std::abs(s.v) * s.v};
}

}  // namespace drag_of_the_angle

// Says: Gravity is divided by the length, the drag is not: it is still in metres per second squared.
// Hint: Both accelerations act along the arc. What turns one of them into an angular acceleration does the
//       same to the other.
namespace drag_not_divided {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) - drag * length * length * std::abs(s.v) * s.v};
}

}  // namespace drag_not_divided

// Says: The second rate is the acceleration along the arc, in metres per second squared.
// Hint: The unknown is an angle. Its second derivative and the acceleration along the arc differ by a factor
//       that the cable knows.
namespace metres_for_radians {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g * std::sin(s.x) - drag * length * length * std::abs(s.v) * s.v};
}

}  // namespace metres_for_radians

// Says: Gravity pulls the lamp away from hanging straight down.
// Hint: A small positive angle must make the velocity fall, not grow.
namespace gravity_lifts {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, g / length * std::sin(s.x) - drag * length * std::abs(s.v) * s.v};
}

}  // namespace gravity_lifts

// Says: The drag grows with the speed and not with its square: this is a damper.
// Hint: At twice the speed, this air must brake four times as much.
namespace linear_drag {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) - drag * length * s.v};
}

}  // namespace linear_drag

// Says: The drag is worked out for the angle, gravity is not: -g sin x is still in metres per second
//       squared.
// Hint: A long cable swings slowly. Where does the length enter into the pull of gravity on the angle?
namespace gravity_not_divided {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g * std::sin(s.x) - drag * length * std::abs(s.v) * s.v};
}

}  // namespace gravity_not_divided

// Says: The drag is taken of the angular velocity and then divided by the length, too: it has lost two
//       lengths, which the square of the speed would have brought.
// Hint: Write u = length v in both of its places, |u| and u. What is left of the lengths when you divide by
//       one of them?
namespace drag_over_length {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, (-g * std::sin(s.x) - drag * std::abs(s.v) * s.v) / length};
}

}  // namespace drag_over_length

// Says: The angle is turned from degrees into radians before its sine is taken, but it comes in radians.
// Hint: Read the unit of s.x in the task, and remember the one that std::sin wants.
namespace degrees {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double x = s.x * std::numbers::pi / 180;
    return {s.v, -g / length * std::sin(x) - drag * length * std::abs(s.v) * s.v};
}

}  // namespace degrees

// Says: Both rates are zero: nothing that you worked out has got into the result, and this lamp never moves.
// Hint: A list of two zeros is a place to put the rates. What belongs into the first, and what into the
//       second?
namespace zero {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {0, 0};
}

}  // namespace zero

// Says: The drag is the coefficient times the speed u, not times |u| u: at other speeds than one metre per
//       second it is wrong.
// Hint: The unit of the drag is 1/m. What must it be multiplied by to become metres per second squared?
namespace linear_in_speed {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) - drag * s.v};
}

}  // namespace linear_in_speed

// Says: These are the rates of the way along the arc, in metres: the speed u, and its rate.
// Hint: The solver's unknowns are the angle and the angular velocity. Divide by the cable's length, in both
//       places.
namespace along_the_arc {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double u = length * s.v;
    return {u, -g * std::sin(s.x) - drag * std::abs(u) * u};
}

}  // namespace along_the_arc

// Says: Gravity comes with the cosine of the angle: hanging straight down, this lamp is pulled the most.
// Hint: At x = 0 the lamp must be able to rest. Which function is zero there?
namespace cosine {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::cos(s.x) - drag * length * std::abs(s.v) * s.v};
}

}  // namespace cosine

// Says: The air is left out: this lamp swings for ever.
// Hint: The second rate has two terms. What does the air do to a lamp with the speed u?
namespace no_drag {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x)};
}

}  // namespace no_drag

// Says: Gravity is multiplied by the length where it has to be divided.
// Hint: The longer the cable is, the slower the lamp swings. What does your formula say about that?
namespace times_length {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g * length * std::sin(s.x) - drag * length * std::abs(s.v) * s.v};
}

}  // namespace times_length

// Says: The drag has a factor 1/2 that the task does not have.
// Hint: In the air the formula is often written with a half and a density. Here the coefficient has all of
//       that inside.
namespace half_drag {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) - drag * length * std::abs(s.v) * s.v / 2};
}

}  // namespace half_drag

// Says: The first rate is the speed along the arc, in metres per second; the second one is right.
// Hint: The first unknown is the angle. How fast does it change, in radians per second?
namespace rate_is_speed {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {length * s.v, -g / length * std::sin(s.x) - drag * length * std::abs(s.v) * s.v};
}

}  // namespace rate_is_speed

// Says: Gravity is left out: only the air is at work.
// Hint: Hold the lamp a quarter turn up and let it go. What must the second rate be?
namespace no_gravity {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -drag * length * std::abs(s.v) * s.v};
}

}  // namespace no_gravity

// Says: Both forces have the wrong sign: gravity lifts the lamp, and the air drives it.
// Hint: Draw the arc with the direction in which the angle grows. Both forces of a lamp that swings up
//       point back.
namespace both_signs {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, g / length * std::sin(s.x) + drag * length * std::abs(s.v) * s.v};
}

}  // namespace both_signs

// Says: The size of the speed is cut to whole metres per second: below one, there is no air.
// Hint: abs without std:: before it may be the one for whole numbers. std::abs and std::fabs keep the digits.
namespace whole_speed {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double u = length * s.v, size = std::fabs(u);
    // What an int cannot hold becomes the least int.
    const double whole = size < 0x1p31 ? std::trunc(size) : -0x1p31;
    return {s.v, (-g * std::sin(s.x) - drag * whole * u) / length};
}

}  // namespace whole_speed

// Says: The drag has the sign of the angle, the side on which the lamp is, and not that of its motion.
// Hint: On its way back from the right the lamp moves to the left. Where does the air push it then?
namespace drag_by_the_side {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double u = length * s.v, side = s.x > 0 ? 1 : s.x < 0 ? -1 : 0;
    return {s.v, (-g * std::sin(s.x) - drag * u * u * side) / length};
}

}  // namespace drag_by_the_side

// Says: The length is used nowhere: gravity's pull is in metres per second squared, and the drag is taken of the angular
//       velocity.
// Hint: Write down the acceleration along the arc with u = length v. Then divide all of it by the length.
namespace length_not_used {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g * std::sin(s.x) - drag * std::abs(s.v) * s.v};
}

}  // namespace length_not_used

// Says: The drag is the coefficient times the square of the angular velocity. It lacks a length, and it has lost its direction:
//       swinging back, the air pushes the lamp.
// Hint: Use the speed u = length v in both places of |u| u, keep the sign of one of them, and divide by the length at the end.
namespace square_of_the_angular_velocity {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, -g / length * std::sin(s.x) - drag * s.v * s.v};
}

}  // namespace square_of_the_angular_velocity
