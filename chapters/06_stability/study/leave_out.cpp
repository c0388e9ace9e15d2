// What does a feature cost that a body does not use? Crowds of balls, capsules and boxes, sorted by
// kind and mixed.

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "mixed.hpp"
#include "sections.hpp"
#include "timing.hpp"

using namespace timestep;

namespace {

constexpr int bodies = 1024;  // they fit the cache nearest but one to the processor
constexpr int rounds = 151;

/// [scene]
const BodyScene debris{Weight(9.81), Gyroscopic(passive_gyroscopic)};
/// [scene]
using Debris = std::remove_const_t<decltype(debris)>;

// The kinds of a crowd's bodies: all of one, or a third each, shuffled.
enum Kind { ball, capsule, box };
std::vector<Kind> kinds(int crowd) {
    std::vector<Kind> all(bodies);
    for (int i = 0; i < bodies; ++i) all[i] = Kind(crowd < 3 ? crowd : i % 3);
    std::mt19937 random(1);
    for (int i = bodies - 1; i > 0; --i) std::swap(all[i], all[random() % (i + 1)]);
    return all;
}

template <class Crowd>
Crowd filled(int which) {
    Crowd crowd;
    int i = 0;
    for (const Kind kind : kinds(which)) {
        if (kind == ball) mixed::add_ball(crowd, i);
        if (kind == capsule) mixed::add_capsule(crowd, i);
        if (kind == box) mixed::add_box(crowd, i);
        ++i;
    }
    return crowd;
}

// ns a body for one step of them all.
template <class Crowd>
double time_of(Crowd& crowd) {
    const double seconds = lab::seconds_of([&] {
        for (int n = 0; n < 2; ++n) crowd.step(debris, 0.001);
    });
    return 1e9 * seconds / (2.0 * bodies);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Four ways to keep the same crowd, in turns, so that all meet the same machine.
struct Measured {
    double sorted, variant, virtually, alike;  // ns a body, the median of all rounds
};
Measured measure(int which) {
    auto sorted = filled<mixed::Sorted>(which);
    auto variants = filled<mixed::Variants>(which);
    auto virtuals = filled<mixed::Virtuals<Debris>>(which);
    auto alike = filled<mixed::Alike>(which);
    std::vector<double> s, v, w, a;
    for (int i = 0; i < rounds; ++i) {
        s.push_back(time_of(sorted)), v.push_back(time_of(variants));
        w.push_back(time_of(virtuals)), a.push_back(time_of(alike));
    }
    return {median(s), median(v), median(w), median(a)};
}

// Steps each body by itself, and compares with the group: the same operations in the same order
// must give the same bits.
template <class KindOfBody>
bool same_bits(const mixed::Sorted& start, const mixed::Sorted& end, int steps) {
    const auto &before = start.of<KindOfBody>(), &after = end.of<KindOfBody>();
    for (std::size_t i = 0; i < before.size(); ++i) {
        BodyState<double> m = before[i].state;
        for (int n = 0; n < steps; ++n) debris.step(before[i].body, m, 0.001);
        const BodyState<double>& other = after[i].state;
        if (m.x != other.x || m.v != other.v || m.turning.omega != other.turning.omega ||
            m.turning.q.coeffs() != other.turning.q.coeffs())
            return false;
    }
    return true;
}

}  // namespace

void leave_out(const Settings&, lab::Findings& out) {
    out.section("Bodies sorted by need");
    const char* names[] = {"balls", "capsules", "boxes", "a third each"};
    const char* keys[] = {"balls", "capsules", "boxes", "mixture"};
    auto& table =
        out.table("leave_out.tsv", {"crowd", "sorted by kind", "std::variant", "virtual", "every body a box"});
    std::printf("  %-14s %10s %10s %10s %10s\n", "ns a body, step", "sorted", "variant", "virtual", "all boxes");
    for (int which = 0; which < 4; ++which) {
        const Measured m = measure(which);
        const auto rounded = [](double value) {
            char text[24];
            std::snprintf(text, sizeof text, "%.1f", value);
            return std::string(text);
        };
        table.row(
            {std::string(names[which]), rounded(m.sorted), rounded(m.variant), rounded(m.virtually), rounded(m.alike)});
        std::printf("  %-14s %10.1f %10.1f %10.1f %10.1f\n", names[which], m.sorted, m.variant, m.virtually, m.alike);
        const std::string key = keys[which];
        out.number(key + "_alike_ratio", m.alike / m.sorted, "", "time of boxes only over sorted, " + key, 1);
        const double off = std::max(std::fabs(m.variant / m.sorted - 1), std::fabs(m.virtually / m.sorted - 1));
        out.number(key + "_within", std::ceil(100 * off), "%", "how far both are from the sorted bodies' time, " + key);
    }
    out.number("crowd", bodies, "", "bodies in a crowd");

    const auto start = filled<mixed::Sorted>(3);
    auto end = start;
    for (int n = 0; n < 100; ++n) end.step(debris, 0.001);
    out.check("sorted_same_bits",
              same_bits<mixed::Ball>(start, end, 100) && same_bits<mixed::Capsule>(start, end, 100) &&
                  same_bits<mixed::Box>(start, end, 100),
              "a body among sorted bodies moves as it does alone, to the last bit");
}
