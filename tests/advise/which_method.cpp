// I13: the course's one answer to "which method?", and the way down to it.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
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

TEST_CASE("every answer has a name of its own, and takes a method that there is", "[library][I13]") {
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
        CHECK(choice(each.name).take == each.take);
    }
    for (const char* touches : {"contacts", "symmetric"})
        CHECK(choice(touches).take.find("before contacts and joints, ") != std::string::npos);
    CHECK_THROWS_AS(choice("nothing"), std::invalid_argument);
    CHECK(choice("many").take.find("faster ones") == std::string::npos);  // those have lines of their own
    CHECK(choice("unseen").why.find("must be seen, semi-implicit Euler in substeps of ωh at most 1") !=
          std::string::npos);
}

TEST_CASE("a spring is led to its answer", "[library][I13]") {
    CHECK(choose(SpringQuestion{.turn = 1}).name == "swing");
    CHECK(choose(SpringQuestion{.turn = 2}).name == "swing");               // in two substeps
    CHECK(choose(SpringQuestion{.turn = 0.1, .zeta = 3}).name == "swing");  // a hard damper is a division
    CHECK(choose(SpringQuestion{.turn = 0.1, .precise = true}).name == "smooth");
    CHECK(choose(SpringQuestion{.turn = 5, .zeta = 2, .precise = true}).name == "smooth_pull");
    CHECK(choose(SpringQuestion{.turn = 0.1, .even = false}).name == "uneven");
    CHECK(choose(SpringQuestion{.turn = 0.1, .even = false, .only_pulls = true}).name == "tether");
    CHECK(choose(SpringQuestion{.turn = 0.1, .keeps_size = true, .only_pulls = true}).name == "tether");
    CHECK(choose(SpringQuestion{.turn = 0.1, .precise = true, .only_pulls = true}).name == "smooth");
    CHECK(choose(SpringQuestion{.turn = 2.01}).name == "unseen");
    CHECK(choose(SpringQuestion{.turn = 2, .is_net = true}).name == "swing");
    CHECK(choose(SpringQuestion{.turn = 2.01, .zeta = 3, .is_net = true}).name == "net");
    CHECK(choose(SpringQuestion{.turn = 2, .is_joint = true}).name == "swing");
    CHECK(choose(SpringQuestion{.turn = 2.01, .keeps_size = true, .is_joint = true}).name == "joint");
    CHECK(choose(SpringQuestion{.turn = 5, .keeps_size = true}).name == "keeps_size");
    CHECK(choose(SpringQuestion{.turn = 5, .zeta = 1}).name == "pull");
    CHECK(choose(SpringQuestion{.turn = 100, .zeta = 0.05, .keeps_size = true}).name == "pull");  // its damper ends it
}

// Each takes out all of the old velocity: three of them leave minus twice that.
TEST_CASE("hard dampers at one mass hold added up or one after the other, and blow up each for itself",
          "[library][I13]") {
    const double m = 1, c = 1e4, h = 1.0 / 60;
    double together = 1, in_turn = 1, each_alone = 1;
    for (int n = 0; n < 20; ++n) {
        together /= 1 + 3 * c * h / m;
        for (int k = 0; k < 3; ++k) in_turn /= 1 + c * h / m;
        each_alone -= 3 * c * h / m * each_alone / (1 + c * h / m);
    }
    CHECK(std::fabs(together) < 1e-6);
    CHECK(std::fabs(in_turn) < 1e-6);
    CHECK(std::fabs(each_alone) > 1e5);
}

// A kilogram on a spring along x with ωh = 1 at 60 Hz, and two hard dampers at ±20° to it.
TEST_CASE("hard dampers in different directions blow up when swept one way, but not there and back or solved at once",
          "[library][I13]") {
    const double h = 1.0 / 60, omega = 60, c = 200;
    const auto energy_after_a_second = [&](int way) {
        Eigen::Vector2d x(1, 0), v(0, 0);
        const Eigen::Vector2d n[] = {{std::cos(0.349066), std::sin(0.349066)},
                                     {std::cos(0.349066), -std::sin(0.349066)}};
        const auto damp = [&](const Eigen::Vector2d& along, double hc) { v -= hc / (1 + hc) * along.dot(v) * along; };
        for (int i = 0; i < 60; ++i) {
            v.x() -= h * omega * omega * x.x();
            if (way == 0) damp(n[0], h * c), damp(n[1], h * c);
            if (way == 1) damp(n[0], h * c / 2), damp(n[1], h * c / 2), damp(n[1], h * c / 2), damp(n[0], h * c / 2);
            if (way == 2) {
                Eigen::Matrix2d D = Eigen::Matrix2d::Identity();
                for (const auto& along : n) D += h * c * along * along.transpose();
                v = D.inverse() * v;
            }
            x += h * v;
        }
        return (v.squaredNorm() + omega * omega * x.x() * x.x()) / (omega * omega);
    };
    CHECK(energy_after_a_second(0) > 50);
    CHECK(energy_after_a_second(1) < 1);
    CHECK(energy_after_a_second(2) < 1);
    CHECK(choice("swing").why.find("sweep over them there and back") != std::string::npos);
    CHECK(choice("swing").why.find("no damper makes it blow up") == std::string::npos);
    CHECK(choice("swing").why.find("The energy of a linear spring does not drift; under other forces it may") !=
          std::string::npos);
    CHECK(choice("net").take.find("swept there and back") != std::string::npos);
}

