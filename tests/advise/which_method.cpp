// I13: the course's one answer to "which method?", and the way down to it.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/stability.hpp>
#include "which_method.hpp"

using namespace timestep;

TEST_CASE("every answer has a name of its own and names a method of the library", "[library][I13]") {
    std::set<std::string> methods{"", semi_implicit_euler_new_damping.name, ball_and_remainder_2.name,
                                  ball_and_remainder_4.name};
    const auto known = [&](const auto& method) { methods.insert(method.name); };
    for_each_method(known), for_each_verlet_method(known), for_each_gyroscopic(known);
    known(half_step_jacobian), known(calm_half_step);
    std::set<std::string> names;
    for (const Choice& each : choices()) {
        CAPTURE(each.name, each.method);
        CHECK(names.insert(each.name).second);
        CHECK(methods.contains(each.method));
    }
    CHECK(choice("callback_light").have.find("at most 0.0049 kg m²") != std::string::npos);
    CHECK_THROWS_AS(choice("nothing"), std::invalid_argument);
}

TEST_CASE("a question about a spring leads to its answer", "[library][I13]") {
    const std::vector<std::pair<SpringQuestion, std::string>> questions{
        {{.turn = 1}, "swing"},
        {{.turn = 2}, "swing"},               // in two substeps
        {{.turn = 0.1, .zeta = 3}, "swing"},  // a hard damper is a division
        {{.turn = 0.1, .precise = true}, "smooth"},
        {{.turn = 5, .zeta = 2, .precise = true}, "smooth_pull"},
        {{.turn = 0.1, .even = false}, "uneven"},
        {{.turn = 0.1, .even = false, .only_pulls = true}, "tether"},
        {{.turn = 0.1, .precise = true, .only_pulls = true}, "smooth"},
        {{.turn = 2.01}, "unseen"},
        {{.turn = 2, .is_net = true}, "swing"},
        {{.turn = 2.01, .zeta = 3, .is_net = true}, "net"},
        {{.turn = 2, .is_joint = true}, "swing"},
        {{.turn = 2.01, .keeps_size = true, .is_joint = true}, "joint"},
        {{.turn = 5, .keeps_size = true}, "keeps_size"},
        {{.turn = 5, .zeta = 1}, "pull"},
        {{.turn = 100, .zeta = 0.05, .keeps_size = true}, "pull"}};  // its damper ends it
    for (const auto& [question, answer] : questions) {
        CAPTURE(question.turn, question.zeta);
        CHECK(choose(question).name == answer);
    }
}

TEST_CASE("BDF2 is right to a percent on a spring that is let go, in the substeps that the answer names",
          "[library][I13]") {
    const auto worst = [](double zeta, double wh) {
        const DampedSpring<double> spring(1, zeta);
        const State<double> start{0, 1, 0};
        Bdf2Motion<State<double>> motion(start);
        double error = 0;
        for (int n = 1; n <= 400; ++n) {
            motion.step(spring, wh);
            error = std::max(error, std::fabs(motion.now().x - spring.exact(start, n * wh).x));
        }
        return error;
    };
    for (double zeta = stiff_decay; zeta < 1e4; zeta *= 1.1) {
        CAPTURE(zeta);
        for (double share = 1; share > 0.01; share *= 0.7) CHECK(worst(zeta, share * fine_pull * zeta) < 0.01);
    }
    CHECK(worst(stiff_decay, 2 * fine_pull * stiff_decay) > 0.01);
}

// Where ωh and ζωh are 1 at most, h|λ| is 2 at most: of real and of complex rates. Steps of any length share their
// eigenvectors, so a mixture of such steps shrinks, too.
TEST_CASE("Runge-Kutta 4 shrinks every damped spring within the limits that the answer names, and not beyond",
          "[library][I13]") {
    const auto factor = [](double wh, double zeta) {
        return spectral_radius(step_matrix(runge_kutta_4, DampedSpring<double>(1, zeta), wh));
    };
    for (int i = 0; i <= 100; ++i)
        for (int k = 1; k <= 100; ++k) {
            const double zeta = 0.1 * i, wh = 0.01 * k * std::min(alive_turn, zeta > 0 ? alive_turn / zeta : 1);
            CAPTURE(zeta, wh);
            CHECK(factor(wh, zeta) < 1);
        }
    CHECK(factor(1, 2) > 3);
    CHECK(factor(1, 1.58) > 1);
}

