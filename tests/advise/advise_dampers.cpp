// I13, N25: several dampers, one after another, against the advice on them.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <vector>

#include "method_on_spring.hpp"

#include "random_springs.hpp"

using namespace timestep;
using springs::Random;

namespace {

// The size of the largest eigenvalue: no less than it, and larger by less than a millionth.
double radius(Eigen::MatrixXd power) {
    double logarithm = 0, share = 1;
    for (int i = 0; i < 24; ++i, share /= 2) {
        const double size = power.norm();
        logarithm += share * std::log(size), power /= size, power = (power * power).eval();
    }
    return std::exp(logarithm);
}

// Each link has a damper of its own, from soft to very hard, and the true fastest oscillation turns by 1.99 in a step.
struct Swept {
    long asked = 0, grew = 0, grew_one_way = 0;
};
template <int N>
void sweep(Random& random, const Pull& pull, springs::Net<N> net, Swept& seen) {
    net.hold(1e-4 * pull.least);
    const double fastest = std::sqrt(radius(net.pull())), h = 1.99 / fastest;
    std::vector<double> dampers;
    for (std::size_t k = 0; k < net.links.size(); ++k)
        dampers.push_back(random.in_log(0.1, 1e4) / (fastest * pull.most));
    ++seen.asked;
    seen.grew += springs::grows(springs::swept_step(net, dampers, h, true));
    seen.grew_one_way += springs::grows(springs::swept_step(net, dampers, h, false));
    // What the advice says of steps that its bounds call stable.
    const SpringScene scene = scene_of(pull, 1, random.in_log(0.01, 1000));
    const Advice advice =
        at_step(on_spring(semi_implicit_euler_new_damping, scene.fastest.zeta, scene.least.zeta, scene.several), scene,
                1.99 / scene.fastest.omega, 0.01);
    CHECK(advice.verdict == Verdict::stable);
    CHECK(scene.fastest.omega >= (1 - 1e-3) * fastest);  // `hold` adds a little
}

}  // namespace

// The proof stands beside several_dampers().
TEST_CASE("dampers swept there and back let no scene grow below omega h = 2, and one way only they do",
          "[library][I13][N25]") {
    Random random(31);
    Swept seen;
    for (int i = 0; i < 50; ++i) {
        const double mass = random.in_log(0.1, 10), arm = random.in_log(0.1, 3),
                     inertia = mass * arm * arm * random.even(0.1, 1);
        sweep(random, springs_on_body(mass, 3, arm, inertia), springs::body(random, mass, 3, arm, inertia), seen);
        sweep(random, hinge(mass, lightness(mass, arm, inertia), 1, lightness(1, 1, 0.4)),
              springs::hinge(random, mass, arm, inertia, 1, 1, 0.4), seen);
        sweep(random, springs_between(mass, 2), springs::points<1, 6>(random, mass), seen);
        sweep(random, springs_between(mass, 4), springs::points<3, 3>(random, mass), seen);
    }
    CAPTURE(seen.asked, seen.grew_one_way);
    CHECK(seen.grew == 0);
    CHECK(seen.grew_one_way > 20);
}

// All dampers at once are known to hold farther; swept, nothing is proven there.
TEST_CASE("with several dampers new damping is called stable below omega h = 2 only", "[library][I13][N25]") {
    const auto verdict_at = [](const Pull& pull, double turn) {
        const SpringScene scene = scene_of(pull, 1, 2);
        const double h = turn / scene.fastest.omega;
        return advise(on_spring(semi_implicit_euler_new_damping, scene.fastest.zeta, scene.least.zeta, scene.several),
                      scene, h, 0.01)
            .verdict;
    };
    for (const Pull& pull : {springs_between(1, 2), springs_between(1, 4), hinge(1, 1, 1, 1), springs_on_body(1, 3)}) {
        CHECK(verdict_at(pull, 1.99) == Verdict::stable);
        CHECK(verdict_at(pull, 2.1) == Verdict::not_proven);
    }
    CHECK(verdict_at(springs_on_body(1, 1), 2.1) == Verdict::stable);  // one spring with its damper
}
