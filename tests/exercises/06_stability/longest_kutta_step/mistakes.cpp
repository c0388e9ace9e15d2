#include "exercise.hpp"

using Complex = std::complex<double>;

// The two lambda/omega: as far from zero as can be, and nearer.
static Complex root_of(double zeta) {
    return std::sqrt(Complex(zeta * zeta - 1));
}
static Complex fast_of(double zeta) {
    return -zeta - root_of(zeta);
}
static Complex slow_of(double zeta) {
    return -zeta + root_of(zeta);
}

// The method's R(z), whose third power has the factor `cube`.
static double growth(Complex z, double cube = 1.0 / 6) {
    return std::abs(1.0 + z + z * z / 2.0 + cube * z * z * z);
}

// By halving, from omega h = 0 to `bad`: up to where is it stable?
template <class Stable>
static double longest(Stable stable, double bad = 3, int halvings = 80) {
    double good = 0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (good + bad) / 2;
        (stable(middle) ? good : bad) = middle;
    }
    return good;
}
static double longest_along(Complex lambda, double bad = 3, double cube = 1.0 / 6, int halvings = 80) {
    return longest([&](double wh) { return growth(wh * lambda, cube) <= 1; }, bad, halvings);
}

// Beyond critical damping: from R(z) = -1, by Newton-Raphson.
static double longest_on_the_axis(double zeta) {
    double z = -2.5;
    for (int i = 0; i < 20; ++i) z -= (2 + z + z * z / 2 + z * z * z / 6) / (1 + z + z * z / 2);
    return -z / (zeta + std::sqrt(zeta * zeta - 1));
}

// Says: This is the limit of midpoint and Heun: R ends with z².
// Hint: The third look brings a third power of z. Put k1 and k2 into k3.
namespace two_looks {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta), 3, 0) / omega;
}
}  // namespace two_looks

// Says: This is the limit of RK4: R has a fourth power of z. Three looks make three powers.
// Hint: Each look multiplies by z once more. Count them.
namespace four_looks {
double longest_kutta_step(double omega, double zeta) {
    return longest([&](double wh) {
               const Complex z = wh * fast_of(zeta);
               return std::abs(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0) <= 1;
           }, 4) / omega;
}
}  // namespace four_looks

// Says: The third power in R has the factor 1/3.
// Hint: Follow k3: 2 k2 - k1 has a term with z, and stands behind a sixth of h.
namespace factor_of_cube {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta), 3, 1.0 / 3) / omega;
}
}  // namespace factor_of_cube

// Says: This is the limit of explicit Euler.
// Hint: Put f(y) = lambda y into all four lines of the method before you ask how large R is.
namespace explicit_euler {
double longest_kutta_step(double omega, double zeta) {
    return (zeta <= 1 ? 2 * zeta : 2 / (zeta + std::sqrt(zeta * zeta - 1))) / omega;
}
}  // namespace explicit_euler

// Says: With a strong damper you follow the slow decay out of the region. The fast one has left it long before.
// Hint: The spring has two lambda, and neither may grow. Which one is larger?
namespace slow_decay {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(slow_of(zeta), 1e5) / omega;
}
}  // namespace slow_decay

// Says: With a strong damper you follow the slow decay, and your search from 0 to 3 / omega never sees it leave the
//       region: the answer is the end of the search.
// Hint: A search that stops at its own end has found nothing. Which of the two lambda leaves before omega h = 3,
//       whatever the damper?
namespace slow_decay_to_three {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(slow_of(zeta)) / omega;
}
}  // namespace slow_decay_to_three

// Says: With a strong damper you follow the slow decay, as far as your search goes, to 10 / omega. The fast one grows
//       in much shorter steps.
// Hint: Ask both lambda at the step that you found. One of them has |R| far above 1.
namespace slow_decay_to_ten {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(slow_of(zeta), 10) / omega;
}
}  // namespace slow_decay_to_ten

// Says: With a strong damper you follow the slow decay, as far as your search goes, to 100 / omega. The fast one grows
//       in much shorter steps than that.
// Hint: Try both signs before the root of zeta² - 1, and compare the sizes of the two lambda.
namespace slow_decay_to_hundred {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(slow_of(zeta), 100) / omega;
}
}  // namespace slow_decay_to_hundred

// Says: With a strong damper you follow the slow decay, as far as your search goes, to 1000 / omega. The fast one has
//       left the region hundreds of times earlier.
// Hint: The step must suit the two lambda together: the shorter of their two limits counts.
namespace slow_decay_to_thousand {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(slow_of(zeta), 1000) / omega;
}
}  // namespace slow_decay_to_thousand

// Says: Beyond critical damping you take the root of a negative number as a double: it is NaN, no comparison with it
//       holds, and the step comes out as zero.
// Hint: std::sqrt of a std::complex<double> knows negative numbers. Or tell the two cases apart.
namespace no_answer_beyond_one {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(Complex(-zeta, std::sqrt(1 - zeta * zeta))) / omega;
}
}  // namespace no_answer_beyond_one