TEST_CASE("BDF2 follows a hard damped spring that is let go, and misses the first step after a kick",
          "[library][I13]") {
    const double h = 0.2;
    const DampedSpring<double> spring(10, 20);
    const auto errors = [&](const State<double>& start) {  // of the positions, over what the spring does at most
        double largest = 0;
        for (int n = 0; n <= 5000; ++n) largest = std::max(largest, std::fabs(spring.exact(start, 0.0002 * n).x));
        std::vector<double> all;
        Bdf2Motion<State<double>> motion(start);
        for (int n = 1; n <= 20; ++n) {
            motion.step(spring, h);
            all.push_back(std::fabs(motion.now().x - spring.exact(start, n * h).x) / largest);
        }
        return all;
    };
    const std::vector<double> let_go = errors({0, 1, 0}), kicked = errors({0, 0, 1});
    CHECK(*std::max_element(let_go.begin(), let_go.end()) < 0.01);
    CHECK(kicked[0] > 0.9);
    CHECK(*std::max_element(kicked.begin() + 2, kicked.end()) < 0.01);
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
    CHECK(choice("smooth_pull").take.find("ωh at most 0.2 ζ") != std::string::npos);
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

TEST_CASE("a body is led to its answer, in whatever order its moments stand", "[library][I13]") {
    CHECK(choose(BodyQuestion{.moments = {2, 2, 2}, .turn = 9}).name == "ball");
    CHECK(choose(BodyQuestion{.moments = {1, 0.18, 1.02}, .turn = 0.2}).name == "free");  // its true moments are nearer
    CHECK(choose(BodyQuestion{.moments = {1, 0.18, 1}, .turn = 9}).name == "symmetric_free");
    CHECK(choose(BodyQuestion{.moments = {1.9, 1, 1}, .turn = 1, .contacts = true}).name == "symmetric");
    CHECK(choose(BodyQuestion{.moments = {1.9, 1, 1.02}, .turn = 1, .contacts = true}).name ==
          "contacts");  // it tumbles
    CHECK(choose(BodyQuestion{.moments = {1.9, 1, 1}, .turn = 1, .contacts = true, .callback = true}).name ==
          "callback_symmetric");
    CHECK(choose(BodyQuestion{.moments = {1.9, 1, 1.02}, .turn = 1, .contacts = true, .callback = true}).name ==
          "callback");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 1, .callback = true}).name == "callback_free");
    CHECK(choose(BodyQuestion{.moments = {2, 2, 2}, .turn = 1, .callback = true}).name == "ball");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.1, .contacts = true}).name == "contacts");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.25}).name == "free");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.26}).name == "free_fast");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.1, .even = false}).name == "free_uneven");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.5, .count = 10'000}).name == "many");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.5, .count = 10'000, .even = false}).name ==
          "many_uneven");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 9, .count = 10'000, .even = false}).name == "many_uneven");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.5, .count = 999, .even = false}).name == "free_uneven");
    CHECK(choose(BodyQuestion{.moments = {1, 1, 0.2}, .turn = 9, .count = 10'000, .even = false}).name ==
          "symmetric_free");
    // With passive their spins about the length would fade.
    CHECK(choose(BodyQuestion{.moments = {1, 0.2, 1.04}, .turn = 0.6, .count = 10'000}).name == "many_uneven");
    CHECK(choose(BodyQuestion{.moments = {1, 0.2, 1.06}, .turn = 0.6, .count = 10'000}).name == "many_fast");
    CHECK(choose(BodyQuestion{.moments = {1, 0.2, 1.04}, .turn = 0.5, .count = 10'000}).name == "many");
    // Bullet's guard, of (kg m²)³.
    for (const double size : {3.9e-7, 0.0049}) {
        CHECK(choose(BodyQuestion{.moments = {size, size, size}, .turn = 1, .contacts = true, .callback = true}).name ==
              "ball");
        CHECK(choose(BodyQuestion{.moments = {size, size, 0.99 * size}, .turn = 1, .contacts = true, .callback = true})
                  .name == "callback_light");
        CHECK(choose(BodyQuestion{.moments = {size, size, 0.99 * size}, .turn = 1, .contacts = true}).name ==
              "symmetric");
    }
    CHECK(
        choose(BodyQuestion{.moments = {0.005, 0.005, 0.00499}, .turn = 1, .contacts = true, .callback = true}).name ==
        "callback_symmetric");
    CHECK(choice("callback_light").have.find("at most 0.0049 kg m²") != std::string::npos);
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.6, .count = 10'000}).name == "many_fast");
    CHECK(choose(BodyQuestion{.moments = {3, 1, 2}, .turn = 0.6, .count = 999}).name == "free_fast");
}
