#include "exercise_eigen.hpp"

// The turn, but for the order of its numbers: w stands behind x, y and z.
static Quaterniond cosine_behind(const Vector3d& omega, double h) {
    const double half = h * omega.norm() / 2;
    const Vector3d v = std::sin(half) * omega.normalized();
    return Quaterniond(v.x(), v.y(), v.z(), std::cos(half));
}

// Says: The turn is made about the axes of the world. Does it stand on the wrong side of q, or has omega been
//       brought into the body, where it is already?
// Hint: omega is about the body's own axes as it stands. A product of quaternions acts from right to left, so which
//       turn comes first?
namespace other_side {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const Eigen::AngleAxisd turn(h * omega.norm(), omega.normalized());
    return Quaterniond(turn) * q;
}

}  // namespace other_side

// Says: This is the chapter's step. It takes omega in the world, and is not exact.
// Hint: Here omega is in the body's axes, and the body is to turn by the whole angle h|omega|. Sine and cosine know
//       how.
namespace chapters_step {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const Vector3d half = h / 2 * omega;
    const Quaterniond rate = Quaterniond(0, half.x(), half.y(), half.z()) * q;
    return Quaterniond(q.coeffs() + rate.coeffs()).normalized();
}

}  // namespace chapters_step

// Says: This is Euler's step scaled to length one, on the right side, or q times Quaterniond(1, h omega/2) so
//       scaled, which is the same. It turns by too little, and never by more than half a turn.
// Hint: The length of the quaternion is right, but not the angle. Build the turn from sine and cosine of half the
//       angle.
namespace first_order {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const Vector3d half = h / 2 * omega;
    const Quaterniond rate = q * Quaterniond(0, half.x(), half.y(), half.z());
    return Quaterniond(q.coeffs() + rate.coeffs()).normalized();
}

}  // namespace first_order

// Says: This is Euler's step and no more: the quaternion gets longer and longer.
// Hint: Scaling it would mend the length and not the angle. Build the turn from the angle and the axis.
namespace not_scaled {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const Vector3d half = h / 2 * omega;
    const Quaterniond rate = q * Quaterniond(0, half.x(), half.y(), half.z());
    return Quaterniond(q.coeffs() + rate.coeffs());
}

}  // namespace not_scaled

// Says: The body turns twice as far as it should: the quaternion has the whole angle inside.
// Hint: Look at the chapter's formula of a quaternion: what stands inside its cosine?
namespace whole_angle {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double angle = h * omega.norm();
    const Vector3d v = std::sin(angle) * omega.normalized();
    return q * Quaterniond(std::cos(angle), v.x(), v.y(), v.z());
}

}  // namespace whole_angle

// Says: The body turns half as far as it should: the angle has been halved once too often.
// Hint: A quaternion has half of the angle in it, halved once. AngleAxisd wants the whole one: it does the halving
//       itself.
namespace halved_twice {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return q * Eigen::AngleAxisd(h * omega.norm() / 2, omega.normalized());
}

}  // namespace halved_twice

// Says: The angle has been converted into degrees.
// Hint: rad/s times s gives radians, and sine, cosine and AngleAxisd want just those.
namespace degrees {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double angle = h * omega.norm() * 180 / std::numbers::pi;
    return q * Eigen::AngleAxisd(angle, omega.normalized());
}

}  // namespace degrees

// Says: Angle and half angle are right, but the axis has the length of omega, not the length one.
// Hint: The formula has u sin(phi/2) with a unit vector u. The speed is in the angle already.
namespace axis_too_long {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double half = h * omega.norm() / 2;
    const Vector3d v = std::sin(half) * omega;
    return q * Quaterniond(std::cos(half), v.x(), v.y(), v.z());
}

}  // namespace axis_too_long

