#include "exercise_eigen.hpp"

// What the mistakes are put together from, so that it is compiled once: a vector of the world in the body's axes, the
// way back, and the gyroscopic torque on the right side of Euler's equations.
static Vector3d into(const Quaterniond& q, const Vector3d& v) {
    return q.conjugate() * v;
}
static Vector3d home(const Quaterniond& q, const Vector3d& v) {
    return q * v;
}
static Vector3d gyroscopic(const Vector3d& inertia, const Vector3d& spin) {
    const Vector3d L = inertia.cwiseProduct(spin);
    return L.cross(spin);
}
static Vector3d over(const Vector3d& torque, const Vector3d& inertia) {
    return torque.cwiseQuotient(inertia);
}

// The sum of both torques, in the body's axes.
static Vector3d total(const Vector3d& inertia, const Quaterniond& q, const Vector3d& omega, const Vector3d& torque) {
    return into(q, torque) + gyroscopic(inertia, into(q, omega));
}

// Says: The gyroscopic torque is missing: without a torque from outside the spin never changes.
// Hint: Euler's equations have a term with omega and L. Bring it to the right side.
namespace gyroscopic_missing {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, over(into(q, torque), inertia));
}

}  // namespace gyroscopic_missing

// Says: The gyroscopic torque has the wrong sign: the angular momentum of a free body does not stay.
// Hint: In Euler's equations omega x L stands on the left, beside the acceleration. What happens to it on the way to
//       the other side? And which of the two stands first in your cross product?
namespace gyroscopic_sign {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, over(into(q, torque) - gyroscopic(inertia, into(q, omega)), inertia));
}

}  // namespace gyroscopic_sign

// Says: This is the acceleration in the body's axes: the last step, back into the world, is missing.
// Hint: You went into the body with q.conjugate(). Which way is home?
namespace body_answer {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return over(total(inertia, q, omega, torque), inertia);
}

}  // namespace body_answer

// Says: q and its inverse are exchanged: vectors of the world are turned as if they were vectors of the
//       body.
// Hint: q makes world vectors of body vectors. omega and torque are world vectors already.
namespace turned_wrong_way {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Quaterniond back = q.conjugate();
    return home(back, over(total(inertia, back, omega, torque), inertia));
}

}  // namespace turned_wrong_way

// Says: The orientation is not used: the moments are taken along the axes of the world.
// Hint: A ship that has turned by a quarter has its moments along other axes of the world. Go into the
//       body's axes first.
namespace never_turned {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return over(torque + gyroscopic(inertia, omega), inertia);
}

}  // namespace never_turned

// Says: The spin has been brought into the body, but the torque has not: vectors of two kinds of axes are
//       added up.
// Hint: For each vector of your sum, ask in which axes it is written. All must be the same.
namespace torque_not_turned {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, over(torque + gyroscopic(inertia, into(q, omega)), inertia));
}

}  // namespace torque_not_turned

// Says: The torque has been brought into the body, but omega has not: the gyroscopic torque is computed from
//       the spin in the world.
// Hint: Moments along the body's axes go together with a spin in the body's axes. omega is given in the
//       world's.
namespace spin_not_turned {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, over(into(q, torque) + gyroscopic(inertia, omega), inertia));
}

}  // namespace spin_not_turned

// Says: Only the torque from outside is divided by the moments; the gyroscopic torque is used as if it were
//       an acceleration.
// Hint: Look at the units: omega x L is in N m, like every torque. Add the torques first, then divide.
namespace gyroscopic_not_divided {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, over(into(q, torque), inertia) + gyroscopic(inertia, into(q, omega)));
}

}  // namespace gyroscopic_not_divided

// Says: This is the sum of the torques and no acceleration yet: nothing is divided by the moments.
// Hint: Newton has a = F/m. What takes the place of m where a body turns?
namespace nothing_divided {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, total(inertia, q, omega, torque));
}

}  // namespace nothing_divided

// Says: The gyroscopic part is right, but the torque from outside is divided by the moments along the axes
//       of the world.
// Hint: The moments belong to the body's axes. The torque, too, must be there when you divide.
namespace torque_divided_in_world {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return over(torque, inertia) + home(q, over(gyroscopic(inertia, into(q, omega)), inertia));
}

}  // namespace torque_divided_in_world

