#include "exercise_eigen.hpp"

// Says: The gyroscopic torque is missing: without a torque from outside the spin never changes.
// Hint: Euler's equations have a term with omega and L. Bring it to the right side.
namespace gyroscopic_missing {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return q * (q.conjugate() * torque).cwiseQuotient(inertia);
}

}  // namespace gyroscopic_missing

// Says: The gyroscopic torque has the wrong sign: the angular momentum of a free body does not stay.
// Hint: In Euler's equations omega x L stands on the left, beside the acceleration. What happens to it on
//       the way to the other side?
namespace gyroscopic_sign {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque + spin.cross(inertia.cwiseProduct(spin));
    return q * total.cwiseQuotient(inertia);
}

}  // namespace gyroscopic_sign

// Says: This is the acceleration in the body's axes: the last step, back into the world, is missing.
// Hint: You went into the body with q.conjugate(). Which way is home?
namespace body_answer {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque - spin.cross(inertia.cwiseProduct(spin));
    return total.cwiseQuotient(inertia);
}

}  // namespace body_answer

// Says: q and its inverse are exchanged: vectors of the world are turned as if they were vectors of the
//       body.
// Hint: q makes world vectors of body vectors. omega and torque are world vectors already.
namespace turned_wrong_way {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q * omega;
    const Vector3d total = q * torque - spin.cross(inertia.cwiseProduct(spin));
    return q.conjugate() * total.cwiseQuotient(inertia);
}

}  // namespace turned_wrong_way

// Says: The orientation is not used: the moments are taken along the axes of the world.
// Hint: A ship that has turned by a quarter has its moments along other axes of the world. Go into the
//       body's axes first.
namespace never_turned {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return (torque - omega.cross(inertia.cwiseProduct(omega))).cwiseQuotient(inertia);
}

}  // namespace never_turned

// Says: The spin has been brought into the body, but the torque has not: vectors of two kinds of axes are
//       added up.
// Hint: For each vector of your sum, ask in which axes it is written. All must be the same.
namespace torque_not_turned {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = torque - spin.cross(inertia.cwiseProduct(spin));
    return q * total.cwiseQuotient(inertia);
}

}  // namespace torque_not_turned

// Says: The torque has been brought into the body, but omega has not: the gyroscopic torque is computed from
//       the spin in the world.
// Hint: Moments along the body's axes go together with a spin in the body's axes. omega is given in the
//       world's.
namespace spin_not_turned {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d total = q.conjugate() * torque - omega.cross(inertia.cwiseProduct(omega));
    return q * total.cwiseQuotient(inertia);
}

}  // namespace spin_not_turned

// Says: Only the torque from outside is divided by the moments; the gyroscopic torque is used as if it were
//       an acceleration.
// Hint: Look at the units: omega x L is in N m, like every torque. Add the torques first, then divide.
namespace gyroscopic_not_divided {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d push = (q.conjugate() * torque).cwiseQuotient(inertia);
    return q * (push - spin.cross(inertia.cwiseProduct(spin)));
}

}  // namespace gyroscopic_not_divided

// Says: This is the sum of the torques and no acceleration yet: nothing is divided by the moments.
// Hint: Newton has a = F/m. What takes the place of m where a body turns?
namespace nothing_divided {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque - spin.cross(inertia.cwiseProduct(spin));
    return q * total;
}

}  // namespace nothing_divided

// Says: The gyroscopic part is right, but the torque from outside is divided by the moments along the axes
//       of the world.
// Hint: The moments belong to the body's axes. The torque, too, must be there when you divide.
namespace torque_divided_in_world {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d gyroscopic = -spin.cross(inertia.cwiseProduct(spin));
    return torque.cwiseQuotient(inertia) + q * gyroscopic.cwiseQuotient(inertia);
}

}  // namespace torque_divided_in_world

// Says: Right to about seven digits only. Do the numbers pass through float somewhere?
// Hint: Use double, Vector3d and Quaterniond throughout.
namespace single_precision {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    using Vector3f = Eigen::Vector3f;
    const Vector3f I = inertia.cast<float>();
    const Eigen::Quaternionf turn = q.cast<float>();
    const Vector3f spin = turn.conjugate() * omega.cast<float>();
    const Vector3f push = turn.conjugate() * torque.cast<float>();
    const Vector3f total = push - spin.cross(I.cwiseProduct(spin));
    return (turn * total.cwiseQuotient(I)).cast<double>();
}

}  // namespace single_precision

// Says: In the end the sum of the torques is multiplied by the moments, not divided.
// Hint: A body with twice the moment turns half as readily. Does yours?
namespace multiplied {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque - spin.cross(inertia.cwiseProduct(spin));
    return q * total.cwiseProduct(inertia);
}

}  // namespace multiplied

// Says: All three axes get one moment, the mean of the three: the body turns as readily about each of them.
// Hint: The moments along the three axes differ. Divide component by component, in the body's axes.
namespace one_moment_for_all {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque - spin.cross(inertia.cwiseProduct(spin));
    return q * (total / inertia.mean());
}

}  // namespace one_moment_for_all

// Says: The angular momentum has been made by a division: L is I omega.
// Hint: L is to omega what momentum is to velocity. What stands between them?
namespace momentum_divided {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque - spin.cross(spin.cwiseQuotient(inertia));
    return q * total.cwiseQuotient(inertia);
}

}  // namespace momentum_divided

// Says: On the way back you have turned into the body once more, by q.conjugate().
// Hint: q.conjugate() leads from the world to the body. What leads home?
namespace into_the_body_twice {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque - spin.cross(inertia.cwiseProduct(spin));
    return q.conjugate() * total.cwiseQuotient(inertia);
}

}  // namespace into_the_body_twice

// Says: The torque from outside is not used: thrusters have no effect.
// Hint: At rest there is no gyroscopic torque. What does a push do then, in your formula?
namespace torque_forgotten {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = -spin.cross(inertia.cwiseProduct(spin));
    return q * total.cwiseQuotient(inertia);
}

}  // namespace torque_forgotten

// Says: The torque from outside has the wrong sign: thrusters turn the ship the wrong way.
// Hint: At rest the acceleration has the direction of the torque, more or less. Does yours?
namespace torque_sign {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = -(q.conjugate() * torque) - spin.cross(inertia.cwiseProduct(spin));
    return q * total.cwiseQuotient(inertia);
}

}  // namespace torque_sign

// Says: The gyroscopic torque is a cross product of omega in the world and L in the body: two kinds of axes
//       in one product.
// Hint: Both of its factors have to be written in the same axes.
namespace cross_of_two_kinds {

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Vector3d spin = q.conjugate() * omega;
    const Vector3d total = q.conjugate() * torque - omega.cross(inertia.cwiseProduct(spin));
    return q * total.cwiseQuotient(inertia);
}

}  // namespace cross_of_two_kinds