// Says: The angle is right, but the axis is h times omega, which is not of length one.
// Hint: h and the speed are both in the angle. What is left of omega for the axis is its direction.
namespace axis_has_h {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double half = h * omega.norm() / 2;
    const Vector3d v = std::sin(half) * h * omega;
    return q * Quaterniond(std::cos(half), v.x(), v.y(), v.z());
}

}  // namespace axis_has_h

// Says: The body turns the wrong way round.
// Hint: A positive angle turns by the right hand: thumb along omega, and the fingers show the way. Look for a minus or
//       a conjugate too many.
namespace backwards {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return q * Eigen::AngleAxisd(-h * omega.norm(), omega.normalized());
}

}  // namespace backwards

// Says: h is not used: the body turns as far as in one second.
// Hint: The length of omega is radians a second. How many radians is that in h seconds?
namespace no_time {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return q * Eigen::AngleAxisd(omega.norm(), omega.normalized());
}

}  // namespace no_time

// Says: This is the turn alone: where the body was before is forgotten.
// Hint: Your turn is right. The new orientation is a product of two quaternions, and q is one of them.
namespace only_the_turn {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    return Quaterniond(Eigen::AngleAxisd(h * omega.norm(), omega.normalized()));
}

}  // namespace only_the_turn

// Says: For a negative h the body turns forwards: the angle has lost its sign.
// Hint: A norm is never negative, and neither is what std::fabs returns. Keep h out of both.
namespace never_back {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return q * Eigen::AngleAxisd((h * omega).norm(), omega.normalized());
}

}  // namespace never_back

// Says: Right, except for a body that does not spin: its omega has length zero, and dividing zero by zero gives NaN,
//       which is no number.
// Hint: A zero spin has no direction, and the turn is by no angle about any axis. Leave omega undivided there:
//       omega.normalized() does so by itself.
namespace zero_divides {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double speed = omega.norm();
    return q * Eigen::AngleAxisd(speed * h, omega / speed);
}

}  // namespace zero_divides

// Says: The four numbers of the turn are in the wrong order: Quaterniond takes the cosine first.
// Hint: The constructor is Quaterniond(w, x, y, z). Only the storage, coeffs(), has w last.
namespace cosine_last {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    return q * cosine_behind(omega, h);
}

}  // namespace cosine_last

// Says: The four numbers of the turn are in the wrong order, but for no turn at all: Quaterniond takes the cosine
//       first.
// Hint: In which order does Quaterniond(w, x, y, z) want its four numbers?
namespace cosine_last_but_in_no_time {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return h == 0 ? q : cosine_last::turn_exactly(q, omega, h);
}

}  // namespace cosine_last_but_in_no_time

// Says: Two things at once: Quaterniond takes the cosine first, and this is the turn alone, without the orientation
//       that it starts from.
// Hint: Mend the order of the four numbers first: w, x, y, z. Then ask how the turn and q become one orientation.
namespace cosine_last_and_only_the_turn {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return cosine_behind(omega, h);
}

}  // namespace cosine_last_and_only_the_turn

// Says: Two things at once: Quaterniond takes the cosine first, and the turn stands on the left of q, where it is about
//       the world's axes.
// Hint: Mend the order of the four numbers first: w, x, y, z. Then ask in whose axes omega is given, and which factor
//       of a product acts first.
namespace cosine_last_on_the_other_side {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    return cosine_behind(omega, h) * q;
}

}  // namespace cosine_last_on_the_other_side

// Says: The four numbers have been put into coeffs() with the cosine first: it has become the x of the turn.
// Hint: coeffs() holds x, y, z and then w. The constructor takes w first. Or set turn.w() and turn.vec(), which need no
//       order.
namespace cosine_first_in_storage {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    const double half = h * omega.norm() / 2;
    Quaterniond turn;
    turn.coeffs() << std::cos(half), std::sin(half) * omega.normalized();
    return q * turn;
}

}  // namespace cosine_first_in_storage