// Says: Below critical damping you take the root of zeta² - 1, a negative number, as a double: it is NaN, no comparison
//       with it holds, and the step comes out as zero.
// Hint: Where the door swings its lambda are complex. Make the number under the root a std::complex<double> first.
namespace no_answer_below_one {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(-zeta - std::sqrt(zeta * zeta - 1)) / omega;
}
}  // namespace no_answer_below_one

// Says: Below critical damping you take the root of zeta² - 1, a negative number, as a double. NaN is not above 1, so
//       your search takes every step for stable and ends at its far end, 3 / omega.
// Hint: Print lambda for zeta = 0.5. The root has to be one of a std::complex<double>.
namespace search_stays_below_one {
double longest_kutta_step(double omega, double zeta) {
    const double fast = -zeta - std::sqrt(zeta * zeta - 1);
    return longest([&](double wh) { return !(growth(wh * fast) > 1); }) / omega;
}
}  // namespace search_stays_below_one

// Says: Beyond critical damping this is right. Below, zeta² - 1 is negative and its root as a double is NaN, and so is
//       the step.
// Hint: The limit on the real axis holds for doors that do not swing. For the others lambda is complex: search along
//       its ray.
namespace not_a_number_below_one {
double longest_kutta_step(double omega, double zeta) {
    return longest_on_the_axis(zeta) / omega;
}
}  // namespace not_a_number_below_one

// Says: Beyond critical damping the spring has two real lambda. You still let it swing.
// Hint: The root of zeta² - 1 is real there, and belongs to the real part of lambda.
namespace size_beyond_one {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(Complex(-zeta, std::sqrt(std::fabs(1 - zeta * zeta)))) / omega;
}
}  // namespace size_beyond_one

// Says: This is the limit without a damper, for every damper.
// Hint: zeta moves both z to the left, away from the imaginary axis. Where do they leave the region then?
namespace never_damped {
double longest_kutta_step(double omega, double zeta) {
    return std::sqrt(3.0) / omega;
}
}  // namespace never_damped

// Says: Every door that swings gets the limit without a damper, sqrt(3) / omega. Only beyond critical damping does zeta
//       count here.
// Hint: A weak damper, too, moves z to the left. Follow z = omega h (-zeta + i sqrt(1 - zeta²)) until |R| is 1.
namespace undamped_below_one {
double longest_kutta_step(double omega, double zeta) {
    return (zeta < 1 ? std::sqrt(3.0) : longest_on_the_axis(zeta)) / omega;
}
}  // namespace undamped_below_one

// Says: Every door with zeta = 1 or less gets the limit without a damper, sqrt(3) / omega. Only beyond critical damping
//       does zeta count here.
// Hint: At zeta = 1 both z are real, and may go as far as -2.51. Between zero and one the limit depends on zeta, too:
//       find it along the ray of z.
namespace undamped_up_to_one {
double longest_kutta_step(double omega, double zeta) {
    return (zeta <= 1 ? std::sqrt(3.0) : longest_on_the_axis(zeta)) / omega;
}
}  // namespace undamped_up_to_one

// Says: Only the real part of lambda counts here: the door decays and does not swing.
// Hint: zeta omega is how fast the oscillation dies. lambda has an imaginary part, too, or a root that is real.
namespace decay_of_zeta_omega {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(-zeta, 1e5) / omega;
}
}  // namespace decay_of_zeta_omega

// Says: With a weak damper you put the size of z on the real axis. z has a direction, and the region is not round.
// Hint: Use complex numbers: z = omega h (-zeta + i sqrt(1 - zeta²)) where the door swings.
namespace size_as_decay {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(-(zeta > 1 ? zeta + std::sqrt(zeta * zeta - 1) : 1.0)) / omega;
}
}  // namespace size_as_decay

// Says: This is the longest omega h, a number without a unit.
// Hint: The step is asked, in seconds.
namespace number_without_unit {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta));
}
}  // namespace number_without_unit

// Says: Nothing beyond omega h = 2 comes out: your search ends there.
// Hint: 2 is the limit of semi-implicit Euler. Before you halve an interval make sure that its far end is unstable.
namespace search_ends_early {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta), 2) / omega;
}
}  // namespace search_ends_early

// Says: omega has been taken for a frequency in hertz and multiplied by 2 pi.
// Hint: The task gives omega in rad/s. Use it as it is.
namespace hertz {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta)) / (2 * std::numbers::pi * omega);
}
}  // namespace hertz

// Says: The damper is half as strong as zeta says: these are the rates for a = -omega² x - zeta omega v.
// Hint: Take the acceleration letter by letter, and solve lambda² + 2 zeta omega lambda + omega² = 0 again.
namespace half_damping {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta / 2)) / omega;
}
}  // namespace half_damping

