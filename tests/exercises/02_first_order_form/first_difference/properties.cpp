#include "first_difference.hpp"

#include <bit>

#include "property.hpp"

EXERCISE(first_difference);

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

using Recording = std::vector<double>;

// At first a few small whole numbers, which can be looked through by hand.
Recording draw_recording(Draw& draw, int i) {
    Recording steps;
    const int count = i < 15 ? draw.integer(2, 4) : draw.integer(2, 60);
    for (int k = 0; k < count; ++k)
        steps.push_back(i < 15 ? draw.integer(1, 9) : draw.sign() * draw.log(1e-300, 1e300));
    return steps;
}

// The first step, the last, or any.
int draw_step(Draw& draw, int i, const Recording& steps) {
    const int last = static_cast<int>(steps.size()) - 1;
    return i % 3 == 0 ? 0 : i % 3 == 1 ? last : draw.integer(0, last);
}

// The neighbour, farther from zero: its last bit differs, or all bits behind a carry do.
double next_to(double x) { return std::nextafter(x, x < 0 ? -infinity : infinity); }

// Another sign of the same zero, or another number beside the same one.
int with(Recording steps, int k, double here, double there) {
    Recording other = steps;
    steps[static_cast<std::size_t>(k)] = here;
    other[static_cast<std::size_t>(k)] = there;
    return learner(steps, other);
}

}  // namespace

PROPERTY("equal recordings differ nowhere, and so do two that are empty") {
    Draw draw;
    REQUIRE(learner({}, {}) == -1);
    for (int i = 0; i < 30; ++i) {
        const Recording steps = draw_recording(draw, i);
        REQUIRE(learner(steps, steps) == -1);
    }
}

PROPERTY("where one step differs, that step is found") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 45; ++i) {
        const Recording steps = draw_recording(draw, i);
        const int k = draw_step(draw, i, steps);
        const double x = steps[static_cast<std::size_t>(k)];
        all &= with(steps, k, x, i < 15 ? x + 1 : -x) == k;
    }
    REQUIRE(all);
}

PROPERTY("the last bit counts, in numbers of any size") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Recording steps = draw_recording(draw, i + 15);
        const int k = draw_step(draw, i, steps);
        const double x = i % 6 < 3 ? draw.sign() * draw.real(0.5, 2) : draw.sign() * draw.log(1e-320, 1e307);
        REQUIRE(with(steps, k, x, next_to(x)) == k);
        REQUIRE(with(steps, k, next_to(x), x) == k);
    }
    REQUIRE(learner({0.0}, {std::numeric_limits<double>::denorm_min()}) == 0);
}

PROPERTY("of several the first is told, whether the runs meet again or not") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 60; ++i) {
        const Recording steps = draw_recording(draw, i);
        Recording other = steps;
        const auto first = static_cast<std::size_t>(draw_step(draw, i, steps));
        for (std::size_t k = first; k < steps.size(); ++k)
            if (k == first || draw.integer(0, i % 3) == 0) other[k] = next_to(steps[k]) + (i < 15 ? 1 : 0);
        all &= learner(steps, other) == static_cast<int>(first);
        all &= learner(other, steps) == static_cast<int>(first);
    }
    REQUIRE(all);
}

PROPERTY("a recording that ends early differs at the step that it lacks") {
    Draw draw;
    for (int i = 0; i < 45; ++i) {
        const Recording steps = draw_recording(draw, i);
        const int kept = draw.integer(0, static_cast<int>(steps.size()) - 1);
        Recording shorter(steps.begin(), steps.begin() + kept);
        REQUIRE(learner(shorter, steps) == kept);
        REQUIRE(learner(steps, shorter) == kept);
        if (kept == 0) continue;
        const int k = draw.integer(0, kept - 1);
        auto& changed = shorter[static_cast<std::size_t>(k)];
        changed = -changed;
        REQUIRE(learner(shorter, steps) == k);
    }
}

PROPERTY("zeros of two signs differ") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Recording steps = draw_recording(draw, i);
        const int k = draw_step(draw, i, steps);
        REQUIRE(with(steps, k, 0.0, -0.0) == k);
        REQUIRE(with(steps, k, -0.0, 0.0) == k);
        REQUIRE(with(steps, k, -0.0, -0.0) == -1);
    }
}

PROPERTY("the same NaN does not differ, and NaN differs from a number and from infinity") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Recording steps = draw_recording(draw, i);
        const int k = draw_step(draw, i, steps);
        const double x = steps[static_cast<std::size_t>(k)];
        REQUIRE(with(steps, k, not_a_number, not_a_number) == -1);
        REQUIRE(with(steps, k, x, not_a_number) == k);
        REQUIRE(with(steps, k, not_a_number, infinity) == k);
        REQUIRE(with(steps, k, infinity, infinity) == -1);
        REQUIRE(with(steps, k, infinity, -infinity) == k);
    }
}

PROPERTY("an hour at sixty steps a second is looked through, to its last step") {
    const Recording steps(216'000, 1.5);
    Recording other = steps;
    other.back() = next_to(1.5);
    REQUIRE(learner(steps, other) == static_cast<int>(steps.size()) - 1);
}
