#include "exercise_eigen.hpp"

// Says: The part across turns the wrong way round.
// Hint: Take omega = (1, 0, 1) and a flat body. Which sign has the rate of omega.y() in Euler's equations?
namespace turns_backwards {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (across - along) / across * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace turns_backwards

// Says: The difference of the moments is divided by the moment along the axis.
// Hint: The first line of Euler's equations is that of the x axis. By which moment is it divided?
namespace divided_by_along {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / along * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace divided_by_along

// Says: The rate is the ratio of the moments times the spin about the axis: a sphere's spin would go round
//       in its own body.
// Hint: The gyroscopic torque has a difference of two moments in it. What must the rate be when they are
//       equal?
namespace ratio_only {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = along / across * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace ratio_only

// Says: The part across turns as fast as the body spins about its axis. The moments are not used.
// Hint: That would be right for a flat plate only. Where do the moments stand in Euler's equations?
namespace as_fast_as_the_body {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    return Eigen::AngleAxisd(omega.z() * t, Vector3d::UnitZ()) * omega;
}

}  // namespace as_fast_as_the_body

// Says: This is the spin as seen from the world: it turns about the angular momentum, at |L|/across.
// Hint: The answer is wanted in the body's axes, in which the angular momentum itself goes round. Look for
//       what stays in Euler's equations.
namespace in_the_world {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const Vector3d momentum(across * omega.x(), across * omega.y(), along * omega.z());
    return Eigen::AngleAxisd(momentum.norm() / across * t, momentum.normalized()) * omega;
}

}  // namespace in_the_world

// Says: The rate is made of the length of the whole spin, and not of the spin about the axis.
// Hint: The rate of omega.x() is a product of omega.y() and one other component. Which one?
namespace whole_spin {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.norm() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace whole_spin

// Says: This is one long step of explicit Euler: the part across leaves along a straight line, and energy
//       grows.
// Hint: The rate changes direction all the time. Find the curve that has such a rate everywhere.
namespace one_step {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double rate = (along - across) / across * omega.z();
    return omega + t * rate * Vector3d::UnitZ().cross(omega);
}

}  // namespace one_step

// Says: The two moments are exchanged, in the difference and below it.
// Hint: across comes first among the arguments: it belongs to the x and the y axis. Write out the first line
//       of Euler's equations with these names.
namespace swapped {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (across - along) / along * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace swapped

// Says: The angle has been converted as if it were in degrees: everything turns 57 times too slowly.
// Hint: omega is in rad/s and std::cos wants radians.
namespace degrees {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t * std::numbers::pi / 180;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace degrees

// Says: The axis of symmetry is taken to be x: what is along x stays, and y and z turn.
// Hint: The task says which axis it is, and which of the moments are equal.
namespace axis_x {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.x() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitX()) * omega;
}

}  // namespace axis_x

// Says: Right, except for a top that spins about its axis alone: the part across is zero, and you divide by
//       its length.
// Hint: You need the part across, and not its direction. Can you turn it as it is?
namespace zero_divides {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const double size = std::hypot(omega.x(), omega.y());
    const double c = omega.x() / size, s = omega.y() / size;  // the direction at the start
    return {size * (c * std::cos(angle) - s * std::sin(angle)),
            size * (s * std::cos(angle) + c * std::sin(angle)), omega.z()};
}

}  // namespace zero_divides

// Says: A wobble that is small is taken for none: its part across stands still in your answer.
// Hint: The part across goes round at the same rate however small it is. The closed form needs no threshold,
//       and has nothing to divide by.
namespace small_wobble_ignored {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    if (std::hypot(omega.x(), omega.y()) < 1e-6) return omega;
    const double angle = (along - across) / across * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace small_wobble_ignored

// Says: Right for later times. For earlier ones the spin at the start comes back.
// Hint: The closed form knows no direction of time. Leave the question out.
namespace never_earlier {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    if (t <= 0) return omega;
    const double angle = (along - across) / across * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace never_earlier

// Says: The part across turns by twice the angle. Has a quaternion been made with the whole angle, or is there a 2
//       too many in the rate?
// Hint: A quaternion holds the cosine and the sine of half the angle. You can do without one, and without a 2.
namespace double_angle {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const Quaterniond q(std::cos(angle), 0, 0, std::sin(angle));
    return q * omega;
}

}  // namespace double_angle

// Says: The part across has the right length and rate, but it always starts along x.
// Hint: At t = 0 the answer has to be omega. Where does its part across point then?
namespace starts_along_x {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const double size = std::hypot(omega.x(), omega.y());
    return {size * std::cos(angle), size * std::sin(angle), omega.z()};
}

}  // namespace starts_along_x

