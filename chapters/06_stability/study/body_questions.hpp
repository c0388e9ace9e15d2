#pragma once
// Random questions about spinning bodies, and what the library's own steps answer to them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <timestep/nearly_symmetric.hpp>

#include "advise_body.hpp"

namespace questions {

using Vector = timestep::Vector3<double>;
using Body = timestep::PrincipalInertia<double>;

struct Question {
    Body inertia{1, 1, 1};
    Vector direction;  // of the spin
    double turn = 0;   // h|ω|
    bool even = true;  // else every frame has another length, down to a third
    long count = 1;
};

class Random {
public:
    explicit Random(unsigned long seed) : random_(seed) {}

    double even(double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>()(random_);
    }
    double even_in_log(double low, double high) { return low * std::pow(high / low, even(0, 1)); }
    Vector direction() {
        std::normal_distribution<double> normal;
        Vector d(normal(random_), normal(random_), normal(random_));
        return d.normalized();
    }
    // Any body, one in three with two moments within five percent, or equal, one in three all but
    // flat; each with its axes in any order.
    Body body() {
        double moments[3];
        const double kind = even(0, 3);
        const auto reach = [&] { return even_in_log(1e-3, 1); };
        const double A = reach(), B = reach(), C = reach();
        if (kind < 1) {
            moments[0] = B + C, moments[1] = C + A, moments[2] = A + B;
        } else if (kind < 2) {
            moments[0] = 1, moments[1] = even(0, 4) < 1 ? 1 : 1 - even(0, timestep::nearly_equal);
            // Between the difference of the two and their sum.
            moments[2] = even_in_log(std::max(1e-3, 1.01 * (1 - moments[1])), moments[0] + moments[1]);
        } else {
            const double thin = even_in_log(1e-9, 1e-2) * std::min(A, B);
            moments[0] = B + thin, moments[1] = thin + A, moments[2] = A + B;
        }
        std::shuffle(moments, moments + 3, random_);
        return {moments[0], moments[1], moments[2]};
    }
    // Off the axis of the middle moment by a hundredth to a ten-thousandth: there errors grow
    // fastest.
    Vector near_middle(const Body& body) {
        int least, most;
        body.moments.minCoeff(&least), body.moments.maxCoeff(&most);
        return (Vector::Unit(3 - least - most) + even_in_log(1e-4, 1e-2) * direction()).normalized();
    }

private:
    std::mt19937_64 random_;
};

// h|ω| from 1e-3 to 30.
inline Question any(Random& random) {
    return {random.body(), random.direction(), random.even_in_log(1e-3, 30), random.even(0, 3) > 1, 1};
}

inline timestep::Frames frames(const Question& q) { return {q.even ? 1 : 1.0 / 3, 1}; }  // so |ω| is the turn

// Is the verdict true of the solver's own steps? One step in a thousand directions, and runs of
// three hundred.
inline bool true_of_steps(const timestep::BodyAdvice& said, const timestep::BodySolver& solver, const Question& q,
                          Random& random) {
    using timestep::AddsEnergy;
    const Body& body = q.inertia;
    double most = 0;
    const auto step = [&](const Vector& direction) {
        const double after = solver.gain(body, Vector(q.turn * direction));
        most = std::isnan(after) ? INFINITY : std::max(most, after);
    };
    if (said.adds == AddsEnergy::one_step_can) {
        if (!said.worst_spin.isZero()) step(said.worst_spin.normalized());
        for (int i = 0; i < 1000 && !(most > 1 + 1e-12); ++i)
            step(i % 2 ? random.direction() : random.near_middle(body));
        return most > 1 + 1e-12;
    }
    for (int i = 0; i < 1000; ++i) step(i % 2 ? random.direction() : random.near_middle(body));
    for (int i = 0; i < 6; ++i) {
        const Vector direction = i == 0 ? q.direction : i % 2 ? random.direction() : random.near_middle(body);
        const auto thrown = solver.throw_body(body, Vector(q.turn * direction), frames(q), 1e9, 300);
        most = std::max(most, thrown.most_energy);
    }
    return most <= said.bound * (1 + 1e-11);
}

struct Tally {
    long asked = 0, near = 0, never = 0, bounded = 0, can = 0, close = 0, wrong = 0;
    std::vector<std::string> missed;  // of those that were wrong
    void add(const timestep::BodyAdvice& said, bool right, const Question& q) {
        using timestep::AddsEnergy;
        ++asked;
        never += said.adds == AddsEnergy::never, bounded += said.adds == AddsEnergy::bounded;
        can += said.adds == AddsEnergy::one_step_can, close += said.adds == AddsEnergy::too_close_to_call;
        if (said.adds == AddsEnergy::too_close_to_call || right) return;
        ++wrong;
        char line[300];
        const Vector& I = q.inertia.moments;
        std::snprintf(line, sizeof line, "%s: %s, moments %.17g %.17g %.17g, turn %.17g, %s", said.method.c_str(),
                      words(said.adds), I.x(), I.y(), I.z(), q.turn, q.even ? "even" : "uneven");
        missed.push_back(line);
    }
};

// So many questions, to each solver in turn.
inline Tally verdicts(long how_many, unsigned long seed) {
    Random random(seed);
    Tally tally;
    while (tally.asked < how_many)
        for (const timestep::BodySolver& solver : timestep::body_solvers()) {
            if (tally.asked >= how_many) break;
            Question q = any(random);
            if (random.even(0, 3) < 1) {  // within a tenth of its own limit, or of another's where it has none
                const double own = solver.judge(q.inertia, 1, 1e-3, true).longest_step;
                const double limit =
                    own > 0 && own < 1e3
                        ? own
                        : std::min(1e3, (random.even(0, 2) < 1 ? 1 : 2) * timestep::longest_safe_step(q.inertia, 1));
                q.turn = limit * random.even(0.9, 1.1);
                ++tally.near;
            }
            const auto said = solver.judge(q.inertia, q.turn, 1, q.even);
            tally.add(said, true_of_steps(said, solver, q, random), q);
        }
    return tally;
}

// The recommended line against all others of its price, over throws in free flight.
struct Contest {
    std::string name;                     // of the line
    long asked = 0, wrong = 0, lost = 0;  // off by more than 1 % in two seconds, and lost
    double worst = 0;
    long beaten = 0;          // by another one of its price or cheaper, each in as many substeps as that buys
    long beaten_visibly = 0;  // and was off by more than 1 % itself
    double worst_beaten = 0;  // how far it was off, at most, where another was nearer by half
};

inline std::vector<Contest> recommended(long how_many, unsigned long seed, double fastest) {
    using namespace timestep;
    Random random(seed);
    std::vector<Contest> all;
    const double h = 1.0 / 60;
    for (long n = 0; n < how_many; ++n) {
        Question q{random.body(), random.direction(), random.even_in_log(0.01, fastest), random.even(0, 3) > 1,
                   random.even(0, 3) < 1 ? 5000L : 1L};
        if (random.even(0, 10) < 1) q.inertia = Body(1, 1, random.even_in_log(1e-3, 2));
        if (random.even(0, 2) < 1 && !(q.inertia.ratio.array() == 0).any()) q.direction = random.near_middle(q.inertia);
        const Frames frames(q.even ? h : h / 3, h);
        const Vector omega = q.turn / h * q.direction;
        const BodyRecommendation take = recommend(q.inertia, omega, frames, false, q.count);
        double price = 0, off = NAN;
        const auto run = [&](const BodySolver& solver, long substeps) {
            const Frames shorter((q.even ? h : h / 3) / double(substeps), h / double(substeps));
            const double found = solver.throw_body(q.inertia, omega, shorter, 2, most_thrown_steps).off;
            return std::isnan(found) ? 2 : found;
        };
        const BodySolver& taken =
            body_solver(take.choice.method == "dropped" ? NoGyroscopic::name : take.choice.method);
        price = taken.price.all() * double(take.substeps), off = run(taken, take.substeps);
        double nearest = INFINITY;
        for (const BodySolver& each : body_solvers()) {
            if (&each == &taken || !(each.price.all() <= price)) continue;
            const long substeps = each.price.all() > 0 ? std::max(1L, long(price / each.price.all())) : 1;
            nearest = std::min(nearest, run(each, substeps));
        }
        auto line = std::find_if(all.begin(), all.end(), [&](const Contest& c) { return c.name == take.choice.name; });
        if (line == all.end()) line = all.insert(all.end(), Contest{take.choice.name});
        ++line->asked, line->wrong += off > 0.01, line->lost += off > lost_orientation;
        line->worst = std::max(line->worst, off);
        // Of an orientation that is right already a nearer one is of no use to anybody.
        if (nearest < off && off > right_orientation) ++line->beaten, line->beaten_visibly += off > 0.01;
        if (nearest < off / 2) line->worst_beaten = std::max(line->worst_beaten, off);
    }
    return all;
}

// Of bodies with two moments so far apart: the share of two hundred throws that are nearer in ω,
// over ten seconds at 60 Hz and 5 to 30 rad/s, if the two are declared equal than by passive with
// three.
inline double nearer_declared(double apart, bool about_axis) {
    using namespace timestep;
    Random random(5);
    int nearer = 0, all = 0;
    while (all < 200) {
        const double along = random.even_in_log(0.02, 1.95);
        if (along > 2 - apart || along < apart) continue;
        const Body body(1 - apart, 1, along);
        Vector way = random.direction();
        if (about_axis) way = (Vector::UnitZ() + 0.1 * random.even(0, 1) * way).normalized();
        const SpinState<double> start{0, Quaternion<double>::Identity(), random.even(5, 30) * way};
        const ExactFreeBody<double> exact(body, in_world(start));
        const DeclaredEqual equal(body);
        SpinState<double> one = start, three = start;
        double off = 0;
        for (int n = 0; n < 600; ++n) {
            one = equal.step(body, one, 1.0 / 60);
            three = tumble<PassiveGyroscopic>.step(body, three, 1.0 / 60);
            const Vector truth = in_body(exact(one.t)).omega;
            off += (one.omega - truth).norm() - (three.omega - truth).norm();
        }
        nearer += off < 0, ++all;
    }
    return double(nearer) / all;
}

// Throws near the middle axis in uneven frames, h|ω| of a frame up to `fastest`: the share that is
// lost, and the worst.
struct Uneven {
    double lost = 0, worst = 0;
};
template <class Rule>
Uneven uneven_throws(const Rule& rule, double fair, double fastest, int throws) {
    Random random(9);
    Uneven all;
    const double h = 1.0 / 60;
    for (int i = 0; i < throws; ++i) {
        const Body body = random.body();
        const double turn = random.even_in_log(0.25, fastest);
        const Vector omega = turn / h * random.near_middle(body);
        const double substeps = std::ceil(turn / fair);
        const timestep::Frames frames(h / 3 / substeps, h / substeps);
        const double off = throw_body(rule, body, omega, frames, 2).off;
        all.lost += !(off <= timestep::lost_orientation) * 1.0 / throws;
        all.worst = std::max(all.worst, off);
    }
    return all;
}

}  // namespace questions
