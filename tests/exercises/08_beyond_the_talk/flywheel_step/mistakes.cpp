#include "exercise_eigen.hpp"

// What the mistakes are put together from, so that it is compiled once: the L1 that acts, ...
static Vector3d momentum(const Vector3d& inertia, const Vector3d& wheel, const Vector3d& omega) {
    return inertia.cwiseProduct(omega) + wheel;
}

// ... the y2 with y2 - k x y2 = y1, ...
static Vector3d solved(const Vector3d& k, const Vector3d& y) {
    const Vector3d sum = y + k.cross(y), along = k.dot(y) * k;
    return (sum + along) / (1 + k.squaredNorm());
}

// ... k of L1, ...
static Vector3d k_of(const Vector3d& inertia, const Vector3d& L, double h) {
    const Vector3d root = inertia.cwiseSqrt();
    return h / (root.x() * root.y() * root.z()) * root.cwiseProduct(L);
}

// ... and y = sqrt(I) w, and back.
static Vector3d y_of(const Vector3d& inertia, const Vector3d& omega) {
    return inertia.cwiseSqrt().cwiseProduct(omega);
}
static Vector3d spin_of(const Vector3d& inertia, const Vector3d& y) {
    return y.cwiseQuotient(inertia.cwiseSqrt());
}

// The course's step, with an L1 of one's own.
static Vector3d step(const Vector3d& inertia, const Vector3d& L, const Vector3d& omega, double h) {
    return spin_of(inertia, solved(k_of(inertia, L, h), y_of(inertia, omega)));
}

// Says: The wheel is not in L1: this is the step of a ship without a flywheel.
// Hint: The angular momentum that acts is that of ship and wheel together.
namespace wheel_forgotten {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    return step(inertia, inertia.cwiseProduct(omega), omega, h);
}

}  // namespace wheel_forgotten

// Says: Only the wheel is in L1. The ship itself has an angular momentum, too.
// Hint: L1 = I w1 + wheel.
namespace only_the_wheel {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    return step(inertia, wheel, omega, h);
}

}  // namespace only_the_wheel

// Says: The wheel is taken as a spin and multiplied by the moments of the ship.
// Hint: Look at the units: wheel is in kg m^2/s already.
namespace wheel_as_spin {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    return step(inertia, inertia.cwiseProduct(Vector3d(omega + wheel)), omega, h);
}

}  // namespace wheel_as_spin

// Says: This is explicit Euler: L1 acts on the old spin, and the energy grows with each step.
// Hint: On the right of the equation stands the new spin, w2.
namespace explicit_euler {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d torque = momentum(inertia, wheel, omega).cross(omega);
    return omega + h * Vector3d(torque.cwiseQuotient(inertia));
}

}  // namespace explicit_euler

// Says: The torque acts the wrong way round: as w2 x L1.
// Hint: A cross product changes its sign when its two vectors change places. Look at both: the equation, and k x y
//       where you have solved it.
namespace other_way {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d backwards = -momentum(inertia, wheel, omega);
    return step(inertia, backwards, omega, h);
}

}  // namespace other_way

// Says: The part along L1 is lost: y + k x y alone, over 1 + k.k, does not solve the equation.
// Hint: Take the dot product of k and the equation: what does it say of k.y2?
namespace term_lost {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d y = y_of(inertia, omega), k = k_of(inertia, momentum(inertia, wheel, omega), h);
    const Vector3d sum = y + k.cross(y);
    return spin_of(inertia, sum / (1 + k.squaredNorm()));
}

}  // namespace term_lost

// Says: Nothing divides by 1 + k.k: the longer the step, the larger the spin.
// Hint: Put your y2 into y2 - k x y2. You should find y1, and find it 1 + k.k times.
namespace not_divided {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d y = y_of(inertia, omega), k = k_of(inertia, momentum(inertia, wheel, omega), h);
    return spin_of(inertia, (1 + k.squaredNorm()) * solved(k, y));
}

}  // namespace not_divided

