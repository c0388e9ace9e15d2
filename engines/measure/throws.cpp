// Bodies thrown onto a plane: do they come to rest, and does one gain energy?

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <timestep/rigid/shapes.hpp>

#include "scenes.hpp"

namespace engines {

namespace {

constexpr double patience = 15;  // s
constexpr std::uint64_t seed = 22;

struct Thrown {
    const char* name;
    Shape shape;
};

std::vector<Thrown> shapes() {
    const auto long_one = timestep::capsule(1.0, 0.25, 0.8);
    return {{"capsule", {Shape::capsule, {0.25, 0.25, 0.4}, {long_one.across, long_one.across, long_one.along}, 1}},
            {"box", {Shape::box, {0.25, 0.5, 0.75}, timestep::box(1.0, 0.5, 1.0, 1.5).moments, 1}},
            {"plate", {Shape::box, {0.5, 0.75, 0.05}, timestep::box(1.0, 1.0, 1.5, 0.1).moments, 1}}};
}

// How far the lowest point is above the plane.
double height(const Shape& shape, const State& s) {
    const Vector down = (s.q.conjugate() * Vector::UnitZ()).cwiseAbs();
    if (shape.kind == Shape::capsule) return s.x.z() - shape.half.x() - down.z() * shape.half.z();
    return s.x.z() - down.dot(shape.half);
}

struct Outcome {
    int restless = 0;
    int gained = 0;                        // throws that at some time have 10 % more energy than first
    double median = 0, slowest = 0;        // s until a half, or nine in ten, lie still
    double most = 0;                       // the most energy that one ever has, over its first
    double deepest = 0, deep_at_rest = 0;  // m
};

Outcome thrown(const Engine& engine, const Shape& shape, double spin, int throws) {
    Outcome all;
    std::vector<double> times;
    Chance chance(seed);
    for (int n = 0; n < throws; ++n) {
        const auto world = engine.world({g, true, true});
        world->ground();
        State start;
        start.q = chance.orientation(), start.omega = spin * chance.direction(), start.x = Vector(0, 0, 1.5);
        world->add(shape, start);
        const auto energy = [&](const State& s) {
            return shape.mass * (s.v.squaredNorm() / 2 + g * (s.x.z() - shape.half.minCoeff())) + spin_energy(shape, s);
        };
        const double first = energy(start);
        double most = 0;
        double still = 0, t = 0;  // s
        State s = start;
        while (t < patience && still < 0.5) {
            world->step(step), t += step;
            s = world->state(0);
            most = std::max(most, energy(s) / first);
            all.deepest = std::max(all.deepest, -height(shape, s));
            const bool quiet = s.asleep || (s.omega.norm() < 0.2 && s.v.norm() < 0.1);
            still = quiet ? still + step : 0;
        }
        all.restless += still < 0.5;
        all.gained += most > 1.1;
        all.most = std::max(all.most, most);
        if (still >= 0.5) all.deep_at_rest = std::max(all.deep_at_rest, -height(shape, s));
        times.push_back(t);
    }
    std::sort(times.begin(), times.end());
    all.median = times[times.size() / 2], all.slowest = times[times.size() * 9 / 10];
    return all;
}

}  // namespace

void throw_bodies(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    const int throws = effort.quick ? 20 : 100;
    std::printf(
        "\nthrows: seed %llu, %d of each, friction %g, rolling resistance %g of capsules where the engine has it\n",
        static_cast<unsigned long long>(seed), throws, friction, rolling);
    for (const Thrown& body : shapes())
        for (const double spin : {5.0, 10.0, 20.0, 30.0}) {
            if (effort.quick && (spin == 5 || spin == 20)) continue;
            std::printf("\n%s thrown with %g rad/s\n%-48s %8s %8s %8s %8s %8s %8s %8s\n", body.name, spin, "",
                        "restless", "half, s", "9/10, s", "gained", "energy", "deep, m", "at rest");
            for (const Engine& engine : engines) {
                const Outcome o = thrown(engine, body.shape, spin, throws);
                std::printf("%s %8d %8.2f %8.2f %8d %8.3f %8.3f %8.3f\n", row_name(engine).c_str(), o.restless,
                            o.median, o.slowest, o.gained, o.most, o.deepest, o.deep_at_rest);
                char which[48];
                std::snprintf(which, sizeof which, "%s, %g rad/s", body.name, spin);
                numbers.add("throws", which, engine, "restless, of a hundred", 100.0 * o.restless / throws);
                if (2 * o.restless < throws) numbers.add("throws", which, engine, "half at rest, s", o.median);
                numbers.add("throws", which, engine, "nine in ten at rest, s", o.slowest);
                numbers.add("throws", which, engine, "gained a tenth, of a hundred", 100.0 * o.gained / throws);
                numbers.add("throws", which, engine, "most energy", o.most);
                numbers.add("throws", which, engine, "deepest, m", o.deepest);
                numbers.add("throws", which, engine, "deepest at rest, m", o.deep_at_rest);
            }
        }
}

}  // namespace engines
