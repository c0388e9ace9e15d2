#include "exercise_eigen.hpp"

static Matrix3d skew(const Vector3d& a) {
    return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
}

// Says: The Jacobian has only one half of the product rule: the guess in front of the cross product moves,
//       too.
// Hint: omega2 stands in omega2 x (I omega2) twice. Keep each of the two fixed in turn, and let the other
//       change.
namespace missing_term {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * skew(guess) * inertia;
    return guess - solve_linear(jacobian, residual);
}

}  // namespace missing_term

// Says: Both terms of the Jacobian are there, but they are added.
// Hint: d x L has the change on the left. What happens to a cross product when you swap its two sides?
namespace sum_of_terms {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia + skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace sum_of_terms

// Says: The residual is right, but the torque's part of the Jacobian has the wrong sign.
// Hint: f has + h omega2 x (I omega2), so its slope has a plus there as well. Take the derivative of f, not
//       of the torque -omega x I omega.
namespace jacobian_sign {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia - h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace jacobian_sign

// Says: The Jacobian is right, but you have solved with llt() or ldlt(): they look at one triangle only and
//       take the matrix for symmetric.
// Hint: The inertia is symmetric, the Jacobian is not. Which decomposition in Eigen is for a general square
//       matrix?
namespace symmetric_solver {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess - jacobian.ldlt().solve(residual);
}

}  // namespace symmetric_solver

// Says: The update has the right size and goes the wrong way.
// Hint: The tangent f + J d must be zero. What is d then, with its sign?
namespace added {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess + solve_linear(jacobian, residual);
}

}  // namespace added

// Says: The update is right, but you have applied it to omega1.
// Hint: Newton-Raphson moves on from the place where the tangent touches.
namespace from_omega1 {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return omega1 - solve_linear(jacobian, residual);
}

}  // namespace from_omega1

// Says: The residual lacks the length of the step: the torque acts for a whole second.
// Hint: A torque changes the angular momentum by torque times time. Compare the second term with the task.
namespace residual_without_h {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace residual_without_h

// Says: The residual is right, but h is missing in the Jacobian.
// Hint: The derivative of h times something is h times its derivative.
namespace jacobian_without_h {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + skew(guess) * inertia - skew(L);
    return guess - solve_linear(jacobian, residual);
}

}  // namespace jacobian_without_h

// Says: The residual is that of omega1, where its first term vanishes; the Jacobian is taken at the guess.
// Hint: The tangent touches f at one place. Which omega belongs into both?
namespace residual_at_omega1 {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = h * omega1.cross(inertia * omega1);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace residual_at_omega1

// Says: This is an iteration for a torque with the opposite sign: it solves the step backwards in time.
// Hint: Euler's equations read I domega/dt + omega x I omega = 0. On which side does the term stand in f?
namespace opposite_torque {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) - h * guess.cross(L);
    const Matrix3d jacobian = inertia - h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace opposite_torque

// Says: The Jacobian is taken at omega1 and the residual at the guess. It leads to the same root, but each
//       iteration gains only a few digits and does not double them.
// Hint: The slope must be that of the place where the tangent touches.
namespace jacobian_at_omega1 {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(inertia * guess);
    const Matrix3d jacobian = inertia + h * (skew(omega1) * inertia - skew(inertia * omega1));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace jacobian_at_omega1

// Says: This is the talk's solver: one iteration that begins at omega1. Your guess has no influence.
// Hint: Put the guess where the chapter's code has omega, and look at what the residual is there.
namespace ignores_guess {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * omega1;
    const Vector3d residual = h * omega1.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(omega1) * inertia - skew(L));
    return omega1 - solve_linear(jacobian, residual);
}

}  // namespace ignores_guess

// Says: The slope of the torque is missing: you have divided by the inertia alone, and the torque is the one
//       at the guess, as it is.
// Hint: The second term of f depends on omega2 as well. What does the product rule make of it?
namespace jacobian_is_inertia {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(inertia * guess);
    return guess - inertia.inverse() * residual;
}

}  // namespace jacobian_is_inertia

