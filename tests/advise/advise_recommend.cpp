// I13: the one method that the advice on a spring recommends, against what it does.
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include <Eigen/Dense>

#include "advise.hpp"
#include "method_on_spring.hpp"
#include <timestep/run.hpp>

#include "random_springs.hpp"

using namespace timestep;
using springs::Random;

namespace {

Recommendation answer(const SpringScene& scene, double h, const Goal& goal = {}) {
    return recommend(scene, h, goal, advise(scene, h, goal.accuracy));
}
Recommendation in_frames(double omega, double zeta, double shortest, double longest, const Goal& goal = {}) {
    SpringScene scene(DampedSpring<double>(omega, zeta));
    scene.shortest_frame = shortest, scene.longest_frame = longest;
    return answer(scene, longest, goal);
}

// A point on a tether in the plane, ω = 1 where it is taut, no damper.
struct Tether {
    double length, weight;
    Eigen::Vector2d acceleration(const Eigen::Vector2d& x, const Eigen::Vector2d&) const {
        const double r = x.norm();
        Eigen::Vector2d a(0, -weight);
        if (r > length) a -= (r - length) / r * x;
        return a;
    }
    double energy(const State<Eigen::Vector2d>& s) const {  // zero where it hangs at rest
        const double stretch = std::max(0.0, s.x.norm() - length);
        return (s.v.squaredNorm() + stretch * stretch + weight * weight) / 2 + weight * (s.x.y() + length);
    }
};

// How many of 400 throws, half of them without weight, get above 1.25 times the energy that they began with.
int gaining_throws(double s, long steps) {
    Random random(7);
    int gaining = 0;
    for (int i = 0; i < 400; ++i) {
        const double length = random.in_log(0.1, 30), weight = i % 2 ? random.in_log(0.01, 1) : 0;
        const Tether tether{length, weight};
        const Eigen::Vector2d x = length * std::sqrt(random.even(0, 1)) * random.way();
        const double speed = i % 2 ? random.even(0, 1) * std::sqrt(weight * length) : 1;
        const State<Eigen::Vector2d> start{0, x, speed * random.way()};
        double most = 0;
        run(semi_implicit_euler, tether, start, s, steps,
            [&](const auto& now) { most = std::max(most, tether.energy(now)); });
        gaining += !(most <= 1.25 * tether.energy(start));
    }
    return gaining;
}

}  // namespace

