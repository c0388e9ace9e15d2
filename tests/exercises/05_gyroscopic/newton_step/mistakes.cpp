#include "exercise_eigen.hpp"

// What the mistakes are put together from, so that it is compiled once. I change + h spin x (I spin): the residual,
// where the change is spin - omega1.
static Vector3d residual_of(const Matrix3d& I, const Vector3d& change, const Vector3d& spin, double h) {
    const Vector3d L = I * spin;
    return I * change + h * spin.cross(L);
}

// I + a skew(spin) I - b skew(I spin): the Jacobian at a spin, where a and b are h.
static Matrix3d jacobian_of(const Matrix3d& I, const Vector3d& spin, double a, double b) {
    const Vector3d L = b * (I * spin), w = a * spin;
    const Matrix3d of_momentum{{0, -w.z(), w.y()}, {w.z(), 0, -w.x()}, {-w.y(), w.x(), 0}};
    const Matrix3d of_spin{{0, -L.z(), L.y()}, {L.z(), 0, -L.x()}, {-L.y(), L.x(), 0}};
    return I + of_momentum * I - of_spin;
}

// How far Newton-Raphson goes. The residual's difference is taken from `from`; residual and Jacobian are those at `at`.
static Vector3d way(const Matrix3d& I, const Vector3d& from, const Vector3d& at, double h) {
    return solve_linear(jacobian_of(I, at, h, h), residual_of(I, at - from, at, h));
}

// Says: The Jacobian has only one half of the product rule: the guess in front of the cross product moves,
//       too.
// Hint: omega2 stands in omega2 x (I omega2) twice. Keep each of the two fixed in turn, and let the other
//       change.
namespace missing_term {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, h);
    return guess - solve_linear(jacobian_of(inertia, guess, h, 0), residual);
}

}  // namespace missing_term

// Says: Both terms of the Jacobian are there, but they are added.
// Hint: d x L has the change on the left. What happens to a cross product when you swap its two sides?
namespace sum_of_terms {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, h);
    return guess - solve_linear(jacobian_of(inertia, guess, h, -h), residual);
}

}  // namespace sum_of_terms

// Says: The residual is right, but the torque's part of the Jacobian has the wrong sign.
// Hint: f has + h omega2 x (I omega2), so its slope has a plus there as well. Take the derivative of f, not of the
//       torque -omega x I omega. And does your skew matrix of a make a x b of b?
namespace jacobian_sign {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, h);
    return guess - solve_linear(jacobian_of(inertia, guess, -h, -h), residual);
}

}  // namespace jacobian_sign

// Says: The Jacobian is right, but you have solved with llt() or ldlt(): they look at one triangle only and
//       take the matrix for symmetric.
// Hint: The inertia is symmetric, the Jacobian is not. Which decomposition in Eigen is for a general square
//       matrix?
namespace symmetric_solver {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    Matrix3d jacobian = jacobian_of(inertia, guess, h, h);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j) jacobian(j, i) = jacobian(i, j);  // what ldlt() sees
    return guess - solve_linear(jacobian, residual_of(inertia, guess - omega1, guess, h));
}

}  // namespace symmetric_solver

// Says: The update has the right size and goes the wrong way.
// Hint: The tangent f + J d must be zero. What is d then, with its sign?
namespace added {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return guess + way(inertia, omega1, guess, h);
}

}  // namespace added

// Says: The update is right, but you have applied it to omega1.
// Hint: Newton-Raphson moves on from the place where the tangent touches.
namespace from_omega1 {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return omega1 - way(inertia, omega1, guess, h);
}

}  // namespace from_omega1

// Says: The residual lacks the length of the step: the torque acts for a whole second.
// Hint: A torque changes the angular momentum by torque times time. Compare the second term with the task.
namespace residual_without_h {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, 1);
    return guess - solve_linear(jacobian_of(inertia, guess, h, h), residual);
}

}  // namespace residual_without_h

// Says: The residual is right, but h is missing in the Jacobian.
// Hint: The derivative of h times something is h times its derivative.
namespace jacobian_without_h {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, h);
    return guess - solve_linear(jacobian_of(inertia, guess, 1, 1), residual);
}

}  // namespace jacobian_without_h

// Says: The residual is that of omega1, where its first term vanishes; the Jacobian is taken at the guess.
// Hint: The tangent touches f at one place. Which omega belongs into both?
namespace residual_at_omega1 {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, omega1 - omega1, omega1, h);
    return guess - solve_linear(jacobian_of(inertia, guess, h, h), residual);
}

}  // namespace residual_at_omega1

// Says: This is an iteration for a torque with the opposite sign: it solves the step backwards in time.
// Hint: Euler's equations read I domega/dt + omega x I omega = 0. On which side does the term stand in f?
namespace opposite_torque {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return guess - way(inertia, omega1, guess, -h);
}

}  // namespace opposite_torque

// Says: The Jacobian is taken at omega1 and the residual at the guess. It leads to the same root, but each
//       iteration gains only a few digits and does not double them.
// Hint: The slope must be that of the place where the tangent touches.
namespace jacobian_at_omega1 {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, h);
    return guess - solve_linear(jacobian_of(inertia, omega1, h, h), residual);
}

}  // namespace jacobian_at_omega1

// Says: This is the talk's solver: one iteration that begins at omega1. Your guess has no influence.
// Hint: Put the guess where the chapter's code has omega, and look at what the residual is there.
namespace ignores_guess {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return omega1 - way(inertia, omega1, omega1, h);
}

}  // namespace ignores_guess