// Says: You have used the three numbers on the diagonal of the tensor. This body's load lies askew, and the
//       others count.
// Hint: Multiply by the whole matrix, in the residual and in the Jacobian.
namespace diagonal_only {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Matrix3d I = inertia.diagonal().asDiagonal();
    const Vector3d L = I * guess;
    const Vector3d residual = I * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = I + h * (skew(guess) * I - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace diagonal_only

// Says: This is right to a few digits only: numbers have gone through float, or the Jacobian comes from
//       differences over a narrow width.
// Hint: Stay with double, and take the derivative by the product rule: it has no error.
namespace few_digits {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    using Eigen::Matrix3f, Eigen::Vector3f;
    const auto skew = [](const Vector3f& a) {
        return Matrix3f{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
    };
    const Matrix3f I = inertia.cast<float>();
    const Vector3f w1 = omega1.cast<float>(), w = guess.cast<float>(), L = I * w;
    const float step = static_cast<float>(h);
    const Vector3f residual = I * (w - w1) + step * w.cross(L);
    const Matrix3f jacobian = I + step * (skew(w) * I - skew(L));
    return Vector3f(w - jacobian.partialPivLu().solve(residual)).cast<double>();
}

}  // namespace few_digits

// Says: You iterate until the root is found. Asked is one iteration, from the guess that is given.
// Hint: Take your loop away and leave what is inside it.
namespace to_the_root {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    for (int round = 0; round < 20; ++round) {
        const Vector3d L = inertia * guess;
        const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
        guess -= solve_linear(inertia + h * (skew(guess) * inertia - skew(L)), residual);
    }
    return guess;
}

}  // namespace to_the_root

// Says: This is the correction alone and not the better guess.
// Hint: A guess that is the root needs no correction, and has to come back as it is. What does yours return?
namespace only_the_change {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return -solve_linear(jacobian, residual);
}

}  // namespace only_the_change

// Says: The residual has the torque's term only: how far the guess is from omega1 does not count.
// Hint: With a step of zero the torque is gone. Then omega1 must come out: what of your residual is left?
namespace first_term_missing {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace first_term_missing

// Says: In the residual omega1 and the guess are exchanged: the first term has the wrong sign.
// Hint: Compare with f in the task, term by term: which of the two spins has the minus?
namespace difference_reversed {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (omega1 - guess) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace difference_reversed

// Says: The torque has the factor h/2, as in the mean of two torques; implicit Euler has that of the end
//       alone.
// Hint: Compare with f in the task: what stands in front of the cross product?
namespace half_of_the_step {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h / 2 * guess.cross(L);
    const Matrix3d jacobian = inertia + h / 2 * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace half_of_the_step

// Says: The Jacobian has only one half of the product rule: that the momentum I omega2 moves with the guess
//       is left out.
// Hint: Keep the guess in front of the cross product fixed, and let the one behind it change. What is that
//       slope?
namespace other_term_missing {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (-skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace other_term_missing

// Says: The torque's part of the residual has the wrong sign, while the Jacobian is right.
// Hint: f has + h omega2 x (I omega2). Compare yours with it, sign by sign.
namespace residual_sign {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) - h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace residual_sign

// Says: The length of the step is used nowhere, neither in the residual nor in the Jacobian.
// Hint: With a step of zero omega1 must come out. Can it, without h?
namespace no_h_at_all {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + guess.cross(L);
    const Matrix3d jacobian = inertia + (skew(guess) * inertia - skew(L));
    return guess - solve_linear(jacobian, residual);
}

}  // namespace no_h_at_all

// Says: What you return is J⁻¹ f, the way from the better guess to the old one, and no guess.
// Hint: Newton-Raphson takes that way off the guess.
namespace only_the_tangents_way {

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    const Vector3d L = inertia * guess;
    const Vector3d residual = inertia * (guess - omega1) + h * guess.cross(L);
    const Matrix3d jacobian = inertia + h * (skew(guess) * inertia - skew(L));
    return solve_linear(jacobian, residual);
}

}  // namespace only_the_tangents_way