// Says: Right to three digits or so: you walk outwards in small strides and stop at the last one that is stable.
// Hint: Between the last stride that is stable and the first that is not, halve.
namespace coarse_search {
double longest_kutta_step(double omega, double zeta) {
    const Complex fast = fast_of(zeta);
    const double notch = 1e-3 / std::abs(fast);
    double wh = 0;
    while (wh < 3 && growth((wh + notch) * fast) <= 1 + 1e-12) wh += notch;
    return wh / omega;
}
}  // namespace coarse_search

// Says: Near, but your search stops too early: it walks outwards in strides of a thousandth of 1 / omega. A hard
//       damper's limit is shorter than one such stride, and comes out as zero.
// Hint: The last stride that is stable and the first that is not enclose the limit. Halve between them, sixty times.
namespace scan_of_thousandths {
double longest_kutta_step(double omega, double zeta) {
    const Complex fast = fast_of(zeta);
    double wh = 0;
    while (wh < 3 && growth((wh + 1e-3) * fast) <= 1) wh += 1e-3;
    return wh / omega;
}
}  // namespace scan_of_thousandths

// Says: Near, but your search stops too early: after some twenty halvings the interval is still some millionths of 1
//       / omega wide, and a hard damper's limit may be only some forty times that.
// Hint: Each halving gives one more binary digit. Sixty cost nothing.
namespace few_halvings {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta), 3, 1.0 / 6, 20) / omega;
}
}  // namespace few_halvings

// Says: Right to a few digits only: a number is rounded or has gone through float, the search ends too early, or |R|
//       may be a bit more than one.
// Hint: Keep all numbers in double. Sixty halvings cost nothing, and |R| <= 1 needs no tolerance.
namespace single_precision {
double longest_kutta_step(double omega, double zeta) {
    return static_cast<float>(longest_along(fast_of(zeta)) / omega);
}
}  // namespace single_precision

// Says: This is where the region ends on the real axis, for every damper. A door that swings leaves it elsewhere, and a
//       strong damper has a faster decay than omega.
// Hint: Put both lambda into z = h lambda, with their zeta, before you ask for |R|.
namespace real_limit_for_all {
double longest_kutta_step(double omega, double zeta) {
    return 2.5127453266183286 / omega;
}
}  // namespace real_limit_for_all

// Says: This is the limit of semi-implicit Euler with a damper.
// Hint: Each method has a region of its own. This one's R has a third power of z.
namespace semi_implicit_euler {
double longest_kutta_step(double omega, double zeta) {
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / omega;
}
}  // namespace semi_implicit_euler

// Says: The third power in R has the factor 1/12. Is the third look taken at y1 + h k2, or is there a half too many
//       before z³?
// Hint: k3 has 2 k2 - k1 in it. Which factor has z³ there, before the sixth?
namespace half_the_cube {
double longest_kutta_step(double omega, double zeta) {
    return longest_along(fast_of(zeta), 6, 1.0 / 12) / omega;
}
}  // namespace half_the_cube

// Says: The root of zeta² - 1 is missing: lambda has zeta² - 1 itself in it.
// Hint: Solve lambda² + 2 zeta omega lambda + omega² = 0 once more, to its end.
namespace no_root {
double longest_kutta_step(double omega, double zeta) {
    const double square = zeta * zeta - 1;
    const Complex fast = square < 0 ? Complex(-zeta, -square) : Complex(-zeta - square);
    return longest_along(fast / std::abs(fast)) / std::abs(fast) / omega;
}
}  // namespace no_root

// Says: Every door with a damper is taken for a pure decay at the rate zeta omega. Weak dampers let it swing, and
//       beyond critical damping the fast rate is larger.
// Hint: Below critical damping lambda has an imaginary part. Above, the root adds to zeta.
namespace decay_alone {
double longest_kutta_step(double omega, double zeta) {
    if (zeta == 0) return std::sqrt(3.0) / omega;
    return 2.5127453266183286 / (zeta * omega);
}
}  // namespace decay_alone

// Says: Every door gets the first step of the example.
// Hint: Begin with R(z), then find the z of the door.
namespace example {
double longest_kutta_step(double omega, double zeta) {
    return 0.24393;
}
}  // namespace example

// Says: The limit is that of another method, as if k3 lacked its minus k1: R then has 2/3 z² in it, where z²/2
//       belongs.
// Hint: k3 is the rate after a whole step of 2 k2 - k1. Put z and z + z²/2 in for k1 and k2.
namespace first_look_forgotten {

double longest_kutta_step(double omega, double zeta) {
    const auto stable = [&](double wh) {
        const Complex k1 = wh * fast_of(zeta), k2 = k1 * (1.0 + k1 / 2.0), k3 = k1 * (1.0 + 2.0 * k2);
        return std::abs(1.0 + (k1 + 4.0 * k2 + k3) / 6.0) <= 1;
    };
    return longest(stable) / omega;
}

}  // namespace first_look_forgotten