// From a push and from a pull alike: of any start they are a sum.
TEST_CASE(
    "Runge-Kutta 4 is right to a percent over four periods up to the turn that the answer names, and not at twice that",
    "[library][I13]") {
    const auto worst = [](double turn, double zeta, double v) {
        const DampedSpring<double> spring(1, zeta);
        const double h = zeta > 1 ? turn / zeta : turn;
        const State<double> start{0, 1 - std::fabs(v), v};
        State<double> s = start;
        double off = 0;
        for (int n = 1; n * h < 8 * std::numbers::pi; ++n) {
            s = runge_kutta_4.step(spring, s, h);
            off = std::max(off, std::fabs(s.x - spring.exact(start, n * h).x));
        }
        return off;
    };
    for (int i = 0; i <= int(10 * stiff_decay); ++i)
        for (const double v : {0.0, 1.0, -1.0}) {
            CAPTURE(i, v);
            CHECK(worst(fine_turn, 0.1 * i, v) < 0.01);
        }
    CHECK(worst(2 * fine_turn, 0, 0) > 0.01);
}

// The energy of a tether that pushes has a hill at its anchor: nothing forbids implicit Euler to gain there.
TEST_CASE("implicit Euler may gain on a tether that pushes", "[library][I13]") {
    const Tether tether(std::sqrt(31.0), 1.0);
    const State<Eigen::Vector2d> start{0, {0.53, 0}, {-3.83, 2.04}};
    const auto end = implicit_euler.step(tether, start, 0.112);
    CHECK(tether.energy(end) > 1.2 * tether.energy(start));
}

TEST_CASE("a question about a body leads to its answer, in whatever order its moments stand", "[library][I13]") {
    const double light = 0.0049, heavy = 0.005;  // Bullet's guard is between the two
    const std::vector<std::pair<BodyQuestion, std::string>> questions{
        {{.moments = {2, 2, 2}, .turn = 9}, "ball"},
        {{.moments = {2, 2, 2}, .turn = 1, .callback = true}, "ball"},
        {{.moments = {1, 0.18, 1.02}, .turn = 0.2}, "free"},  // its true moments are nearer
        {{.moments = {1, 0.18, 1}, .turn = 9}, "symmetric_free"},
        {{.moments = {1.9, 1, 1}, .turn = 1, .contacts = true}, "symmetric"},
        {{.moments = {1.9, 1, 1.02}, .turn = 1, .contacts = true}, "contacts"},  // it tumbles
        {{.moments = {1.9, 1, 1}, .turn = 1, .contacts = true, .callback = true}, "callback_symmetric"},
        {{.moments = {1.9, 1, 1.02}, .turn = 1, .contacts = true, .callback = true}, "callback"},
        {{.moments = {3, 1, 2}, .turn = 1, .callback = true}, "callback_free"},
        {{.moments = {3, 1, 2}, .turn = 0.25}, "free"},
        {{.moments = {3, 1, 2}, .turn = 0.26}, "free_fast"},
        {{.moments = {3, 1, 2}, .turn = 0.1, .even = false}, "free_uneven"},
        {{.moments = {3, 1, 2}, .turn = 0.6, .count = 999}, "free_fast"},
        {{.moments = {3, 1, 2}, .turn = 0.5, .count = 10'000}, "many"},
        {{.moments = {3, 1, 2}, .turn = 0.6, .count = 10'000}, "many_fast"},
        {{.moments = {3, 1, 2}, .turn = 9, .count = 10'000, .even = false}, "many_uneven"},
        {{.moments = {1, 0.2, 1.04}, .turn = 0.6, .count = 10'000}, "many_uneven"},  // by passive its spin would fade
        {{.moments = {1, 0.2, 1.06}, .turn = 0.6, .count = 10'000}, "many_fast"},
        {{.moments = {light, light, 0.99 * light}, .turn = 1, .contacts = true, .callback = true}, "callback_light"},
        {{.moments = {heavy, heavy, 0.99 * heavy}, .turn = 1, .contacts = true, .callback = true},
         "callback_symmetric"}};
    for (const auto& [question, answer] : questions) {
        CAPTURE(question.moments, question.turn, question.count);
        CHECK(choose(question).name == answer);
    }
}
