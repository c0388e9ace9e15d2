// Ten thousand bodies that tumble at 60 Hz.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <tuple>
#include <vector>

#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/rigid/many_bodies.hpp>

#include "sections.hpp"
#include "timing.hpp"

using namespace timestep;

namespace {

constexpr int of_a_kind = 2500, frames = 300;
constexpr float h = 1.0f / 60;

// One kind after the other, as in Bodies: the same order as in packs.
template <class Inertia>
struct Member {
    Inertia inertia;
    RigidState<float> state;
};
template <class Inertia>
using Members = std::vector<Member<Inertia>>;

struct Cost {
    double median = 0, worst = 0;  // ms a frame
};

template <class Step>
Cost frame_after_frame(const Step& step) {
    std::vector<double> all;
    for (int frame = 0; frame < frames; ++frame) all.push_back(1e3 * lab::seconds_of(step));
    std::sort(all.begin(), all.end());
    return {all[frames / 2], all.back()};
}

Quaternion<float> any_orientation(std::mt19937& random) {
    std::normal_distribution<float> normal;
    Quaternion<float> q;
    for (int k = 0; k < 4; ++k) q.coeffs()[k] = normal(random);
    return q.normalized();
}

void ten_thousand(lab::Findings& out) {
    out.section("Ten thousand bodies at 60 Hz");
    ManyBodies<float, UniformInertia, SymmetricInertia, PrincipalInertia> packed;
    Members<UniformInertia<float>> balls;
    Members<SymmetricInertia<float>> needles;
    Members<PrincipalInertia<float>> boxes;  // and plates
    std::mt19937 random(2);
    std::uniform_real_distribution<float> side(0.5f, 2), spin(-6, 6);
    const auto add = [&](auto& group, const auto& inertia) {
        const Vector3<float> omega(spin(random), spin(random), spin(random));
        group.push_back({inertia, {0, any_orientation(random), omega}});
        packed.add(inertia, group.back().state.q, group.back().state.omega);
    };
    for (int i = 0; i < of_a_kind; ++i) {
        add(balls, sphere(1.0f, side(random)));
        add(needles, staff(1.0f, side(random), 0.1f));
        add(boxes, box(1.0f, side(random), side(random), side(random)));
        add(boxes, box(1.0f, side(random), side(random), 0.05f));
    }
    const auto energy = [&] {
        double sum = 0;
        for (const auto& b : needles) sum += double(kinetic_energy(b.inertia, b.state));
        for (const auto& b : boxes) sum += double(kinetic_energy(b.inertia, b.state));
        return sum;
    };
    const double at_start = energy();
    const auto step_all = [&](auto&... group) {
        const auto step = [&](auto& bodies) {
            for (auto& b : bodies) b.state = step_rotation(half_step_jacobian, b.inertia, b.state, h);
        };
        (step(group), ...);
    };
    const Cost lanes = frame_after_frame([&] { packed.step(half_step_jacobian, h); });
    const Cost alone = frame_after_frame([&] { step_all(balls, needles, boxes); });
    std::printf("ms a frame   median   worst\n");
    std::printf("one by one  %7.3f %7.3f\n", alone.median, alone.worst);
    std::printf("in lanes    %7.3f %7.3f\n", lanes.median, lanes.worst);
    const double budget = 1000.0 / 60;
    out.number("demo_lanes", lanes.median, "ms", "a frame of all bodies in lanes, median", 2);
    out.number("demo_share", 100 * lanes.median / budget, "%", "of a frame at 60 Hz, in lanes", 2);
    double off = 0;
    for (std::size_t i = 0; i < needles.size(); ++i) {
        const auto& alike = packed.state<SymmetricInertia>(i).omega;
        off = std::max(off, double((alike - needles[i].state.omega).norm()));
    }
    // Each of 300 steps rounds ω of up to 10 rad/s some ten times, and the orientation that it is
    // turned by: 300 × 20 × 6e-8 × 10 if all were off to the same side.
    out.check("demo_same", off < 4e-3, "after five seconds needles spin in lanes as one by one");
    out.check("demo_energy", std::fabs(energy() / at_start - 1) < 1e-2, "and their energy is off by less than 1 %");
}

}  // namespace

void demo(const Settings&, lab::Findings& out) { ten_thousand(out); }
