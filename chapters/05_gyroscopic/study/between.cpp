// Between two steps: which orientation does the frame draw?

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using Q = Quaternion<double>;
using V = Vector3<double>;
constexpr double degree = pi / 180;

/// [nlerp]
Q nlerp(const Q& q1, Q q2, double alpha) {
    // The same orientation, the short way.
    if (q1.dot(q2) < 0) q2.coeffs() *= -1;
    const double beta = 1 - alpha;
    Q mean(beta * q1.coeffs() + alpha * q2.coeffs());
    return mean.normalized();
}
/// [nlerp]

double off(const Q& p, const Q& q) { return 2 * std::asin(std::min(1.0, apart(p, q) / 2)) / degree; }

}  // namespace

void between_steps(const Settings& settings, lab::Findings& out) {
    out.section("Between two orientations");
    auto& table = out.table("between.tsv", {"turn", "nlerp", "box"});
    const auto brick = box(12.0, 1.0, 2.0, 3.0);
    double turn_30 = 0, turn_90 = 0, turn_180 = 0, axis = 0, ends = 0;
    double order = 0, last = 0, last_box = 0, box_order = 0, box_60 = 0, box_nlerp = 0;
    const double at_60 = settings.spin * settings.step / degree;
    for (const double turn : {2.5, 5.0, 10.0, 20.0, 30.0, 45.0, 90.0, 135.0, 180.0}) {
        const Q q1 = Q(Eigen::AngleAxisd(0.7, V(1, 2, 2).normalized()));
        const Q q2 = q1 * Q(Eigen::AngleAxisd(turn * degree, V(2, -1, 2).normalized()));
        double worst = 0;
        for (int i = 0; i <= 200; ++i) {
            const double alpha = i / 200.0;
            const Q truth = q1 * Q(Eigen::AngleAxisd(alpha * turn * degree, V(2, -1, 2).normalized()));
            const Q mean = nlerp(q1, q2, alpha);
            worst = std::max(worst, off(mean, truth));
            axis = std::max(axis, (q1.conjugate() * mean).vec().cross(V(2, -1, 2).normalized()).norm());
            if (i % 200 == 0) ends = std::max(ends, off(mean, truth));
            if (turn < 180) ends = std::max(ends, off(q1.slerp(alpha, q2), truth));
        }
        // A box about its intermediate axis, in the middle of its first flip, where ω turns
        // fastest.
        const double spin = 10, h = turn * degree / spin;
        // A quarter of the way to the next step: half-way slerp and nlerp are the same orientation.
        const auto exact = ExactFreeBody<double>(brick, spinning(0.1, spin, 0.1));
        double box_worst = 0, box_mean = 0;
        for (double t = 0; t < 4; t += 0.05) {
            const Q a = exact(t).q, b = exact(t + h).q, truth = exact(t + h / 4).q;
            box_worst = std::max(box_worst, off(a.slerp(0.25, b), truth));
            box_mean = std::max(box_mean, off(nlerp(a, b, 0.25), truth));
        }
        if (turn < 100)
            table.row({turn, worst, box_worst});
        else
            table.row({turn, worst, "NaN"});
        if (turn == 5) order = std::log2(worst / last), box_order = std::log2(box_worst / last_box);
        if (turn == 10) box_60 = box_worst, box_nlerp = box_mean;
        if (turn == 30) turn_30 = worst;
        if (turn == 90) turn_90 = worst;
        if (turn == 180) turn_180 = worst;
        last = worst, last_box = box_worst;
        std::printf(
            "  %5.1f degrees a step: nlerp off by %8.2g, slerp on a tumbling box by %8.2g "
            "degrees\n",
            turn, worst, box_worst);
    }
    const Q q1 = Q::Identity(), q2(Eigen::AngleAxisd(30 * degree, V::UnitX())),
            minus(-q2.w(), -q2.x(), -q2.y(), -q2.z());
    const Q bare = Q((q1.coeffs() + minus.coeffs()) / 2).normalized();
    const double long_way = off(bare, Q(Eigen::AngleAxisd(15 * degree, V::UnitX())));
    std::printf(
        "  with the other sign, half-way: off by %.0f degrees; at 60 Hz and 10 rad/s a step is "
        "%.1f degrees\n",
        long_way, at_60);
    out.number("between_30", turn_30, "°", "nlerp off, 30 degrees a step", 2);
    out.number("between_90", turn_90, "°", "nlerp off, a quarter turn a step", 2);
    out.number("between_180", turn_180, "°", "nlerp off, half a turn a step", 2);
    out.number("between_box", box_60, "°",
               "slerp off a quarter of the way on a tumbling box that turns 10 degrees a step", 2);
    out.check("nlerp_right_axis", axis < 1e-14 && ends < 1e-5,
              "nlerp turns about the right axis and is right at both ends, and slerp is right all "
              "the way at a constant spin");
    out.check("nlerp_cube", std::fabs(order - 3) < 0.05 && turn_30 < 0.1,
              "nlerp's error falls with the cube of the turn");
    out.check("slerp_no_better", std::fabs(box_nlerp / box_60 - 1) < 0.01 && std::fabs(box_order - 2) < 0.2,
              "on a tumbling box slerp is off as much as nlerp, a quarter of the way between two "
              "steps, and that falls with the square of the turn");
    out.check("long_way", std::fabs(long_way - 180) < 1e-5 && off(nlerp(q1, minus, 0.5), nlerp(q1, q2, 0.5)) < 1e-5,
              "with the other sign the mean of two orientations, half-way, is half a turn off, and "
              "nlerp, which looks at the sign, "
              "is not");
}