TEST_CASE("of four hundred throws of a hundred thousand steps no tether gains a quarter",
          "[library][I13][long][proof]") {
    CHECK(gaining_throws(tether_turn, 100'000) == 0);
    CHECK(gaining_throws(2 * tether_turn, 100'000) > 40);
}

TEST_CASE("a tether gets implicit Euler, and short substeps where it must bounce on", "[library][I13]") {
    for (const double turn : {0.05, 0.5, 1.0, 30.0}) {
        SpringScene scene(DampedSpring<double>(1, 0));
        scene.only_pulls = true;
        CHECK(answer(scene, turn).method == "implicit Euler");
        const Recommendation bounces = answer(scene, turn, {.keeps_size = true});
        CHECK(bounces.method == "semi-implicit Euler, new damping");
        CHECK(turn / double(bounces.substeps) <= tether_turn);
        const Recommendation near = answer(scene, turn, {.precise = true});
        CHECK(near.position_error <= 0.01);
        CHECK(turn / double(near.substeps) <= tether_turn);
        scene.shortest_frame = turn / 2, scene.longest_frame = turn;
        CHECK(answer(scene, turn).method == "implicit Euler");
        CHECK(answer(scene, turn, {.keeps_size = true}).method == "implicit Euler");
    }
}

// The answer's own substeps, with frames at random and in a pattern.
TEST_CASE("the method recommended for uneven frames is stable, and as accurate as asked", "[library][I13]") {
    Random random(27);
    int euler = 0;
    for (int i = 0; i < 25; ++i) {
        const double zeta = random.below(3) ? random.in_log(0.01, 10) : 0, longest = random.in_log(0.05, 100);
        const double shortest = longest * random.even(0.3, 0.95);
        const Goal goal{random.below(2) == 1, random.below(2) == 1};
        const Recommendation made = in_frames(1, zeta, shortest, longest, goal);
        CAPTURE(zeta, shortest, longest, goal.precise, goal.keeps_size, made.method, made.substeps);
        REQUIRE(made.substeps > 0);
        if (goal.precise) CHECK(made.position_error <= 0.01);
        const auto look = [&](const auto& method) {
            if (made.method != method.name) return;
            if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(method)>, Bdf2>) {
                const DampedSpring<double> spring(1, zeta);
                State<double> now{0, 1, 0};
                double most = 0, first_swing = 0;
                for (int n = 0; n < 900; ++n) {
                    const double frame = n % 300 < 150 ? random.even(shortest, longest) : n % 3 ? longest : shortest;
                    for (long k = 0; k < made.substeps; ++k) {
                        now = method.step(spring, now, frame / double(made.substeps));
                        most = std::max(most, std::abs(now.x));
                        if (now.t < 6.2)
                            first_swing =
                                std::max(first_swing, std::abs(now.x - spring.exact(State<double>{0, 1, 0}, now.t).x));
                    }
                }
                CHECK(most < 1.1);
                if (goal.precise) CHECK(first_swing <= 0.01);
            }
        };
        for_each_method(look);
        look(semi_implicit_euler_new_damping);
        euler += made.method == semi_implicit_euler_new_damping.name;
    }
    CHECK(euler > 0);
}

TEST_CASE("asked for an accuracy the answer reaches it, and no method does at fewer whole substeps' cost",
          "[library][I13]") {
    Random random(28);
    for (int i = 0; i < 40; ++i) {
        const DampedSpring<double> spring(1, random.below(4) ? random.in_log(0.01, 30) : 0);
        const double h = random.in_log(0.05, 1e4);
        const auto all = advise(spring, h);
        const Recommendation made = recommend(spring, h, {.precise = true}, all);
        CAPTURE(spring.zeta, h, made.method, made.substeps);
        REQUIRE(made.substeps > 0);
        CHECK(made.position_error <= 0.01);
        double cost = 0, least = INFINITY;
        for (const Advice& each : all) {
            if (each.method == made.method) cost = each.cost * double(made.substeps);
            if (best_step(each, h) > 0)
                least = std::min(least, each.cost * std::ceil(h / best_step(each, h) * (1 - 1e-12)));
        }
        CHECK(cost <= least * (1 + 1e-9));
    }
}

// ω = 7 rad/s, ζ = 0.48: one ellipse holds every step of semi-implicit Euler.
TEST_CASE("in uneven frames semi-implicit Euler is recommended where the proof holds and it costs less",
          "[library][I13]") {
    const DampedSpring<double> wheel = DampedSpring<double>::from_stiffness(58860, 8000, 1200);
    const Recommendation made = in_frames(wheel.omega, wheel.zeta, 0.0069, 0.033);
    CHECK(made.method == "semi-implicit Euler, new damping");
    CHECK(made.substeps == 1);
    // One ellipse says nothing of the slower oscillations of a chain.
    SpringScene chain = scene_of(springs_between(1200, 2), 58860, 8000);
    chain.shortest_frame = 0.0069, chain.longest_frame = 0.033;
    CHECK(answer(chain, 0.033).method == "Runge-Kutta 4");
}

TEST_CASE("several dampers are swept there and back, and a stiff joint gets implicit Euler", "[library][I13]") {
    SpringScene chain = scene_of(springs_between(2, 2), 400, 1000);
    chain.is_net = true;
    const Recommendation made = answer(chain, 1.0 / 60);
    CHECK(made.swept);
    CHECK(chain.fastest.omega / 60 / double(made.substeps) < 2);
    for (const double damping : {0.0, 10.0, 1e4}) {
        SpringScene joint = scene_of(hinge(3, 1 / 3.0, 3, 1 / 3.0), 1e6, damping);
        joint.is_joint = true;
        CHECK(answer(joint, 1.0 / 60).method == "implicit Euler");
        CHECK(answer(joint, 1.0 / 60).choice->name == "joint");
    }
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