// Says: The slope of the torque is missing: you have divided by the inertia alone, and the torque is the one
//       at the guess, as it is.
// Hint: The second term of f depends on omega2 as well. What does the product rule make of it?
namespace jacobian_is_inertia {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return guess - solve_linear(inertia, residual_of(inertia, guess - omega1, guess, h));
}

}  // namespace jacobian_is_inertia

// Says: You have used the three numbers on the diagonal of the tensor. This body's load lies askew, and the
//       others count.
// Hint: Multiply by the whole matrix, in the residual and in the Jacobian.
namespace diagonal_only {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Matrix3d I{{inertia(0, 0), 0, 0}, {0, inertia(1, 1), 0}, {0, 0, inertia(2, 2)}};
    return guess - way(I, omega1, guess, h);
}

}  // namespace diagonal_only

// Says: This is right to a few digits only: numbers have gone through float, or the Jacobian comes from
//       differences over a narrow width.
// Hint: Stay with double, and take the derivative by the product rule: it has no error.
namespace few_digits {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const auto rounded = [](double number) { return double(float(number)); };
    const Matrix3d I = inertia.unaryExpr(rounded);
    const Vector3d w1 = omega1.unaryExpr(rounded), w = guess.unaryExpr(rounded);
    const Matrix3d jacobian = jacobian_of(I, w, rounded(h), rounded(h)).unaryExpr(rounded);
    const Vector3d residual = residual_of(I, w - w1, w, rounded(h)).unaryExpr(rounded);
    return (w - solve_linear(jacobian, residual)).unaryExpr(rounded);
}

}  // namespace few_digits

// Says: You iterate until the root is found. Asked is one iteration, from the guess that is given.
// Hint: Take your loop away. What is left must be one iteration of Newton-Raphson, from the guess.
namespace to_the_root {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    for (int round = 0; round < 20; ++round) guess = guess - way(inertia, omega1, guess, h);
    return guess;
}

}  // namespace to_the_root

// Says: This is the correction alone and not the better guess.
// Hint: A guess that is the root needs no correction, and has to come back as it is. What does yours return?
namespace only_the_change {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return -way(inertia, omega1, guess, h);
}

}  // namespace only_the_change

// Says: The residual has the torque's term only: how far the guess is from omega1 does not count.
// Hint: With a step of zero the torque is gone. Then omega1 must come out: what of your residual is left?
namespace first_term_missing {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - guess, guess, h);
    return guess - solve_linear(jacobian_of(inertia, guess, h, h), residual);
}

}  // namespace first_term_missing

// Says: In the residual omega1 and the guess are exchanged: the first term has the wrong sign.
// Hint: Compare with f in the task, term by term: which of the two spins has the minus?
namespace difference_reversed {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, omega1 - guess, guess, h);
    return guess - solve_linear(jacobian_of(inertia, guess, h, h), residual);
}

}  // namespace difference_reversed

// Says: The torque has the factor h/2, as in the mean of two torques; implicit Euler has that of the end
//       alone.
// Hint: Compare with f in the task: what stands in front of the cross product?
namespace half_of_the_step {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return guess - way(inertia, omega1, guess, h / 2);
}

}  // namespace half_of_the_step

// Says: The Jacobian has only one half of the product rule: that the momentum I omega2 moves with the guess
//       is left out.
// Hint: Keep the guess in front of the cross product fixed, and let the one behind it change. What is that
//       slope?
namespace other_term_missing {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, h);
    return guess - solve_linear(jacobian_of(inertia, guess, 0, h), residual);
}

}  // namespace other_term_missing

// Says: The torque's part of the residual has the wrong sign, while the Jacobian is right.
// Hint: f has + h omega2 x (I omega2). Compare yours with it, sign by sign.
namespace residual_sign {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = residual_of(inertia, guess - omega1, guess, -h);
    return guess - solve_linear(jacobian_of(inertia, guess, h, h), residual);
}

}  // namespace residual_sign

// Says: The length of the step is used nowhere, neither in the residual nor in the Jacobian.
// Hint: With a step of zero omega1 must come out. Can it, without h?
namespace no_h_at_all {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return guess - way(inertia, omega1, guess, 1);
}

}  // namespace no_h_at_all

// Says: What you return is J⁻¹ f, the way from the better guess to the old one, and no guess.
// Hint: Newton-Raphson takes that way off the guess.
namespace only_the_tangents_way {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return way(inertia, omega1, guess, h);
}

}  // namespace only_the_tangents_way

// Says: The Jacobian comes from differences over a narrow width, in which most digits cancel.
// Hint: The product rule has no error: the derivative of omega x (I omega) has two terms. (Differences to both sides,
//       as wide as the spin, would do as well, for the residual is quadratic.)
namespace narrow_differences {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d here = residual_of(inertia, guess - omega1, guess, h);
    Matrix3d jacobian;
    for (int i = 0; i < 3; ++i) {
        Vector3d aside = guess;
        aside[i] += 1e-6;
        const Vector3d rise = residual_of(inertia, aside - omega1, aside, h) - here;
        for (int j = 0; j < 3; ++j) jacobian(j, i) = rise[j] / 1e-6;
    }
    return guess - solve_linear(jacobian, here);
}

}  // namespace narrow_differences

// Says: The torque in the residual is that of omega1, and the Jacobian that of a torque that moves with the guess.
// Hint: All of f is taken at the guess: I (guess - omega1) and h guess x (I guess).
namespace torque_at_omega1 {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d f = inertia * (guess - omega1) + h * omega1.cross(inertia * omega1);
    return guess - solve_linear(jacobian_of(inertia, guess, h, h), f);
}

}  // namespace torque_at_omega1
