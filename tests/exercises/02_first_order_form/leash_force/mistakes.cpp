#include "exercise_eigen.hpp"

// Says: A leash shorter than its rest length pushes: this is a rod.
// Hint: Compare the distance with the rest length before anything else.
namespace pushes_when_slack {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r == 0) return Vector3d::Zero();
    const Vector3d u = x / r;
    const double tension = k * (r - length) + c * v.dot(u);
    return r > length ? Vector3d(-std::max(tension, 0.0) * u) : Vector3d(-tension * u);
}

}  // namespace pushes_when_slack

// Says: The damper brakes the whole velocity, across the leash as well.
// Hint: A ball that circles its owner does not stretch the leash. How fast does the leash get longer?
namespace whole_velocity {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    const Vector3d force = -k * (r - length) / r * x - c * v;
    return force.dot(x) < 0 ? force : Vector3d::Zero();
}

}  // namespace whole_velocity

// Says: This is the force on the owner: it drives the ball away.
// Hint: x points from the owner to the ball. Which way does the leash pull the ball?
namespace force_on_the_owner {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return std::max(k * (r - length) + c * v.dot(x) / r, 0.0) / r * x;
}

}  // namespace force_on_the_owner

// Says: The damper has the wrong sign: a leash that gets longer pulls less, and the bouncing grows.
// Hint: A damper works against the motion. A ball that flies outwards must be pulled back harder.
namespace damper_feeds {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -std::max(k * (r - length) - c * v.dot(x) / r, 0.0) / r * x;
}

}  // namespace damper_feeds

// Says: A leash that gets shorter fast pushes the ball outwards: the tension may fall below zero.
// Hint: Spring and damper together may come out negative. What can a leash do then?
namespace pushes_when_damped {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -(k * (r - length) + c * v.dot(x) / r) / r * x;
}

}  // namespace pushes_when_damped

// Says: The spring pulls with the whole length and not with the stretch.
// Hint: At the rest length the force of the spring must just vanish.
namespace no_rest_length {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -std::max(k * r + c * v.dot(x) / r, 0.0) / r * x;
}

}  // namespace no_rest_length

// Says: The direction has not been brought to length one: the force grows with the distance once more.
// Hint: The tension is a number of newtons. The vector that carries it must have length one, in the force
//       and in the dot product.
namespace direction_too_long {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -std::max(k * (r - length) + c * v.dot(x), 0.0) * x;
}

}  // namespace direction_too_long

// Says: The damper uses the speed of the ball for the rate at which the leash gets longer.
// Hint: A speed is never negative and knows no direction. Only the part of the velocity along the leash
//       counts.
namespace speed_for_rate {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -(k * (r - length) + c * v.norm()) / r * x;
}

}  // namespace speed_for_rate

// Says: There is no damper: the velocity is not used.
// Hint: The tension has two parts. The second is c times the rate at which the leash gets longer.
namespace no_damper {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -k * (r - length) / r * x;
}

}  // namespace no_damper

// Says: The damper is at work only while the leash gets longer; a taut leash that gets shorter pulls with
//       the whole spring.
// Hint: Not the damper's part but the sum of both must not fall below zero.
namespace only_damps_outwards {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -(k * (r - length) + c * std::max(v.dot(x) / r, 0.0)) / r * x;
}

}  // namespace only_damps_outwards

// Says: Right, except for a leash that is just as long as at rest: there your damper is at work already.
// Hint: Read once more when the leash is slack. A ball that flies through the rest length tells a < from a
//       <=.
namespace taut_at_rest_length {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r < length || r == 0) return Vector3d::Zero();
    return -std::max(k * (r - length) + c * v.dot(x) / r, 0.0) / r * x;
}

}  // namespace taut_at_rest_length

// Says: With the ball at its owner's place and no rest length this divides zero by zero.
// Hint: Where there is no direction there must be no force. Find the comparison that lets a distance of zero
//       through.
namespace zero_divides {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r < length) return Vector3d::Zero();
    return -std::max(k * (r - length) + c * v.dot(x) / r, 0.0) / r * x;
}

}  // namespace zero_divides

// Says: This is a spring with a damper as they stand in a book: it pushes when it is slack, and it pushes
//       when it gets shorter fast.
// Hint: Two things are missing that make it a leash. Ask first whether it is longer than at rest, and then
//       whether spring and damper together pull.
namespace spring_and_damper {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r == 0) return Vector3d::Zero();
    return -(k * (r - length) + c * v.dot(x) / r) / r * x;
}

}  // namespace spring_and_damper

// Says: The tension is right, but it is multiplied by the whole position and not by its direction: the
//       force grows with the distance.
// Hint: Divide the position by its length, once. What has length one carries the tension as it is.
namespace tension_times_position {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -std::max(k * (r - length) + c * v.dot(x) / r, 0.0) * x;
}

}  // namespace tension_times_position

// Says: The force has the right direction, but the rate at which the leash gets longer has been multiplied
//       by its length.
// Hint: The part of v along the leash is its dot product with a vector of length one. Check the unit of
//       your rate.
namespace rate_times_length {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -std::max(k * (r - length) + c * v.dot(x), 0.0) / r * x;
}

}  // namespace rate_times_length

// Says: A slack leash has no spring here, but its damper is still at work.
// Hint: What hangs in a loop between the two can pull at nobody. Leave before the damper is worked out.
namespace slack_damps {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r == 0) return Vector3d::Zero();
    return -std::max(k * std::max(r - length, 0.0) + c * v.dot(x) / r, 0.0) / r * x;
}

}  // namespace slack_damps

// Says: The damper brakes the whole velocity, and nothing keeps the leash from pushing.
// Hint: First take only the part of the velocity along the leash. Then look at the sum of both forces,
//       which must pull.
namespace whole_velocity_pushes {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -k * (r - length) / r * x - c * v;
}

}  // namespace whole_velocity_pushes

// Says: The damper is at work only while the leash gets shorter: a ball that flies outwards is not braked.
// Hint: A leash that gets longer must be braked the most. Which of the two signs of the rate have you cut off?
namespace damps_inwards_only {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -std::max(k * (r - length) + c * std::min(v.dot(x) / r, 0.0), 0.0) / r * x;
}

}  // namespace damps_inwards_only

// Says: The damper takes the part of the velocity across the leash, which does not stretch it.
// Hint: Subtracting the part along the leash leaves the other one. Which of the two makes the leash longer?
namespace across {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    const Vector3d u = x / r;
    return -k * (r - length) * u - c * (v - v.dot(u) * u);
}

}  // namespace across

// Says: Nothing pushes, but a slack leash is not left alone: one that is shorter than at rest pulls as soon as it
//       gets longer fast enough.
// Hint: The damper of a slack leash has nothing to pull with. Compare the distance with the rest length
//       before anything else.
namespace no_slack_test {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r == 0) return Vector3d::Zero();
    const Vector3d u = x / r;
    return -std::max(k * (r - length) + c * v.dot(u), 0.0) * u;
}

}  // namespace no_slack_test

// Says: Where spring and damper together come out below zero, their size is taken: a leash that gets
//       shorter fast pulls all the more.
// Hint: Below zero the leash cannot push, and it does not pull. What is left?
namespace size_of_tension {

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    const double r = x.norm();
    if (r <= length) return Vector3d::Zero();
    return -std::fabs(k * (r - length) + c * v.dot(x) / r) / r * x;
}

}  // namespace size_of_tension
