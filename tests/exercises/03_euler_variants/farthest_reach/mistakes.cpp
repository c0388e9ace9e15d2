#include "exercise.hpp"

// Says: This is the amplitude of the true motion. The simulated one does not keep its energy.
// Hint: Which energy does semi-implicit Euler keep? It has one term more.
namespace true_motion {

double farthest_reach(double x, double v, double omega, double h) {
    return std::sqrt(x * x + v * v / (omega * omega));
}

}  // namespace true_motion

// Says: This is where the ellipse crosses v = 0. But it leans over, and reaches farther with some velocity left.
//       If you do divide by something, is there a 1 / 4? In C++ that is 0.
// Hint: The modified energy at the farthest point has a term with x v. Which v is that point's?
namespace at_rest {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy) / omega;
}

}  // namespace at_rest

// Says: The extra term of the energy has the wrong sign: this is the ellipse of the method that moves first
//       and pulls afterwards.
// Hint: Try one step by hand: the modified energy must be the same before and after.
namespace leans_the_other_way {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x + wh * omega * x * v;
    return std::sqrt(twice_energy / (1 - wh * wh / 4)) / omega;
}

}  // namespace leans_the_other_way

// Says: The extra term of the energy is twice too large.
// Hint: Twice the energy is v² + omega² x² and one more term. Mind which of them carry a factor 1/2.
namespace twice_the_extra_term {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - 2 * wh * omega * x * v;
    return std::sqrt(std::fabs(twice_energy) / (1 - wh * wh / 4)) / omega;
}

}  // namespace twice_the_extra_term

// Says: The divisor is 1 - omega² h², which is zero at omega h = 1 already.
// Hint: The run is stable up to omega h = 2. What must stand in its place, so that the reach is finite until
//       there?
namespace quarter_missing {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy / std::fabs(1 - wh * wh)) / omega;
}

}  // namespace quarter_missing

// Says: This is the square of the distance.
// Hint: Metres are asked, not square metres.
namespace square {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return twice_energy / (1 - wh * wh / 4) / (omega * omega);
}

}  // namespace square

// Says: This steps the run and takes its farthest position. A run may visit few points of its ellipse, and
//       none of them need be the farthest.
// Hint: You know what the run keeps, so you need no step at all.
namespace stepped {

double farthest_reach(double x, double v, double omega, double h) {
    double farthest = std::fabs(x);
    for (int i = 0; i < 1000; ++i) {
        v -= h * omega * omega * x;
        x += h * v;
        farthest = std::fmax(farthest, std::fabs(x));
    }
    return farthest;
}

}  // namespace stepped

// Says: The answer of the example comes back, whatever the state.
// Hint: Write down the modified energy at the state you are given, and the same energy at the farthest point.
namespace example {

double farthest_reach(double x, double v, double omega, double h) {
    return 1.1547;
}

}  // namespace example

// Says: Below the line stands 1 + omega² h² / 4: the sign is wrong, and the ellipse comes out narrower than
//       it is.
// Hint: At omega h = 2 the run is no longer stable, and the reach must grow without end. Which sign does
//       that?
namespace plus_below {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy / (1 + wh * wh / 4)) / omega;
}

}  // namespace plus_below

// Says: The velocity stands where v / omega belongs: metres per second are added to metres.
// Hint: Scale the velocity so that the true motion is a circle: that makes a length of it.
namespace velocity_for_a_length {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    return std::sqrt(std::fabs(x * x + v * v - wh * x * v) / (1 - wh * wh / 4));
}

}  // namespace velocity_for_a_length

// Says: The extra term of the energy has a factor 1/2 too much.
// Hint: In the energy itself the term with x v has a half, as the two squares have. In twice the energy
//       none of them has.
namespace half_the_extra_term {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v / 2;
    return std::sqrt(twice_energy / (1 - wh * wh / 4)) / omega;
}

}  // namespace half_the_extra_term

// Says: This is half of the long axis of the ellipse. It leans, so that its end is not over the farthest x.
// Hint: The ellipse is widest where its side is upright, not where its axis ends. For which v has the
//       quadratic equation one root only?
namespace long_axis {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy / (1 - wh / 2)) / omega;
}

}  // namespace long_axis

// Says: This is omega times the reach: a speed, in metres per second.
// Hint: The energy has the unit of a speed squared. What makes metres of its root?
namespace largest_speed {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy / (1 - wh * wh / 4));
}

}  // namespace largest_speed

// Says: The divisor is that of the leaning ellipse, but above it stands the energy of the true motion,
//       without the term with x v.
// Hint: The true energy changes from step to step, so that each state would get another answer. Which
//       energy stays?
namespace true_energy {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    return std::sqrt((x * x + v * v / (omega * omega)) / (1 - wh * wh / 4));
}

}  // namespace true_energy

// Says: The divisor is 1 - omega² h² / 2, which is zero long before omega h = 2.
// Hint: Put v = h omega² x / 2 into the energy: two terms of its kind come together. What is left of them?
namespace half_below {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy / std::fabs(1 - wh * wh / 2)) / omega;
}

}  // namespace half_below

// Says: The energy is multiplied by 1 - omega² h² / 4, where it has to be divided: the ellipse shrinks with
//       a longer step.
// Hint: 2E is omega² x² times that number, and x is what you look for. Solve for it.
namespace divisor_above {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    const double twice_energy = v * v + omega * omega * x * x - wh * omega * x * v;
    return std::sqrt(twice_energy * (1 - wh * wh / 4)) / omega;
}

}  // namespace divisor_above

// Says: The energy stands under the root, but its divisor does not.
// Hint: The square of the reach is a quotient. Take the root of all of it.
namespace divisor_without_root {

double farthest_reach(double x, double v, double omega, double h) {
    const double wh = omega * h;
    return std::sqrt(x * x - h * x * v + v * v / (omega * omega)) / (1 - wh * wh / 4);
}

}  // namespace divisor_without_root

// Says: This is the true amplitude divided by 1 - omega h / 2. That factor bounds the true energy of a ball that is let go at
//       rest. It does not give the reach of the ellipse.
// Hint: Do without the true energy: it changes from step to step. Which energy stays, and what is it at the farthest x?
namespace band_of_the_energy {

double farthest_reach(double x, double v, double omega, double h) {
    return std::sqrt(x * x + v * v / (omega * omega)) / (1 - omega * h / 2);
}

}  // namespace band_of_the_energy

// Says: The true energy is divided by 1 - omega h / 2. That is the most that a run makes of it when a ball is let go at rest. But
//       the states of a run differ in their true energy, so each of them gets another answer.
// Hint: Write down the modified energy of the given state, and the same energy where x is largest. Compare the two.
namespace root_of_the_band {

double farthest_reach(double x, double v, double omega, double h) {
    return std::sqrt((x * x + v * v / (omega * omega)) / (1 - omega * h / 2));
}

}  // namespace root_of_the_band