// Says: Right to about seven digits only. Do the numbers pass through float somewhere?
// Hint: Use double, Vector3d and Quaterniond throughout.
namespace single_precision {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const auto rounded = [](double number) { return double(float(number)); };
    const Vector3d I = inertia.unaryExpr(rounded);
    const Quaterniond turn(rounded(q.w()), rounded(q.x()), rounded(q.y()), rounded(q.z()));
    const Vector3d spin = into(turn, omega.unaryExpr(rounded)).unaryExpr(rounded);
    const Vector3d push = into(turn, torque.unaryExpr(rounded)).unaryExpr(rounded);
    const Vector3d sum = (push + gyroscopic(I, spin)).unaryExpr(rounded);
    return home(turn, over(sum, I)).unaryExpr(rounded);
}

}  // namespace single_precision

// Says: In the end the sum of the torques is multiplied by the moments, not divided.
// Hint: A body with twice the moment turns half as readily. Does yours?
namespace multiplied {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d sum = total(inertia, q, omega, torque);
    return home(q, sum.cwiseProduct(inertia));
}

}  // namespace multiplied

// Says: All three axes get one moment, the mean of the three: the body turns as readily about each of them.
// Hint: The moments along the three axes differ. Divide component by component, in the body's axes.
namespace one_moment_for_all {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const double mean = (inertia.x() + inertia.y() + inertia.z()) / 3;
    return home(q, over(total(inertia, q, omega, torque), {mean, mean, mean}));
}

}  // namespace one_moment_for_all

// Says: The angular momentum has been made by a division: L is I omega.
// Hint: L is to omega what momentum is to velocity. What stands between them?
namespace momentum_divided {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = into(q, omega), L = over(spin, inertia);
    return home(q, over(into(q, torque) + L.cross(spin), inertia));
}

}  // namespace momentum_divided

// Says: On the way back you have turned into the body once more, by q.conjugate().
// Hint: q.conjugate() leads from the world to the body. What leads home?
namespace into_the_body_twice {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return into(q, over(total(inertia, q, omega, torque), inertia));
}

}  // namespace into_the_body_twice

// Says: The torque from outside is not used: thrusters have no effect.
// Hint: At rest there is no gyroscopic torque. What does a push do then, in your formula?
namespace torque_forgotten {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, over(gyroscopic(inertia, into(q, omega)), inertia));
}

}  // namespace torque_forgotten

// Says: The torque from outside has the wrong sign: thrusters turn the ship the wrong way.
// Hint: At rest the acceleration has the direction of the torque, more or less. Does yours?
namespace torque_sign {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return home(q, over(gyroscopic(inertia, into(q, omega)) - into(q, torque), inertia));
}

}  // namespace torque_sign

// Says: The gyroscopic torque is a cross product of omega in the world and L in the body: two kinds of axes
//       in one product.
// Hint: Both of its factors have to be written in the same axes.
namespace cross_of_two_kinds {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d L = inertia.cwiseProduct(into(q, omega));
    return home(q, over(into(q, torque) + L.cross(omega), inertia));
}

}  // namespace cross_of_two_kinds

// Says: In the third of Euler's equations the two moments have changed places.
// Hint: The equations go round: y and z, z and x, and then?
namespace third_reversed {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d w = q.conjugate() * omega, t = q.conjugate() * torque, I = inertia;
    return q * Vector3d((t.x() + (I.y() - I.z()) * w.y() * w.z()) / I.x(), (t.y() + (I.z() - I.x()) * w.z() * w.x()) / I.y(),
                        (t.z() + (I.y() - I.x()) * w.x() * w.y()) / I.z());
}

}  // namespace third_reversed

// Says: A moment that is far less than the others is taken for larger than it is: right for most bodies, but not for a
//       long rod.
// Hint: A rod's moment about its own axis may be a millionth of the others. Divide by the moment that is given.
namespace least_moment_raised {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d sum = total(inertia, q, omega, torque), raised = inertia.cwiseMax(1e-3 * inertia.maxCoeff());
    return home(q, over(sum, raised));
}

}  // namespace least_moment_raised