// Says: Only about half of the digits are right, as if part of it were computed in float, or step by step.
// Hint: Look for float, or a number with an f at its end. The closed form needs no steps, and no tolerance
//       for what is nearly a sphere.
namespace single_precision {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const float angle = static_cast<float>((along - across) / across * omega.z() * t);
    const float c = std::cos(angle), s = std::sin(angle);
    return {c * omega.x() - s * omega.y(), s * omega.x() + c * omega.y(), omega.z()};
}

}  // namespace single_precision

// Says: The angle has been turned into degrees: everything turns 57 times too fast.
// Hint: std::cos and std::sin take radians. In which unit is omega times t already?
namespace into_degrees {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t * 180 / std::numbers::pi;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * omega.x() - s * omega.y(), s * omega.x() + c * omega.y(), omega.z()};
}

}  // namespace into_degrees

// Says: Sine and cosine are exchanged: in no time the part across turns by a right angle.
// Hint: At t = 0 the answer is omega itself. Which of the two is one there?
namespace sine_and_cosine_exchanged {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const double c = std::cos(angle), s = std::sin(angle);
    return {s * omega.x() - c * omega.y(), c * omega.x() + s * omega.y(), omega.z()};
}

}  // namespace sine_and_cosine_exchanged

// Says: y is computed with the x that has been turned already.
// Hint: Both of the new components need both of the old ones. Keep the old x until y is done.
namespace new_x_in_y {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const double c = std::cos(angle), s = std::sin(angle);
    const double x = c * omega.x() - s * omega.y();
    return {x, s * x + c * omega.y(), omega.z()};
}

}  // namespace new_x_in_y

// Says: One of the two sines has the wrong sign: this is no turn, and the part across changes its length.
// Hint: Turn (1, 0) and (0, 1) by a right angle, on paper. Which of the four products has a minus?
namespace a_sign_of_the_sine {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() * t;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * omega.x() + s * omega.y(), s * omega.x() + c * omega.y(), omega.z()};
}

}  // namespace a_sign_of_the_sine

// Says: The difference of the moments is not divided by one of them: in other units of mass the top would
//       turn at another rate.
// Hint: Euler's equations have a moment in front of each rate. Where has it gone?
namespace not_divided {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace not_divided

// Says: The ratio of the moments is upside down, and nothing is taken off it: a sphere's spin would go round.
// Hint: Write out the first line of Euler's equations, and divide it by the moment on its left.
namespace ratio_upside_down {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = across / along * omega.z() * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace ratio_upside_down

// Says: The part across turns at half of its rate.
// Hint: Is there a half from a quaternion? A turn of a vector takes the whole angle.
namespace half_rate {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * omega.z() / 2 * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace half_rate

// Says: The rate has the moments in it, but not the spin about the axis.
// Hint: A rate is in rad/s. What is the unit of a ratio of moments?
namespace spin_missing {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double angle = (along - across) / across * t;
    return Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * omega;
}

}  // namespace spin_missing

// Says: The spin comes back as it was, whatever the time.
// Hint: Euler's equations give omega.x() and omega.y() a rate of change. When is it zero?
namespace nothing_turns {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    return omega;
}

}  // namespace nothing_turns

// Says: The rate is |L| / across, by which the axis goes round as it is seen from outside. In the body it is another
//       one.
// Hint: In the body the spin turns by (along - across) / across times the spin about the axis.
namespace rate_seen_from_outside {

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const Vector3d L(across * omega.x(), across * omega.y(), along * omega.z());
    return Eigen::AngleAxisd(L.norm() / across * t, Vector3d::UnitZ()) * omega;
}

}  // namespace rate_seen_from_outside
