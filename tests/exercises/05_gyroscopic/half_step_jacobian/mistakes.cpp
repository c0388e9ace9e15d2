#include "exercise_eigen.hpp"

// What the mistakes are put together from, so that it is compiled once. The torque -omega x (I omega).
static Vector3d torque_at(const Vector3d& inertia, const Vector3d& omega) {
    const Vector3d L = inertia.cwiseProduct(omega);
    return L.cross(omega);
}

// The spin's rate of change.
static Vector3d slope_at(const Vector3d& inertia, const Vector3d& omega) {
    return torque_at(inertia, omega).cwiseQuotient(inertia);
}

// A matrix with `moments` on the diagonal, plus a skew(omega) I - b skew(I omega): with a = b = h/2 the one to solve
// with, I + h/2 G.
static Matrix3d matrix_of(const Vector3d& moments, const Vector3d& I, const Vector3d& omega, double a, double b) {
    Matrix3d matrix = moments.asDiagonal();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        matrix(i, j) = (b * I[k] - a * I[j]) * omega[k];
        matrix(i, k) = (a * I[k] - b * I[j]) * omega[j];
    }
    return matrix;
}

// The change of the spin: the d with (I + factor G) d = impulse.
static Vector3d change(const Vector3d& I, const Vector3d& omega, double factor, const Vector3d& impulse) {
    return solve_linear(matrix_of(I, I, omega, factor, factor), impulse);
}

// Says: This is the talk's solver: the torque is that of the end alone, and the spin slows down by itself.
// Hint: The mean counts each end for one half. Only the torque of the end has the unknown change in it.
namespace full_jacobian {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + change(inertia, omega, h, h * torque_at(inertia, omega));
}

}  // namespace full_jacobian

// Says: This is the spin in the middle of the step: the change is half as large as it should be. Does the torque act
//       for h/2 only, or is the change of half a step never doubled?
// Hint: The two ends have one half each. The torque of the beginning stands in both.
namespace half_step {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + change(inertia, omega, h / 2, h / 2 * torque_at(inertia, omega));
}

}  // namespace half_step

// Says: Your change is half of that of the talk's solver. Is the torque on the right halved where the Jacobian
//       should be, or are the old spin and the talk's new one averaged?
// Hint: Write the mean of T and T - G d. How much of T is in it, and how much of G d?
namespace half_torque {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + change(inertia, omega, h, h / 2 * torque_at(inertia, omega));
}

}  // namespace half_torque

// Says: In omega x I omega you have let only the omega in front change; I omega is that of the beginning. The energy
//       stays, but a step back does not undo it.
// Hint: The product rule has two terms. Here the one where the momentum changes is missing.
namespace old_momentum {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + solve_linear(matrix_of(inertia, inertia, omega, 0, h / 2), h * torque_at(inertia, omega));
}

}  // namespace old_momentum

// Says: In omega x I omega you have let only the momentum change; the omega in front is that of the beginning.
// Hint: The product rule has two terms. The one with skew(I omega) is missing.
namespace old_spin {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + solve_linear(matrix_of(inertia, inertia, omega, h / 2, 0), h * torque_at(inertia, omega));
}

}  // namespace old_spin

// Says: The Jacobian has both terms of the product rule, but added.
// Hint: Where the change stands on the left of the cross product, it has to be swapped to the right. What does that do
//       to the sign?
namespace sum_of_terms {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + solve_linear(matrix_of(inertia, inertia, omega, h / 2, -h / 2), h * torque_at(inertia, omega));
}

}  // namespace sum_of_terms

// Says: The torque of the end is linearised with the wrong sign: it rises where it should fall.
// Hint: The torque is minus omega x I omega, and the Jacobian stands on the left side. Count the minus signs once
//       more, those in the skew matrix, too: does it make omega x d of d?
namespace jacobian_sign {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + change(inertia, omega, -h / 2, h * torque_at(inertia, omega));
}

}  // namespace jacobian_sign

// Says: The Jacobian is right, but the change goes the wrong way: is it taken away from omega, or has the torque on
//       the right side the wrong sign?
// Hint: With the torque -omega x I omega on the right the change is added. With the residual + h omega x I omega it
//       is taken away.
namespace subtracted {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega - change(inertia, omega, h / 2, h * torque_at(inertia, omega));
}

}  // namespace subtracted

