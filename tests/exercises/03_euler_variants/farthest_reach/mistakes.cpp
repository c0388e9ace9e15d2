#include "exercise.hpp"

// Says: This is the amplitude of the true motion. The simulated one does not keep its energy.
// Hint: Which energy does semi-implicit Euler keep? It has one term more.
namespace true_motion {

double farthest_reach(double x, double v, double omega, double h) {
    return std::sqrt(x * x + v * v / (omega * omega));
}

}  // namespace true_motion

// Says: This is where the ellipse crosses v = 0. But it leans over, and reaches farther with some velocity
//       left.
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
