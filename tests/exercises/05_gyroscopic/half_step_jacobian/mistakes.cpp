#include "exercise_eigen.hpp"

static Matrix3d skew(const Vector3d& a) {
    return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
}

// Says: This is the talk's solver: the torque is that of the end alone, and the spin slows down by itself.
// Hint: The mean counts each end for one half. Only the torque of the end has the unknown change in it.
namespace full_jacobian {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I + h * (skew(omega) * I - skew(I * omega));
    return omega + solve_linear(jacobian, h * torque);
}

}  // namespace full_jacobian

// Says: This is the spin in the middle of the step: the torque of the beginning acts for half of the time
//       only.
// Hint: The two ends have one half each. The torque of the beginning stands in both.
namespace half_step {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I + h / 2 * (skew(omega) * I - skew(I * omega));
    return omega + solve_linear(jacobian, h / 2 * torque);
}

}  // namespace half_step

// Says: The half stands at the wrong place: the torque on the right is halved, and the Jacobian is the
//       talk's.
// Hint: Write the mean of T and T - G d. How much of T is in it, and how much of G d?
namespace half_torque {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I + h * (skew(omega) * I - skew(I * omega));
    return omega + solve_linear(jacobian, h / 2 * torque);
}

}  // namespace half_torque

// Says: In omega x I omega you have let only the omega in front change; I omega is that of the beginning.
//       The energy stays, but a step back does not undo it.
// Hint: The product rule has two terms. Here the one where the momentum changes is missing.
namespace old_momentum {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I - h / 2 * skew(I * omega);
    return omega + solve_linear(jacobian, h * torque);
}

}  // namespace old_momentum

// Says: In omega x I omega you have let only the momentum change; the omega in front is that of the
//       beginning.
// Hint: The product rule has two terms. The one with skew(I omega) is missing.
namespace old_spin {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I + h / 2 * skew(omega) * I;
    return omega + solve_linear(jacobian, h * torque);
}

}  // namespace old_spin

// Says: The Jacobian has both terms of the product rule, but added.
// Hint: Where the change stands on the left of the cross product, it has to be swapped to the right. What
//       does that do to the sign?
namespace sum_of_terms {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I + h / 2 * (skew(omega) * I + skew(I * omega));
    return omega + solve_linear(jacobian, h * torque);
}

}  // namespace sum_of_terms

// Says: The torque of the end is linearised with the wrong sign: it rises where it should fall.
// Hint: The torque is minus omega x I omega, and the Jacobian stands on the left side. Count the minus signs
//       once more.
namespace jacobian_sign {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I - h / 2 * (skew(omega) * I - skew(I * omega));
    return omega + solve_linear(jacobian, h * torque);
}

}  // namespace jacobian_sign

// Says: Torque and Jacobian are right, but the change goes the wrong way.
// Hint: The gyroscopic torque is -omega x I omega. If the residual is + h omega x I omega, the change is
//       taken away.
namespace subtracted {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d jacobian = I + h / 2 * (skew(omega) * I - skew(I * omega));
    return omega - solve_linear(jacobian, h * torque);
}

}  // namespace subtracted

// Says: This is explicit Euler: only the torque at the beginning counts, and nothing is solved.
// Hint: The torque of the end depends on the change of the spin. Linearise it, and solve for the change.
namespace explicit_euler {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d torque = -omega.cross(inertia.cwiseProduct(omega));
    return omega + h * torque.cwiseQuotient(inertia);
}

}  // namespace explicit_euler

// Says: You have taken the torque of the end at the spin that explicit Euler leads to. This has order two,
//       but it is explicit: a step back does not undo it.
// Hint: Let the change that you look for stand in the linearised torque, and solve for it.
namespace heun {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const auto slope = [&](const Vector3d& w) -> Vector3d {
        return -w.cross(inertia.cwiseProduct(w)).cwiseQuotient(inertia);
    };
    const Vector3d begin = slope(omega), end = slope(omega + h * begin);
    return omega + h / 2 * (begin + end);
}

}  // namespace heun

// Says: These are two of the talk's steps, each of half the length: twice the price, and still of order one.
// Hint: One solve is enough. What happens to the change of the first half if you just take it twice?
namespace two_half_steps {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    Vector3d w = omega;
    for (int i = 0; i < 2; ++i) {
        const Matrix3d jacobian = I + h / 2 * (skew(w) * I - skew(I * w));
        w -= solve_linear(jacobian, h / 2 * w.cross(I * w));
    }
    return w;
}

}  // namespace two_half_steps

// Says: This is the implicit midpoint rule, solved to the last digit. It is a good method, but it needs
//       several solves a step.
// Hint: The torque of the end is wanted as it is linearised about omega. That is one iteration of Newton-Raphson
//       from omega, and no more.
namespace midpoint_to_the_end {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    Vector3d middle = omega;
    for (int i = 0; i < 10; ++i) {
        const Vector3d residual = I * (middle - omega) + h / 2 * middle.cross(I * middle);
        const Matrix3d jacobian = I + h / 2 * (skew(middle) * I - skew(I * middle));
        middle -= solve_linear(jacobian, residual);
    }
    return 2 * middle - omega;
}

}  // namespace midpoint_to_the_end