// Says: This is explicit Euler: only the torque at the beginning counts, and nothing is solved.
// Hint: The torque of the end depends on the change of the spin. Linearise it, and solve for the change.
namespace explicit_euler {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + h * slope_at(inertia, omega);
}

}  // namespace explicit_euler

// Says: You have taken the torque of the end at the spin that explicit Euler leads to. This has order two, but it is
//       explicit: a step back does not undo it.
// Hint: Let the change that you look for stand in the linearised torque, and solve for it.
namespace heun {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d begin = slope_at(inertia, omega), end = slope_at(inertia, omega + h * begin);
    return omega + h / 2 * Vector3d(begin + end);
}

}  // namespace heun

// Says: These are two of the talk's steps, each of half the length: twice the price, and still of order one.
// Hint: One solve is enough. What happens to the change of the first half if you just take it twice?
namespace two_half_steps {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    Vector3d w = omega;
    for (int i = 0; i < 2; ++i) w = w + change(inertia, w, h / 2, h / 2 * torque_at(inertia, w));
    return w;
}

}  // namespace two_half_steps

// Says: This is the implicit midpoint rule, found to the last digit. It is a good method, but it needs several
//       rounds a step.
// Hint: The torque of the end is wanted as it is linearised about omega. That is one iteration of Newton-Raphson
//       from omega, and no more.
namespace midpoint_to_the_end {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    Vector3d middle = omega;
    for (int i = 0; i < 10; ++i) {
        const Vector3d impulse = h / 2 * torque_at(inertia, middle);
        const Vector3d missing = inertia.cwiseProduct(omega - middle);
        middle = middle + change(inertia, middle, h / 2, missing + impulse);
    }
    return middle + Vector3d(middle - omega);
}

}  // namespace midpoint_to_the_end

// Says: You have taken the true torque of the end, and found the spin to the last digit. This is the trapezoidal
//       rule, at several rounds a step.
// Hint: One solve is enough: the torque linearised about omega is what the task asks for.
namespace mean_to_the_end {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d begin = torque_at(inertia, omega);
    Vector3d w = omega;
    for (int i = 0; i < 10; ++i) {
        const Vector3d impulse = h / 2 * Vector3d(begin + torque_at(inertia, w));
        const Vector3d missing = inertia.cwiseProduct(omega - w);
        w = w + change(inertia, w, h / 2, missing + impulse);
    }
    return w;
}

}  // namespace mean_to_the_end

// Says: The method is right, but only to a few digits: numbers have gone through float, or the slope comes from narrow
//       differences.
// Hint: Use double throughout, and the product rule for the slope.
namespace few_digits {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const auto rounded = [](double number) { return double(float(number)); };
    const Vector3d I = inertia.unaryExpr(rounded), w = omega.unaryExpr(rounded);
    const double half = rounded(h / 2);
    const Vector3d e(rounded(half * rounded(rounded(I[2] - I[1]) / I[0])),
                     rounded(half * rounded(rounded(I[0] - I[2]) / I[1])),
                     rounded(half * rounded(rounded(I[1] - I[0]) / I[2])));
    Matrix3d matrix = Matrix3d::Identity();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        matrix(i, j) = rounded(e[i] * w[k]);
        matrix(i, k) = rounded(e[i] * w[j]);
    }
    return solve_linear(matrix, w).unaryExpr(rounded);
}

}  // namespace few_digits

// Says: You have foretold the torque of the end, from its rate of change in time or with the change that explicit
//       Euler makes: nothing is solved, and a step back does not undo it.
// Hint: Linearise in the spin: the torque of the end is that at omega plus a matrix times the change of the spin, which
//       you do not know yet. Solve for it.
namespace taylor {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d L = inertia.cwiseProduct(omega), torque = torque_at(inertia, omega), slope = slope_at(inertia, omega);
    const Vector3d torque_rate = L.cross(slope) + torque.cross(omega);
    const Vector3d mean = torque + h / 2 * torque_rate;
    return omega + h * Vector3d(mean.cwiseQuotient(inertia));
}

}  // namespace taylor

// Says: The torque has the opposite sign on both sides: this is the step back in time.
// Hint: Does Euler's equation read I domega/dt = + omega x I omega? Look at the sign before you linearise.
namespace opposite_torque {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega - change(inertia, omega, -h / 2, h * torque_at(inertia, omega));
}

}  // namespace opposite_torque

