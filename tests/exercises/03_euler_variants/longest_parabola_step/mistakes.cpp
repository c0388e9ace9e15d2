#include "exercise.hpp"

// Says: This is the limit of explicit Euler.
// Hint: The parabola adds h² a / 2 to the position. That changes the first row of the matrix.
namespace explicit_euler {

double longest_parabola_step(double omega, double zeta) {
    if (zeta <= 1) return 2 * zeta / omega;
    return 2 / (zeta + std::sqrt(zeta * zeta - 1)) / omega;
}

}  // namespace explicit_euler

// Says: This is the limit of semi-implicit Euler with the damping at the old velocity.
// Hint: There the position moves with the new velocity, x1 + h v1 + h² a1. Here it is half of the last term.
namespace semi_implicit {

double longest_parabola_step(double omega, double zeta) {
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / omega;
}

}  // namespace semi_implicit

// Says: This is where a complex pair of eigenvalues leaves the unit circle. With strong damping the
//       eigenvalues are real before that, and one of them leaves at -1.
// Hint: A determinant below one is not enough: two real roots may have a small product, and one of them be
//       large.
namespace pair_only {

double longest_parabola_step(double omega, double zeta) {
    return 4 * zeta / omega;
}

}  // namespace pair_only

// Says: This is 1/(zeta omega), where a real eigenvalue passes -1, for every damping. With weak damping the pair is
//       complex, and leaves the unit circle much earlier.
// Hint: For a complex pair, look at the determinant.
namespace real_root_only {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : 1 / (zeta * omega);
}

}  // namespace real_root_only

// Says: This asks only that the trace lies between -2 and 2. That is enough where the determinant is 1, as
//       for semi-implicit Euler without damping.
// Hint: Work out this determinant: it depends on h. Then look at the roots themselves.
namespace trace_only {

double longest_parabola_step(double omega, double zeta) {
    return (std::sqrt(4 * zeta * zeta + 8) - 2 * zeta) / omega;
}

}  // namespace trace_only

// Says: This is the longest omega h, a number without a unit.
// Hint: The step itself is asked, in seconds.
namespace omega_h {

double longest_parabola_step(double omega, double zeta) {
    return zeta < 0.5 ? 4 * zeta : 1 / zeta;
}

}  // namespace omega_h

// Says: The damping is half of what zeta says: the factor two in 2 zeta omega v is missing.
// Hint: Take the acceleration letter by letter from the task.
namespace half_damping {

double longest_parabola_step(double omega, double zeta) {
    return (zeta < 1 ? 2 * zeta : 2 / zeta) / omega;
}

}  // namespace half_damping

// Says: Every spring gets the step of the example.
// Hint: Write the step as a matrix first: its trace and determinant depend on omega h and zeta.
namespace example {

double longest_parabola_step(double omega, double zeta) {
    return 0.04;
}

}  // namespace example

// Says: Both limits are right, but you return the longer one.
// Hint: A run must die away in both ways at once: how long may a step be that is to keep within two limits?
namespace longer_of_two {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : std::max(4 * zeta, 1 / zeta) / omega;
}

}  // namespace longer_of_two

// Says: Both limits are right, but you go over from one to the other too late, as at zeta = 1, where the door
//       itself stops swinging. The steps stop swinging earlier.
// Hint: It is not the door's motion that counts, but the matrix of the step. For which zeta are the two
//       limits equal?
namespace switch_at_one {

double longest_parabola_step(double omega, double zeta) {
    return (zeta < 1 ? 4 * zeta : 1 / zeta) / omega;
}

}  // namespace switch_at_one

// Says: The limit of weak damping is half of what it is: 2 zeta, where the half in h² a / 2 makes it 4
//       zeta.
// Hint: In the determinant, wh² stands with a half. Solve 1 - 2 zeta wh + wh²/2 = 1 once more.
namespace two_zeta {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : std::min(2 * zeta, 1 / zeta) / omega;
}

}  // namespace two_zeta

// Says: The limit of strong damping is twice as long as it is: 2 / zeta, where a real eigenvalue has passed
//       -1 already.
// Hint: Work out 1 + trace + determinant: the terms with wh² cancel. How many zeta wh are left of it?
namespace two_over_zeta {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : std::min(4 * zeta, 2 / zeta) / omega;
}

}  // namespace two_over_zeta

// Says: The longest omega h is multiplied by omega, where it has to be divided.
// Hint: A stiffer spring needs shorter steps. Check the unit, too: seconds are asked.
namespace times_omega {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : std::min(4 * zeta, 1 / zeta) * omega;
}

}  // namespace times_omega

// Says: This is 2 / omega, the limit of Verlet and of semi-implicit Euler without damping, whatever zeta
//       is.
// Hint: Without a damper this step is never stable. Which argument have you left out?
namespace verlet {

double longest_parabola_step(double omega, double zeta) {
    return 2 / omega;
}

}  // namespace verlet

// Says: The limit of weak damping is twice as long as it is: 8 zeta, beyond which every oscillation has
//       grown for long.
// Hint: Try it with zeta = 0.1: the limit of the example is 4 zeta over omega.
namespace eight_zeta {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : std::min(8 * zeta, 1 / zeta) / omega;
}

}  // namespace eight_zeta

// Says: The limit of strong damping is half as long as it is: 1 / (2 zeta), where no eigenvalue leaves yet.
// Hint: 1 + trace + determinant is 4 - 4 zeta wh. Where is that zero?
namespace half_over_zeta {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : std::min(4 * zeta, 0.5 / zeta) / omega;
}

}  // namespace half_over_zeta

// Says: The limit of strong damping is 2 / omega, whatever zeta is: that is where a spring without a damper ends.
// Hint: The harder the damper, the sooner the real eigenvalue passes -1. Where does zeta stand in your limit?
namespace real_limit_of_verlet {

double longest_parabola_step(double omega, double zeta) {
    return std::min(4 * zeta, 2.0) / omega;
}

}  // namespace real_limit_of_verlet

// Says: Without damping you return 2 / omega, the limit of Verlet. This method gains energy in any step there.
// Hint: Put zeta = 0 into the determinant: it is more than one, however short the step is.
namespace undamped_as_verlet {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 2 / omega : std::min(4 * zeta, 1 / zeta) / omega;
}

}  // namespace undamped_as_verlet

// Says: With damping this is the limit of semi-implicit Euler with the damping at the old velocity.
// Hint: Write down the matrix of the parabola: its first row has half of the last term that semi-implicit Euler has.
namespace semi_implicit_but_for_zero {

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : semi_implicit::longest_parabola_step(omega, zeta);
}

}  // namespace semi_implicit_but_for_zero

// Says: Only the determinant is asked: between −1 and 1. With strong damping a real eigenvalue passes −1 while
//       the product of the two is still small.
// Hint: The product of −1.5 and 0.1 is small, too. What must hold of the sum beside it, that is of the trace?
namespace determinant_only {

double longest_parabola_step(double omega, double zeta) {
    const double wide = 4 * zeta;
    return (zeta < 1 ? wide : std::min(wide, 2 * (zeta - std::sqrt(zeta * zeta - 1)))) / omega;
}

}  // namespace determinant_only

// Says: The limit is too short by 2π: omega is taken for a number of periods a second. It is one of radians.
// Hint: A period has 2π radians. What is the unit of omega, by the task?
namespace omega_in_hertz {

double longest_parabola_step(double omega, double zeta) {
    const double limit = zeta < 0.5 ? 4 * zeta : 1 / zeta;
    return limit / (2 * 3.141592653589793 * omega);
}

}  // namespace omega_in_hertz