// Says: You have taken the true torque of the end and solved to the last digit. This is the trapezoidal
//       rule, at several solves a step.
// Hint: Stop after one iteration: the torque linearised about omega is what the task asks for.
namespace mean_to_the_end {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d begin = -omega.cross(I * omega);
    Vector3d w = omega;
    for (int i = 0; i < 10; ++i) {
        const Vector3d residual = I * (w - omega) - h / 2 * (begin - w.cross(I * w));
        const Matrix3d jacobian = I + h / 2 * (skew(w) * I - skew(I * w));
        w -= solve_linear(jacobian, residual);
    }
    return w;
}

}  // namespace mean_to_the_end

// Says: The method is right, but only to a few digits: numbers have gone through float, or the slope comes
//       from narrow differences.
// Hint: Use double throughout, and the product rule for the slope.
namespace few_digits {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    using Eigen::Vector3f;
    const Vector3f I = inertia.cast<float>(), w = omega.cast<float>();
    const float half = static_cast<float>(h / 2);
    const Vector3f e =
        half * Vector3f((I[2] - I[1]) / I[0], (I[0] - I[2]) / I[1], (I[1] - I[0]) / I[2]);
    const Eigen::Matrix3f matrix{{1, e[0] * w[2], e[0] * w[1]},
                                 {e[1] * w[2], 1, e[1] * w[0]},
                                 {e[2] * w[1], e[2] * w[0], 1}};
    return Vector3f(matrix.partialPivLu().solve(w)).cast<double>();
}

}  // namespace few_digits

// Says: You have foretold the torque of the end from its rate of change in time, which is explicit: nothing
//       is solved, and a step back does not undo it.
// Hint: Linearise in the spin: the torque of the end is that at omega plus a matrix times the change of the
//       spin, which you do not know yet. Solve for it.
namespace taylor {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d L = inertia.cwiseProduct(omega), torque = -omega.cross(L);
    const Vector3d slope = torque.cwiseQuotient(inertia);
    const Vector3d torque_rate = -slope.cross(L) - omega.cross(torque);
    return omega + h * (torque + h / 2 * torque_rate).cwiseQuotient(inertia);
}

}  // namespace taylor

// Says: The torque has the opposite sign on both sides: this is the step back in time.
// Hint: Does Euler's equation read I domega/dt = + omega x I omega? Look at the sign before you linearise.
namespace opposite_torque {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d G = skew(omega) * I - skew(I * omega);
    return omega - solve_linear(I - h / 2 * G, h * torque);
}

}  // namespace opposite_torque

// Says: In the matrix the identity stands where the inertia belongs: I d is not d.
// Hint: On the left stands the change of the angular momentum, I d. What is its matrix?
namespace identity_in_the_matrix {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d G = skew(omega) * I - skew(I * omega);
    return omega + solve_linear(Matrix3d::Identity() + h / 2 * G, h * torque);
}

}  // namespace identity_in_the_matrix

// Says: This is the mean of a step of explicit Euler and one of the talk's: two results are averaged, not two
//       torques.
// Hint: Write the mean of the two torques into one equation for the change d, and solve that once.
namespace mean_of_two_steps {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d G = skew(omega) * I - skew(I * omega);
    const Vector3d explicit_change = h * torque.cwiseQuotient(inertia);
    return omega + (explicit_change + solve_linear(I + h * G, h * torque)) / 2;
}

}  // namespace mean_of_two_steps

// Says: This is the change of the spin and not the spin.
// Hint: In a step of zero nothing changes. What does your function return then?
namespace only_the_change {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d G = skew(omega) * I - skew(I * omega);
    return solve_linear(I + h / 2 * G, h * torque);
}

}  // namespace only_the_change

// Says: In the matrix the torque's slope has no h: it counts as if the step lasted a second.
// Hint: Compare the units of I and of G. Which factor makes them alike?
namespace jacobian_without_h {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d G = skew(omega) * I - skew(I * omega);
    return omega + solve_linear(I + G / 2, h * torque);
}

}  // namespace jacobian_without_h

// Says: The equations are right, but llt() or ldlt() looks at one triangle of the matrix only, and takes it
//       for symmetric.
// Hint: The product of a skew matrix and a diagonal one is not symmetric. Which decomposition is for any
//       square matrix?
namespace symmetric_solver {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d G = skew(omega) * I - skew(I * omega);
    const Matrix3d jacobian = I + h / 2 * G;
    const Vector3d change = jacobian.ldlt().solve(h * torque);
    return omega + change;
}

}  // namespace symmetric_solver

// Says: This takes the torque in the middle of the step, at a spin that explicit Euler leads to: of order
//       two, but nothing is solved, and energy drifts.
// Hint: The mean of the torques at both ends is asked for, and the one of the end depends on what you look
//       for.
namespace explicit_midpoint {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const auto slope = [&](const Vector3d& w) -> Vector3d {
        return -w.cross(inertia.cwiseProduct(w)).cwiseQuotient(inertia);
    };
    const Vector3d middle = omega + h / 2 * slope(omega);
    return omega + h * slope(middle);
}

}  // namespace explicit_midpoint