// Says: L1 acts on the mean of both spins. That keeps the energy, but is not the equation that is asked.
// Hint: On the right of the equation stands w2 alone. This one brakes what is too fast for its step.
namespace mean_spin {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d y = y_of(inertia, omega), k = k_of(inertia, momentum(inertia, wheel, omega), h / 2);
    const Vector3d once = k.cross(y), twice = k.cross(once);
    return spin_of(inertia, y + 2 / (1 + k.squaredNorm()) * Vector3d(once + twice));
}

}  // namespace mean_spin

// Says: The equation is solved as if I could be divided through the cross product, component by component.
// Hint: The x component of L1 x w2 holds the y and z of both vectors, and is divided by the moment about x.
//       Write it out, in y = sqrt(I) w.
namespace roots_forgotten {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d L = momentum(inertia, wheel, omega);
    return solved(h * Vector3d(L.cwiseQuotient(inertia)), omega);
}

}  // namespace roots_forgotten

// Says: What is returned is sqrt(I) w2 and not yet the spin.
// Hint: Undo at the end what you have done at the beginning.
namespace still_y {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    return solved(k_of(inertia, momentum(inertia, wheel, omega), h), y_of(inertia, omega));
}

}  // namespace still_y

// Says: The length of the step is not in it.
// Hint: A step of zero must change nothing. Where does h stand in the equation?
namespace no_step {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    return step(inertia, momentum(inertia, wheel, omega), omega, 1);
}

}  // namespace no_step

// Says: This is explicit Euler, scaled back to the old energy. It cannot blow up, but it is not the
//       equation.
// Hint: Scaling hides what went wrong. The equation itself needs no mending: solve it for w2.
namespace scaled_explicit {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d torque = momentum(inertia, wheel, omega).cross(omega);
    const Vector3d w = omega + h * Vector3d(torque.cwiseQuotient(inertia));
    const double before = y_of(inertia, omega).squaredNorm(), after = y_of(inertia, w).squaredNorm();
    return after == 0 ? w : Vector3d(std::sqrt(before / after) * w);
}

}  // namespace scaled_explicit

// Says: A second round puts the new spin into L. The equation takes L from the old spin.
// Hint: With L1 from the old spin the equation is linear, and one round solves it.
namespace new_inertia {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d first = step(inertia, momentum(inertia, wheel, omega), omega, h);
    return step(inertia, momentum(inertia, wheel, first), omega, h);
}

}  // namespace new_inertia

// Says: The equation is right, but solved by a general solver, which loses digits where the step is long:
//       the energy grows.
// Hint: It subtracts numbers as large as (h L)^2 from each other. Solved by hand, there is only 1 + k.k to
//       divide by. An inverse of the matrix loses them, too.
namespace general_solve {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d hL = h * momentum(inertia, wheel, omega);
    Matrix3d matrix = inertia.asDiagonal();  // I - h skew(L)
    for (int i = 0; i < 3; ++i) {
        matrix(i, (i + 1) % 3) = hL[(i + 2) % 3];
        matrix(i, (i + 2) % 3) = -hL[(i + 1) % 3];
    }
    return solve_linear(matrix, inertia.cwiseProduct(omega));
}

}  // namespace general_solve

// Says: What is returned is the angular momentum I w2, and not the spin.
// Hint: A step of zero must give w1 back. Divide each component by its moment.
namespace momentum_returned {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d w = step(inertia, momentum(inertia, wheel, omega), omega, h);
    return inertia.cwiseProduct(w);
}

}  // namespace momentum_returned

// Says: The moments are missing on the left: you solve w2 - w1 = h L1 x w2.
// Hint: The equation begins with I. A heavy ship turns less.
namespace no_moments_on_the_left {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    return solved(h * momentum(inertia, wheel, omega), omega);
}

}  // namespace no_moments_on_the_left