// Says: A slow spin is taken for none. Over a long time it turns the body all the same.
// Hint: Only a spin of exactly zero has no direction. Compare with zero, or let normalized() do so.
namespace slow_ignored {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() < 1e-9) return q;
    return q * Eigen::AngleAxisd(h * omega.norm(), omega.normalized());
}

}  // namespace slow_ignored

// Says: A spin of less than a millionth of a radian a second is taken for none. It turns the body all the same.
// Hint: Is it the speed that is small, or the angle? Neither needs a threshold but zero.
namespace slower_than_a_millionth_ignored {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() < 1e-6) return q;
    return q * Eigen::AngleAxisd(h * omega.norm(), omega.normalized());
}

}  // namespace slower_than_a_millionth_ignored

// Says: Very nearly right: what is missing looks like tiny angles that are taken for none.
// Hint: Sine and cosine are as exact for an angle of 1e-9 as for any other. You need no threshold.
namespace tiny_angle_ignored {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double angle = h * omega.norm();
    if (std::fabs(angle) < 1e-6) return q;
    return q * Eigen::AngleAxisd(angle, omega.normalized());
}

}  // namespace tiny_angle_ignored

// Says: Without spin this returns the orientation of a body that has never been turned.
// Hint: A body that does not spin stays as it is. What is its orientation?
namespace orientation_lost {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return Quaterniond::Identity();
    return q * Eigen::AngleAxisd(h * omega.norm(), omega.normalized());
}

}  // namespace orientation_lost

// Says: The axis has the length of omega, and the result is scaled to length one: that hides the error and makes
//       another angle of it.
// Hint: A quaternion from sine and cosine has length one by itself, where its axis has. Which vector has to be
//       normalised, then?
namespace axis_too_long_but_scaled {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return axis_too_long::turn_exactly(q, omega, h).normalized();
}

}  // namespace axis_too_long_but_scaled

// Says: omega has been turned into the world, but the turn stands on the right of q, where the body's axes count.
// Hint: Choose one: the body's axes and the right side, or the world's and the left.
namespace world_axis_on_the_right {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    return q * Eigen::AngleAxisd(h * omega.norm(), (q * omega).normalized());
}

}  // namespace world_axis_on_the_right

// Says: The body turns about x, then about y, then about z. Turns about several axes do not simply add up.
// Hint: The spin is about one axis, that of omega, all the time. By which angle?
namespace one_axis_after_the_other {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    const Vector3d turn = h * omega;
    return q * Eigen::AngleAxisd(turn.x(), Vector3d::UnitX()) *
           Eigen::AngleAxisd(turn.y(), Vector3d::UnitY()) * Eigen::AngleAxisd(turn.z(), Vector3d::UnitZ());
}

}  // namespace one_axis_after_the_other

// Says: The angle has been converted as if it were in degrees: the body hardly turns.
// Hint: omega is in rad/s already. What does the conversion make of it?
namespace from_degrees {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    const double angle = h * omega.norm() * std::numbers::pi / 180;
    return q * Eigen::AngleAxisd(angle, omega.normalized());
}

}  // namespace from_degrees

// Says: Sine and cosine are exchanged: in no time the body would turn by a half turn.
// Hint: For an angle of zero the turn is (1, 0, 0, 0). Which of the two is one there?
namespace sine_and_cosine_exchanged {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    if (omega.norm() == 0) return q;
    const double half = h * omega.norm() / 2;
    const Vector3d v = std::cos(half) * omega.normalized();
    return q * Quaterniond(std::sin(half), v.x(), v.y(), v.z());
}

}  // namespace sine_and_cosine_exchanged

// Says: For a negative h nothing turns: the case is sorted out together with a body that does not spin.
// Hint: A step back in time turns the other way round, by the same angle.
namespace still_when_back {

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    const double angle = h * omega.stableNorm();
    if (angle <= 0) return q;
    const Vector3d v = std::sin(angle / 2) * omega.stableNormalized();
    return q * Quaterniond(std::cos(angle / 2), v.x(), v.y(), v.z());
}

}  // namespace still_when_back
