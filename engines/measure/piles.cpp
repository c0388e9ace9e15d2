// A stack of twenty boxes and a chain of ten capsules: what stood well must stand as well with another rule.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <timestep/rigid/shapes.hpp>

#include "scenes.hpp"

namespace engines {

namespace {

constexpr int boxes = 20, links = 10;
constexpr double watched = 10;  // s

// How a stack ends whose boxes are off by up to a millimetre each.
struct Stack {
    double asleep = watched;  // s
    double sunk = 0;          // the topmost, m
};
Stack stack(const Engine& engine, std::uint64_t seed) {
    const Shape shape{Shape::box, {0.5, 0.4, 0.25}, timestep::box(1.0, 1.0, 0.8, 0.5).moments, 1};
    const auto world = engine.world({g, true, true});
    world->ground();
    Chance chance(seed);
    for (int n = 0; n < boxes; ++n) {
        State s;
        s.x = 1e-3 * chance.direction();
        s.x.z() = (2 * n + 1) * shape.half.z();
        world->add(shape, s);
    }
    const double top = (2 * boxes - 1) * shape.half.z();
    Stack end;
    for (double t = 0; t < watched && end.asleep == watched; t += step) {
        world->step(step);
        bool all = true;
        for (int n = 0; n < boxes; ++n) all = all && world->state(n).asleep;
        if (all) end.asleep = t + step;
    }
    end.sunk = top - world->state(boxes - 1).x.z();
    return end;
}

// Of several stacks: how many stand, and of those the latest to sleep and the deepest.
void stacks(const Engine& engine, int number, Numbers& numbers) {
    int standing = 0;
    double asleep = 0, sunk = 0;
    for (int n = 1; n <= number; ++n) {
        const Stack end = stack(engine, std::uint64_t(n));
        if (end.sunk > 1) continue;
        ++standing;
        asleep = std::max(asleep, end.asleep), sunk = std::max(sunk, end.sunk);
    }
    std::printf("%s %5d of %-2d ", row_name(engine).c_str(), standing, number);
    numbers.add("stack", "twenty boxes", engine, "standing, of a hundred", 100.0 * standing / number);
    if (standing == 0) {
        std::printf("%10s %10s", "-", "-");
        return;
    }
    std::printf("%10.2f %10.3f", asleep, sunk);
    numbers.add("stack", "twenty boxes", engine, "asleep after, s", asleep);
    numbers.add("stack", "twenty boxes", engine, "top has sunk, m", sunk);
}

void chain(const Engine& engine, Numbers& numbers) {
    const auto solid = timestep::capsule(1.0, 0.1, 0.4);
    const Shape shape{Shape::capsule, {0.1, 0.1, 0.2}, {solid.across, solid.across, solid.along}, 1};
    const double half = 0.25;  // m from a link's middle to its joints
    const auto world = engine.world({g, false, false});
    const Vector end(0, 0, half);
    const Vector first(0, 0, 10);
    for (int n = 0; n < links; ++n) {
        State s;
        s.q = Quaternion(Eigen::AngleAxisd(std::acos(0.0), Vector::UnitY()));  // z along x
        s.x = first + Vector((2 * n + 1) * half, 0, 0);
        s.omega = Vector(20, 0, 0);  // about their length: twisting is free
        world->add(shape, s);
        world->pin(n, -end, n - 1, n == 0 ? first : end);
    }
    const auto energy = [&] {
        double sum = 0;
        for (int n = 0; n < links; ++n) {
            const State s = world->state(n);
            sum += spin_energy(shape, s) + shape.mass * (s.v.squaredNorm() / 2 + g * s.x.z());
        }
        return sum;
    };
    const double E = energy();
    double most = 1, gap = 0;
    for (double t = 0; t < watched; t += step) {
        world->step(step);
        most = std::max(most, energy() / E);
        Vector before = first;
        for (int n = 0; n < links; ++n) {
            const State s = world->state(n);
            gap = std::max(gap, (s.x - s.q * end - before).norm());
            before = s.x + s.q * end;
        }
    }
    std::printf(" %10.3f %10.3f %10.4f\n", most, energy() / E, gap);
    numbers.add("chain", "ten capsules", engine, "most energy", most);
    numbers.add("chain", "ten capsules", engine, "energy left", energy() / E);
    numbers.add("chain", "ten capsules", engine, "widest gap, m", gap);
}

}  // namespace

void pile_up(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    std::printf(
        "\nstacks of %d boxes, and a chain of %d capsules that swing and twist, %g s\n%-48s %11s %10s %10s %10s %10s "
        "%10s\n",
        boxes, links, watched, "", "standing", "asleep, s", "sunk, m", "energy <=", "energy", "gap, m");
    for (const Engine& engine : engines) stacks(engine, effort.quick ? 3 : 10, numbers), chain(engine, numbers);
}

}  // namespace engines