// Says: On the left the mean of the three moments stands for all of them. Only a ball has one moment.
// Hint: Divide each component by its own moment: scale by their roots, and back.
namespace mean_moment {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const double mean = (inertia.x() + inertia.y() + inertia.z()) / 3;
    return solved(h / mean * momentum(inertia, wheel, omega), omega);
}

}  // namespace mean_moment

// Says: The divisor has h where h squared belongs: k is in it twice, and each k has an h.
// Hint: Compute k with its h once, and use k.dot(k).
namespace h_once_in_divisor {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d y = y_of(inertia, omega), L = momentum(inertia, wheel, omega);
    const Vector3d k = k_of(inertia, L, h), without_h = k_of(inertia, L, 1);
    const double share = (1 + k.squaredNorm()) / (1 + h * without_h.squaredNorm());
    return spin_of(inertia, share * solved(k, y));
}

}  // namespace h_once_in_divisor

// Says: The formula is right, but it is computed with about seven digits, as float has them.
// Hint: Is there a float in your answer, or a number of few digits?
namespace single_precision {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Eigen::Vector3f root = inertia.cwiseSqrt().cast<float>();
    const Eigen::Vector3f y = root.cwiseProduct(omega.cast<float>());
    const Eigen::Vector3f L = (inertia.cwiseProduct(omega) + wheel).cast<float>();
    const Eigen::Vector3f k = float(h) / root.prod() * root.cwiseProduct(L);
    const Eigen::Vector3f y2 = (y + k.cross(y) + k.dot(y) * k) / (1 + k.squaredNorm());
    return y2.cwiseQuotient(root).cast<double>();
}

}  // namespace single_precision

// Says: A body with three equal moments keeps its spin, as it does without a wheel.
// Hint: The torque is L x w. Is it still zero for a ball when the wheel is in L?
namespace ball_keeps_its_spin {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    if (inertia.x() == inertia.y() && inertia.y() == inertia.z()) return omega;
    return step(inertia, momentum(inertia, wheel, omega), omega, h);
}

}  // namespace ball_keeps_its_spin

// Says: A slow spin is taken for none and left as it is. But the wheel turns a slow spin just as it turns a fast one.
// Hint: The step is linear in the spin, but for L1, to which the wheel adds. Nothing in it needs the spin to be large.
namespace slow_spin_stays {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    if (omega.norm() < 1e-9) return omega;
    return step(inertia, momentum(inertia, wheel, omega), omega, h);
}

}  // namespace slow_spin_stays

// Says: The product of the moments is missing, as if each of them were one.
// Hint: What k is made of has the unit of an angle: h L over the root of a product of three moments, times a root of
//       one.
namespace moments_not_multiplied {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d root = inertia.cwiseSqrt(), y = root.cwiseProduct(omega);
    const Vector3d k = h * root.cwiseProduct(momentum(inertia, wheel, omega));
    return ((y + k.cross(y) + k.dot(y) * k) / (1 + k.squaredNorm())).cwiseQuotient(root);
}

}  // namespace moments_not_multiplied

// Says: The part along L1 has h where h squared belongs: k is in it twice, and each k has an h.
// Hint: A ball without a wheel keeps its spin in a step of any length. Compute k with its h once, and use that k
//       everywhere.
namespace h_once_along {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d y = y_of(inertia, omega), L = momentum(inertia, wheel, omega);
    const Vector3d k = k_of(inertia, L, h), without_h = k_of(inertia, L, 1);
    const Vector3d sum = y + k.cross(y), along = k.dot(y) * without_h;
    return spin_of(inertia, (sum + along) / (1 + k.squaredNorm()));
}

}  // namespace h_once_along

// Says: The wheel is on the left of the equation, too: you solve I w2 - L1 = h L1 x w2.
// Hint: On the left stands the ship alone, and the wheel acts by the torque. With h = 0, what must w2 be?
namespace wheel_on_the_left {

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    const Vector3d L = momentum(inertia, wheel, omega);
    return step(inertia, L, L.cwiseQuotient(inertia), h);
}

}  // namespace wheel_on_the_left
