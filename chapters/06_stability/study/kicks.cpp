// What the rules of the first page take for granted: no kicks for BDF2, even steps, masses that do
// not turn.

#include <cmath>
#include <cstdio>
#include <random>

#include <Eigen/Core>

#include <timestep/methods/bdf2.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double h = 1.0 / 60;

// BDF2 as Bdf2Motion does it, but for one thing: told that the state has changed, it keeps the
// older one.
class Unaware {
public:
    explicit Unaware(const State<double>& start) : now_(start), before_(start) {}
    const State<double>& now() const { return now_; }
    void restart(const State<double>& state) { now_ = state; }
    void step(const Projectile<double>& model, double h_) {
        const State<double> next = first_ ? bdf2.start(model, now_, h_) : bdf2.step(model, before_, now_, h_);
        before_ = now_, now_ = next, first_ = false;
    }

private:
    State<double> now_, before_;
    bool first_ = true;
};

// The speed, a second later, of something that is kicked from rest to 1 m/s.
template <class Motion>
double kicked() {
    const Projectile nothing(0.0);
    Motion motion(State<double>{0, 0, 0});
    motion.step(nothing, h);
    State<double> faster = motion.now();
    faster.v += 1;
    motion.restart(faster);
    for (int n = 0; n < 60; ++n) motion.step(nothing, h);
    return motion.now().v;
}

// How high a ball gets in ten seconds that is dropped from a metre and keeps 0.6 of its speed in a
// bounce.
template <class Motion>
double highest() {
    const Projectile gravity(-9.81);
    Motion ball(State<double>{0, 1, 0});
    double most = 0;
    for (int n = 0; n < 600; ++n) {
        ball.step(gravity, h);
        if (State<double> s = ball.now(); s.x < 0 && s.v < 0) {
            s.x = 0;
            s.v *= -0.6;
            ball.restart(s);
        }
        most = std::fmax(most, ball.now().x);
    }
    return most;
}

void impulses(lab::Findings& out) {
    using Told = Bdf2Motion<State<double>>;
    const double bare = kicked<Unaware>(), mended = kicked<Told>();
    const double wild = highest<Unaware>(), tame = highest<Told>();
    std::printf(
        "  BDF2: a kick of 1 m/s becomes %.3g m/s, restarted %.3g m/s;\n"
        "  a ball dropped from 1 m rises to %.3g m, restarted after each bounce to %.3g m\n",
        bare, mended, wild, tame);
    out.number("kick_bare", bare, "m/s", "what BDF2 makes of a kick of 1 m/s", 3);
    out.number("ball_bare", wild, "m", "where a ball gets to that bounces by BDF2, dropped from 1 m", 3);
    out.number("ball_restarted", tame, "m", "the same, restarted after each bounce", 3);
    out.check("bdf2_kicks", std::fabs(bare - 1.5) < 1e-9 && std::fabs(mended - 1) < 1e-12 && wild > 2 && tame <= 1,
              "BDF2 makes 1.5 m/s of a kick of 1 m/s and lets a ball rise to over twice where it came "
              "from; "
              "restarted it does neither");
}

// A minute of a spring by semi-implicit Euler, each step one frame of 1/60 s or two of them.
void uneven_frames(lab::Findings& out) {
    const double omega = 30;
    const Spring<double> spring(omega);
    std::mt19937 random(1);
    State<double> even{0, 1, 0}, uneven = even;
    while (uneven.t < 60) {
        uneven = semi_implicit_euler.step(spring, uneven, random() % 2 ? 2 * h : h);
        even = semi_implicit_euler.step(spring, even, 2 * h);
    }
    const double grown = std::hypot(uneven.x, uneven.v / omega), stays = std::hypot(even.x, even.v / omega);
    std::printf(
        "  frames of 1/60 and 1/30 s at random, 30 rad/s: in a minute × %.1e; all of 1/30 s: × "
        "%.2g\n",
        grown, stays);
    out.number("uneven_omega", omega, "rad/s", "a spring on uneven frames");
    out.number("uneven_grown", grown, "", "what a minute of uneven frames multiplies its size by", 2);
    out.check("uneven_grows", grown > 1e3 && stays < 2,
              "a spring of 30 rad/s grows more than a thousandfold in a minute of frames of 1/60 "
              "and 1/30 s at "
              "random, and not when all of them are of 1/30 s");
}

// A plank on a spring under each end, its ends at ±r: how its places and its tilt are pulled, per
// mass.
struct Plank {
    double k = 1000, m = 1, r = 0.5, inertia = m * r * r / 3;       // N/m, kg, m, kg m²
    Eigen::Vector2d acceleration(const Eigen::Vector2d& y) const {  // height, tilt
        const double left = -k * (y[0] - r * y[1]), right = -k * (y[0] + r * y[1]);
        return {(left + right) / m, (right - left) * r / inertia};
    }
};

void bodies_that_turn(lab::Findings& out) {
    const Plank plank;
    const double sum = 2 * plank.k / plank.m;  // of the springs at it, over its mass
    const double counted = 2 * plank.k * (1 / plank.m + plank.r * plank.r / plank.inertia);
    const double step = 1.9 / std::sqrt(2 * sum);  // the rule for masses that do not turn calls it stable
    const auto grows = [&](double length) {
        const State<Eigen::Vector2d> start{0, {0, 0.01}, {0, 0}};
        const auto end = run(semi_implicit_euler, plank, start, length, 1000);
        return !(end.x.norm() < 1);
    };
    const double omega2 = 2 * plank.k * plank.r * plank.r / plank.inertia;
    out.number("plank_heaves", sum * plank.m / plank.k, "", "ω² of a plank's heaving, in k/m");
    out.number("plank_rocks", omega2 * plank.m / plank.k, "", "ω² of its rocking, in k/m");
    out.check("plank",
              grows(step) && grows(2.01 / std::sqrt(omega2)) && !grows(1.99 / std::sqrt(omega2)) &&
                  !grows(1.99 / std::sqrt(counted)),
              "a plank on two springs blows up from h²·6k/m = 4 on, at a step that the rule for "
              "masses which "
              "do not turn calls stable, and not at one that the rule for bodies calls stable");
}

// A ball between two taut springs, which take hold at ±r: turned by an angle, how much energy do
// they hold?
void taut_springs(lab::Findings& out) {
    const double k = 1000, r = 0.1, length = 1;
    bool all = true;
    for (const double rest : {0.0, 0.5, 0.9}) {
        const auto energy = [&](double angle) {
            const double stretched = std::hypot(length + r - r * std::cos(angle), r * std::sin(angle));
            return 2 * 0.5 * k * (stretched - rest) * (stretched - rest);
        };
        const double d = 1e-4, slope = (energy(d) - 2 * energy(0) + energy(-d)) / (d * d);  // I ω²
        const double pull = k * (length - rest);
        all = all && std::abs(slope / (2 * pull * r * (1 + r / length)) - 1) < 1e-4;
    }
    out.check("taut", all, "two taut springs pull a ball that has turned back with I ω² = 2 T r (1 + r/length)");
}

}  // namespace

void kicks(const Settings&, lab::Findings& out) {
    out.section("Kicks, uneven frames, bodies that turn");
    impulses(out);
    uneven_frames(out);
    bodies_that_turn(out);
    taut_springs(out);
}
