#include "exercise.hpp"

// Says: This is the spring and the damper of the whole car, given to each of its wheels.
// Hint: Four wheels that act side by side add up. Each is one of four.
namespace whole_car {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / sag, 2 * zeta * mass * std::sqrt(g / sag)};
}

}  // namespace whole_car

// Says: The spring is that of one wheel, but its damper is twice as strong as it should be: is the mass still that
//       of the whole car, or is there a factor two too many?
// Hint: In zeta = c / (2 root of k m), k, c and m must belong to the same body: all of them to the car, or all to
//       a quarter of it. Put your c back into it.
namespace mass_of_the_whole_car {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double k = mass * g / (4 * sag);
    return {k, 2 * zeta * std::sqrt(k * mass)};
}

}  // namespace mass_of_the_whole_car

// Says: The damping is half of what it should be, and the car gets half the damping ratio.
// Hint: Is the 2 of zeta = c / (2 root of k m) still there? If it is, look at k and m: both must be those of the car, or
//       both those of one wheel, also where they stand in omega, the root of k/m.
namespace forgot_two {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), zeta * mass / 4 * std::sqrt(g / sag)};
}

}  // namespace forgot_two

// Says: The damping is 2 zeta omega: the coefficient of the equation that has been divided by the mass.
// Hint: Its unit is 1/s. A damper needs newtons per metre per second: multiply back what was divided.
namespace already_divided {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), 2 * zeta * std::sqrt(g / sag)};
}

}  // namespace already_divided

// Says: The springs carry the mass as if kilograms were newtons: gravity is missing.
// Hint: A spring holds a weight. Check the unit of the stiffness.
namespace forgot_gravity {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass / (4 * sag), 2 * zeta * mass / 4 * std::sqrt(1 / sag)};
}

}  // namespace forgot_gravity

// Says: The gravity of the Earth is written into the formula; the one that is handed over is not used.
// Hint: The game also plays on the Moon: take g from the arguments.
namespace earth_only {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double omega = std::sqrt(9.81 / sag);
    return {mass / 4 * omega * omega, 2 * zeta * mass / 4 * omega};
}

}  // namespace earth_only

// Says: The damping is the critical one, whatever ratio is asked.
// Hint: The ratio says which part of the critical damping is wanted.
namespace always_critical {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), mass / 2 * std::sqrt(g / sag)};
}

}  // namespace always_critical

// Says: The damping is 2 zeta k: the stiffness, which goes with omega squared, stands where a root belongs.
// Hint: Stiffness goes with the square of omega, damping with omega itself. What is the unit of yours?
namespace omega_not_rooted {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), 2 * zeta * mass / 4 * g / sag};
}

}  // namespace omega_not_rooted

// Says: The numbers are right, but the damping comes first.
// Hint: Read in the task which of the two is returned first.
namespace swapped {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {2 * zeta * mass / 4 * std::sqrt(g / sag), mass * g / (4 * sag)};
}

}  // namespace swapped

// Says: Spring and damper are those of a quarter of a wheel: there is a 4 that divides twice.
// Hint: Either begin with a quarter of the mass, or divide by the four wheels at the end. Four times your k
//       must carry the car.
namespace shared_out_twice {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double carried = mass / 4, omega = std::sqrt(g / sag);
    return {carried * omega * omega / 4, 2 * zeta * carried * omega / 4};
}

}  // namespace shared_out_twice

// Says: The spring is that of one wheel, but its damper is a quarter of what it should be: has it been divided by
//       the four wheels twice, or by a 2 that should multiply?
// Hint: Put your c back into zeta = c / (2 root of k m), with the k and m of one wheel. Which zeta does your car
//       get?
namespace damper_shared_twice {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double carried = mass / 4, k = carried * g / sag;
    return {k, 2 * zeta * std::sqrt(k * carried) / 4};
}

}  // namespace damper_shared_twice

// Says: The damper is that of one wheel, but its spring would carry the whole car alone.
// Hint: Four of your springs side by side: how far does the car sink on them?
namespace spring_of_the_whole_car {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / sag, 2 * zeta * mass / 4 * std::sqrt(g / sag)};
}

}  // namespace spring_of_the_whole_car

// Says: The spring is that of one wheel, but the damper is that of the whole car.
// Hint: The dampers act side by side, as the springs do. Share out both of them.
namespace damper_of_the_whole_car {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {mass * g / (4 * sag), 2 * zeta * mass * std::sqrt(g / sag)};
}

}  // namespace damper_of_the_whole_car

// Says: The damping is worked out with the oscillations per second, where the angular frequency belongs.
// Hint: The omega of the definition is the root of k/m as it is, in radians per second. No 2 pi divides it.
namespace turns_per_second {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double carried = mass / 4, omega = std::sqrt(g / sag);
    return {carried * g / sag, 2 * zeta * carried * omega / (2 * std::numbers::pi)};
}

}  // namespace turns_per_second

// Says: The damping is 2 zeta k m: the square root of k m is missing.
// Hint: In the definition k and m stand under a root. What is the unit of your product?
namespace root_forgotten {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double carried = mass / 4, k = carried * g / sag;
    return {k, 2 * zeta * k * carried};
}

}  // namespace root_forgotten

// Says: Four wheels make each spring four times as strong here, where each has to carry a quarter.
// Hint: More springs under the same car: must each of them be stiffer or softer?
namespace four_above {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return {4 * mass * g / sag, 2 * zeta * 4 * mass * std::sqrt(g / sag)};
}

}  // namespace four_above

// Says: The stiffness is multiplied by the four wheels, where each carries a quarter, and the damper is that of
//       the whole car.
// Hint: Divide the weight by four before you divide it by the sag.
namespace four_times_stiff {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double k = 4 * mass * g / sag;
    return {k, zeta * std::sqrt(k * mass)};
}

}  // namespace four_times_stiff

// Says: The damping is 2 zeta times the root of k alone: under the root, the mass is missing.
// Hint: What is critical depends on the mass, too: a heavy car needs a stronger damper on the same spring.
namespace undamped_root {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double carried = mass / 4, k = carried * g / sag;
    return {k, 2 * zeta * std::sqrt(k)};
}

}  // namespace undamped_root

// Says: The weight is multiplied by the sag, where a stiffness is a force for each metre.
// Hint: A spring that gives way more under the same car is softer. Divide.
namespace times_sag {

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double k = mass * g * sag / 4;
    return {k, 2 * zeta * std::sqrt(k * mass / 4)};
}

}  // namespace times_sag
