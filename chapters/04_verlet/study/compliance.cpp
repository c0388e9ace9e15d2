// XPBD: a rope that hangs the same at any frame rate, and what the frame rate does to its swing.

#include <cmath>
#include <cstdio>
#include <vector>

#include <Eigen/Core>

#include <timestep/methods/implicit_euler.hpp>

#include "sections.hpp"

using Eigen::Vector2d;

namespace {

const double g = 9.81, length = 0.1;
const std::size_t links = 20;
// So compliant that a rope of points of 1 kg hangs 5 % too long: link i carries links + 1 − i of
// them.
const double true_stretch = 0.05;
const double compliance = true_stretch * 2 * length / (g * double(links + 1));  // m/N

struct Rope {
    std::vector<Vector2d> x, before;
    std::vector<double> lambda;  // the multiplier of each link so far in this step: its pull times h²
};

// A link from point i − 1 to point i. w is one over a point's mass; the first point is held.
/// [xpbd]
// soft is the compliance over h².
void pull(Rope& rope, std::size_t i, double soft) {
    Vector2d& a = rope.x[i - 1];
    Vector2d& b = rope.x[i];
    const double wa = i > 1 ? 1 : 0, wb = 1;
    const Vector2d along = (b - a).normalized();
    const double excess = (b - a).norm() - length;
    double& lambda = rope.lambda[i];
    const double left = excess + soft * lambda;
    const double more = -left / (wa + wb + soft);
    lambda += more;
    a -= wa * more * along;
    b += wb * more * along;
}
/// [xpbd]

// How much too long it hangs at rest, in a share. Displacements shrink by 10/s, so that it comes to
// rest; there they are zero, and the rest is that of the undamped rope.
double hangs(double rate, int sweeps, double soft_per_h2) {
    const double h = 1 / rate;
    Rope rope;
    for (std::size_t i = 0; i <= links; ++i) rope.x.push_back({0, -double(i) * length});
    rope.before = rope.x;
    for (int n = 0; n < int(10 * rate); ++n) {
        rope.lambda.assign(links + 1, 0);
        for (std::size_t i = 1; i <= links; ++i) {
            const Vector2d next =
                rope.x[i] + std::exp(-10 * h) * (rope.x[i] - rope.before[i]) + h * h * Vector2d(0, -g);
            rope.before[i] = rope.x[i];
            rope.x[i] = next;
        }
        for (int k = 0; k < sweeps; ++k)
            for (std::size_t i = 1; i <= links; ++i) pull(rope, i, soft_per_h2 / (h * h));
    }
    return -rope.x[links][1] / (double(links) * length) - 1;
}

struct Swing {
    double left = 0;   // share of the amplitude after one of its own periods
    double apart = 0;  // largest distance from implicit Euler's position, m
};

// One point on one link that gives way like a spring of `omega`, pulled along its line, without
// weight.
Swing swings(double omega, double rate) {
    const double h = 1 / rate, start = 0.01;
    const timestep::Spring spring(omega);
    timestep::State<double> euler{0, start, 0};
    Rope rope{{{0, 0}, {0, -length - start}}, {{0, 0}, {0, -length - start}}, {0, 0}};
    const int steps = 60;
    double turned = 0, angle = 0, amplitude = start;
    Swing swing;
    for (int n = 0; n < steps; ++n) {
        const Vector2d next = rope.x[1] + (rope.x[1] - rope.before[1]);
        rope.before[1] = rope.x[1];
        rope.x[1] = next;
        rope.lambda[1] = 0;
        pull(rope, 1, 1 / (omega * omega * h * h));  // one link: the first pull already converges
        euler = timestep::implicit_euler.step(spring, euler, h);
        const double x = -rope.x[1][1] - length, v = -(rope.x[1] - rope.before[1])[1] / h;
        swing.apart = std::fmax(swing.apart, std::fabs(x - euler.x));
        const double now = std::atan2(-v / omega, x);
        turned += std::remainder(now - angle, 2 * pi);
        angle = now;
        amplitude = std::hypot(x, v / omega);
    }
    swing.left = std::pow(amplitude / start, 2 * pi / turned);
    return swing;
}

void compliant_swing(lab::Findings& out) {
    const double omega = 30;
    const Swing slow = swings(omega, 60), fast = swings(omega, 480);
    std::printf(
        "  a point that swings on one XPBD link at 30 rad/s: a period leaves %.1f %% at 60 Hz, "
        "%.1f %% at 480 Hz\n",
        100 * slow.left, 100 * fast.left);
    out.number("compliant_omega", omega, "rad/s", "spring that the compliance of the swinging link stands for", 2);
    out.number("compliant_wh", omega / 60, "", "its ωh at 60 Hz", 2);
    out.number("compliant_left", 100 * slow.left, "%", "XPBD at 60 Hz: amplitude left after a period", 2);
    out.number("compliant_left_fast", 100 * fast.left, "%", "XPBD at 480 Hz: amplitude left after a period", 2);
    // A position of 0.11 m is rounded by less than 1e-16 in a step, and the displacement keeps
    // that: 60 · 61 / 2 times at most.
    out.check("compliance_is_implicit_euler", slow.apart < 2e-13 && fast.apart < 2e-13,
              "a point on one XPBD link takes implicit Euler's positions, at 60 and at 480 Hz");
    out.check("compliance_swing_depends_on_the_rate", fast.left > 3 * slow.left,
              "a period leaves over three times as much of a swing on an XPBD link at 480 Hz as at "
              "60 Hz");
}

}  // namespace