// Says: In the matrix the identity stands where the inertia belongs: I d is not d.
// Hint: On the left stands the change of the angular momentum, I d. What is its matrix?
namespace identity_in_the_matrix {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Matrix3d matrix = matrix_of({1, 1, 1}, inertia, omega, h / 2, h / 2);
    return omega + solve_linear(matrix, h * torque_at(inertia, omega));
}

}  // namespace identity_in_the_matrix

// Says: This is the mean of a step of explicit Euler and one of the talk's: two results are averaged, not two torques.
// Hint: Write the mean of the two torques into one equation for the change d, and solve that once.
namespace mean_of_two_steps {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d explicit_change = h * slope_at(inertia, omega);
    const Vector3d implicit_change = change(inertia, omega, h, h * torque_at(inertia, omega));
    return omega + 0.5 * Vector3d(explicit_change + implicit_change);
}

}  // namespace mean_of_two_steps

// Says: This is the change of the spin and not the spin.
// Hint: In a step of zero nothing changes. What does your function return then?
namespace only_the_change {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return change(inertia, omega, h / 2, h * torque_at(inertia, omega));
}

}  // namespace only_the_change

// Says: In the matrix the torque's slope has no h: it counts as if the step lasted a second.
// Hint: Compare the units of I and of G. Which factor makes them alike?
namespace jacobian_without_h {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return omega + change(inertia, omega, 0.5, h * torque_at(inertia, omega));
}

}  // namespace jacobian_without_h

// Says: The equations are right, but llt() or ldlt() looks at one triangle of the matrix only, and takes it for
//       symmetric.
// Hint: The product of a skew matrix and a diagonal one is not symmetric. Which decomposition is for any square matrix?
namespace symmetric_solver {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    Matrix3d matrix = matrix_of(inertia, inertia, omega, h / 2, h / 2);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j) matrix(j, i) = matrix(i, j);  // what ldlt() sees
    return omega + solve_linear(matrix, h * torque_at(inertia, omega));
}

}  // namespace symmetric_solver

// Says: This takes the torque in the middle of the step, at a spin that explicit Euler leads to: of order two, but
//       nothing is solved, and energy drifts.
// Hint: The mean of the torques at both ends is asked for, and the one of the end depends on what you look for.
namespace explicit_midpoint {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d middle = omega + h / 2 * slope_at(inertia, omega);
    return omega + h * slope_at(inertia, middle);
}

}  // namespace explicit_midpoint

// Says: The slope of the torque comes from differences over a narrow width, in which most digits cancel.
// Hint: The product rule has no error: the derivative of omega x (I omega) has two terms. (Differences to both sides,
//       as wide as the spin, would do as well, for the torque is quadratic.)
namespace narrow_differences {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    Matrix3d matrix = inertia.asDiagonal();
    for (int i = 0; i < 3; ++i) {
        Vector3d ahead = omega, behind = omega;
        ahead[i] += 1e-6, behind[i] -= 1e-6;
        const Vector3d rise = torque_at(inertia, ahead) - torque_at(inertia, behind);
        for (int j = 0; j < 3; ++j) matrix(j, i) -= h / 2 * rise[j] / 2e-6;
    }
    return omega + solve_linear(matrix, h * torque_at(inertia, omega));
}

}  // namespace narrow_differences

// Says: Two moments that are nearly equal are taken for equal, and their difference for nothing.
// Hint: Nearly equal is not equal. The formula has nothing to divide by there; it needs no question.
namespace nearly_equal_moments {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    Vector3d rounded = inertia;
    for (int i = 0; i < 3; ++i)
        if (std::fabs(inertia[i] - inertia[(i + 1) % 3]) < 1e-4 * inertia[i]) rounded[(i + 1) % 3] = rounded[i];
    Matrix3d matrix = rounded.asDiagonal();
    for (int i = 0; i < 3; ++i) {
        const Vector3d e = Vector3d::Unit(i);
        matrix.col(i) -= h / 2 * (torque_at(rounded, omega + e) - torque_at(rounded, omega) - torque_at(rounded, e));
    }
    return omega + solve_linear(matrix, h * torque_at(rounded, omega));
}

}  // namespace nearly_equal_moments

// Says: Half a step of explicit Euler is followed by half a step of the talk's: torque and slope are those half-way.
// Hint: The method solves once, for the whole step, and takes torque and slope at the spin of the beginning.
namespace two_halves_of_two_methods {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const Vector3d middle = omega + h / 2 * slope_at(inertia, omega);
    return middle + change(inertia, middle, h / 2, h / 2 * torque_at(inertia, middle));
}

}  // namespace two_halves_of_two_methods