void compliant_ropes(const Settings&, lab::Findings& out) {
    out.section("A rope with a compliance");
    auto& table = out.table("compliance.tsv", {"rate", "pbd", "few", "many"});
    double least = 1, most = 0, first = 0, last = 0, few = 0, off_fast = 0;
    for (const double rate : {30.0, 60.0, 120.0, 240.0, 480.0}) {
        const double pbd = hangs(rate, 8, 0), eight = hangs(rate, 8, compliance), many = hangs(rate, 200, compliance);
        std::printf(
            "  %3.0f Hz: PBD, 8 iterations %6.3f %%; XPBD, 8 iterations %6.3f %%, 200 iterations "
            "%6.3f %%\n",
            rate, 100 * pbd, 100 * eight, 100 * many);
        table.row({rate, 100 * pbd, 100 * eight, 100 * many});
        least = std::fmin(least, many), most = std::fmax(most, many);
        if (rate == 30) first = pbd;
        if (rate == 60) few = eight;
        last = pbd, off_fast = eight;
    }
    out.number("compliance", 1e3 * compliance, "mm/N", "compliance of a link", 2);
    out.number("compliant_true", 100 * true_stretch, "%", "by how much such a rope hangs too long", 2);
    out.number("compliant_few", 100 * few, "%", "XPBD at 60 Hz with 8 iterations", 2);
    out.number("compliant_fast", 100 * off_fast, "%", "XPBD at 480 Hz with 8 iterations", 2);
    out.number("stiffer_by", first / last, "", "PBD with 8 iterations: stretch at 30 Hz over that at 480 Hz", 3);
    out.check("compliance_holds", least > 0.99 * true_stretch && most < 1.01 * true_stretch,
              "with 200 iterations XPBD hangs within a hundredth as much too long as its "
              "compliance says, from 30 to 480 Hz");
    out.check("pbd_depends_on_the_rate", first / last > 200,
              "with eight iterations PBD stretches over 200 times as much at 30 Hz as at 480 Hz");
    out.check("few_iterations_are_soft", few > 1.1 * true_stretch && std::fabs(off_fast / true_stretch - 1) < 0.01,
              "eight iterations are too few for XPBD at 60 Hz, and enough at 480 Hz");
    compliant_swing(out);
}
