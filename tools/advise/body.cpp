// Which solver for my spinning body?

#include <algorithm>
#include <array>
#include <cmath>

#include "advise_body.hpp"
#include "method_on_spring.hpp"
#include "words.hpp"

namespace timestep {

const char* words(AddsEnergy answer) {
    constexpr std::array all{"never", "bounded", "one step can", "too close to call"};
    return all[static_cast<std::size_t>(answer)];
}

namespace {

// Of the moments I₁ ≤ I₂ ≤ I₃: (I₂ − I₁)(I₃ − I₂)/(I₁I₃). By the triangle rule it is below 1, and
// it is 0 where two are equal.
double middle_share(const PrincipalInertia<double>& inertia) {
    const Vector3<double>& a = inertia.ratio;
    return std::max({0.0, a.x() * a.y(), a.y() * a.z(), a.z() * a.x()});
}
double moment_ratio(const PrincipalInertia<double>& inertia) {
    return inertia.unit.maxCoeff() / inertia.unit.minCoeff();
}
bool two_equal(const PrincipalInertia<double>& inertia) { return (inertia.ratio.array() == 0).any(); }

// The energy after a step of one second over that before it.
template <class Rule>
double gain_of(const Rule& rule, const PrincipalInertia<double>& inertia, const Vector3<double>& omega) {
    const PrincipalInertia<double> body = inertia.scaled_to_one();
    const SpinState<double> s{0, Quaternion<double>::Identity(), omega};
    return kinetic_energy(body, Vector3<double>(rule.step(detail::prepared(rule, body), s, 1.0).omega)) /
           kinetic_energy(body, omega);
}

// A body that spins in any direction, and the steps.
struct Spun {
    const PrincipalInertia<double>& inertia;
    double spin, h;
    bool even;
    double turn() const { return h * spin; }
};

template <class Rule>
void find_worst(BodyAdvice& advice, const Rule& rule, const Spun& body) {
    const Worst worst = worst_direction([&](const Vector3<double>& direction) {
        return gain_of(rule, body.inertia, Vector3<double>(body.turn() * direction));  // |ω| may be any size
    });
    advice.worst_gain = std::max(worst.gain, 1.0);
    advice.worst_spin = body.spin * worst.direction;
    if (advice.adds != AddsEnergy::one_step_can || worst.gain > 1 + more_than_roundoff) return;
    advice.adds = AddsEnergy::too_close_to_call;
    advice.reason += phrase("body.roundoff");
}

// A solver that adds energy at every step where there is a torque.
template <class Rule>
void judge_adding(BodyAdvice& advice, const Rule& rule, const Spun& body, const std::string& why) {
    advice.longest_step = 0, advice.bound = std::numeric_limits<double>::infinity();
    advice.adds = AddsEnergy::one_step_can;
    advice.reason = why;
    find_worst(advice, rule, body);
}

// A solver of which nothing is proven: it is judged by a search.
template <class Rule>
void judge(BodyAdvice& advice, const Rule& rule, const Spun& body) {
    judge_adding(advice, rule, body, phrase("body.searched"));
}

void judge(BodyAdvice& advice, const Tumble<ExplicitGyroscopic>& rule, const Spun& body) {
    if (no_torque(body.inertia)) return void(advice.reason = phrase("body.no_torque"));
    judge_adding(advice, rule, body, phrase("body.explicit"));
}

void judge(BodyAdvice& advice, const LaggedInertiaSpin& rule, const Spun& body) {
    if (no_torque(body.inertia)) return void(advice.reason = phrase("body.no_torque"));
    judge_adding(advice, rule, body, "");
    advice.bound = moment_ratio(body.inertia);
    advice.reason = phrase("body.lagged", {{"bound", number(advice.bound)}});
}

void judge(BodyAdvice& advice, const Tumble<NoGyroscopic>&, const Spun&) { advice.reason = phrase("body.dropped"); }

void judge(BodyAdvice& advice, const Tumble<ImplicitGyroscopic>& rule, const Spun& body) {
    if (two_equal(body.inertia)) return void(advice.reason = phrase("body.newton_two_equal"));
    const double spin = body.spin;
    advice.longest_step = longest_safe_step(body.inertia, spin);
    const Verdict side = verdict(body.h, advice.longest_step);
    advice.reason = phrase(body.h < advice.longest_step ? "body.newton_below" : "body.newton_above",
                           {{"turn", number(body.turn())}, {"limit", number(advice.longest_step * spin)}});
    if (side == Verdict::stable) return;
    advice.adds = side == Verdict::grows ? AddsEnergy::one_step_can : AddsEnergy::too_close_to_call;
    advice.bound = std::numeric_limits<double>::infinity();
    find_worst(advice, rule, body);
    if (const double unbounded = unbounded_step(body.inertia, spin); body.h >= unbounded) {
        advice.worst_gain = std::numeric_limits<double>::infinity();
        advice.reason += phrase("body.newton_unbounded", {{"turn", number(unbounded * spin)}});
    }
}

void judge(BodyAdvice& advice, const Tumble<ConvergedGyroscopic>&, const Spun&) {
    advice.reason = phrase("body.converged");
}

void judge(BodyAdvice& advice, const Tumble<PassiveGyroscopic>&, const Spun&) {
    advice.reason = phrase("body.passive");
}

// It keeps E/Δ with Δ = 1 − c (hω₂/2)², ω₂ that about the axis of the intermediate moment and c the
// middle share. As Δ is at most 1, E is never more than the first one over the first Δ, while that
// is above zero.
void judge(BodyAdvice& advice, const Tumble<HalfStepJacobian>& rule, const Spun& body) {
    const double share = middle_share(body.inertia);
    if (share == 0) return void(advice.reason = phrase("body.two_equal_energy"));
    const double root = std::sqrt(share) * (body.turn() / 2), left = 1 - root * root;
    advice.longest_step = 2 / std::sqrt(share) / body.spin;
    const Verdict side = verdict(root, 1);
    const std::string c = number(share), value = number(root * root);
    advice.bound = std::numeric_limits<double>::infinity();
    if (side == Verdict::stable && body.even) {
        advice.adds = AddsEnergy::bounded;
        advice.bound = 1 / left;
        advice.reason = phrase("body.jacobian_bounded", {{"c", c}, {"value", value}});
        return;
    }
    advice.adds = AddsEnergy::one_step_can;
    if (side == Verdict::stable) {
        advice.longest_step = 0;
        advice.reason = phrase("body.jacobian_uneven", {{"factor", number(1 / left)}});
        return find_worst(advice, rule, body);
    }
    advice.reason = phrase("body.jacobian_singular", {{"c", c}, {"value", value}});
    if (side != Verdict::grows) return void(advice.adds = AddsEnergy::too_close_to_call);
    advice.worst_gain = std::numeric_limits<double>::infinity();
}

void judge(BodyAdvice& advice, const Tumble<CayleyGyroscopic>&, const Spun&) { advice.reason = phrase("body.cayley"); }

void judge(BodyAdvice& advice, const Tumble<CalmHalfStep>&, const Spun&) { advice.reason = phrase("body.calm"); }

void by_momentum(BodyAdvice& advice, const Spun& body) {
    advice.bound = moment_ratio(body.inertia);
    advice.adds = AddsEnergy::bounded;
    advice.reason = phrase("body.momentum", {{"bound", number(advice.bound)}});
}

void judge(BodyAdvice& advice, const Strang&, const Spun& body) {
    if (no_torque(body.inertia)) return void(advice.reason = phrase("body.equal_energy"));
    by_momentum(advice, body);
}

template <class Rule>
requires std::is_same_v<Rule, BallAndRemainder2> || std::is_same_v<Rule, BallAndRemainder4>
void judge(BodyAdvice& advice, const Rule&, const Spun& body) {
    if (two_equal(body.inertia)) return void(advice.reason = phrase("body.exact"));
    by_momentum(advice, body);
}

// With two equal moments the other two components of ω go round with the angle
// h·precession_ratio·ω_z a step, and chapter 3's 2√2 is the limit.
void judge(BodyAdvice& advice, const RungeKuttaSpin& rule, const Spun& body) {
    if (no_torque(body.inertia)) return void(advice.reason = phrase("body.no_torque"));
    if (!two_equal(body.inertia)) return judge_adding(advice, rule, body, phrase("body.runge_kutta"));
    const double wobble = body.inertia.ratio.cwiseAbs().maxCoeff(), limit = 2 * std::sqrt(2.0);
    advice.longest_step = limit / wobble / body.spin;
    const Verdict side = verdict(body.turn() * wobble, limit);
    advice.reason = phrase(side == Verdict::grows ? "body.wobble_above" : "body.wobble_below",
                           {{"value", number(body.turn() * wobble)}});
    if (side == Verdict::stable) return;
    advice.bound = std::numeric_limits<double>::infinity();
    advice.adds = side == Verdict::grows ? AddsEnergy::one_step_can : AddsEnergy::too_close_to_call;
    if (side == Verdict::grows) find_worst(advice, rule, body);
}

void check_spin(double spin, double h) {
    positive("spin", spin);
    positive("step times spin", h * spin);
    if (spin > 1e50) refuse("spin", spin, "at most 1e50");
    if (h * spin > 1e50) refuse("step times spin", h * spin, "at most 1e50");
}

// |ω̇| is at most a |ω|²/√3, a the largest of the ratios. So a body that is turned by its first ω is
// off by at most a (|ω| t)²/2√3 after t seconds, and t is two. (A third instead of 1/2√3: |ω| grows
// by a share of a at most.)
bool passes_for_ball(const PrincipalInertia<double>& inertia, double spin) {
    const double a = inertia.ratio.cwiseAbs().maxCoeff();
    return a <= nearly_equal && a * (2 * spin) * (2 * spin) / 3 <= right_orientation;
}

// Two nearly equal moments count as equal if the step for equal moments is accurate for this body.
// In the air that step is ball and remainder 2, with the true moments, and the given throw decides:
// the step may be accurate about the length and wrong across it. For a callback the step is one
// Newton step, which must add next to no energy in any direction, as contacts turn the spin. With
// contacts alone the calm half-step of three moments is all but that of two.
bool passes_for_symmetric(const PrincipalInertia<double>& inertia, const Vector3<double>& omega, const Frames& frames,
                          bool contacts, bool callback) {
    if (!closest_moments(inertia).all_but_equal() || contacts != callback) return false;
    const double turn = frames.longest() * omega.stableNorm();
    const auto gain = [&](const Vector3<double>& way) {
        return gain_of(tumble<ImplicitGyroscopic>, inertia, Vector3<double>(turn * way));
    };
    if (callback) return turn < unbounded_step(inertia, 1) && worst_direction(gain, 1.001).gain <= 1.001;
    return body_solver(BallAndRemainder2::name)
               .throw_body(inertia, as_thrown(omega), frames, 2, most_thrown_steps)
               .off <= right_orientation;
}

}  // namespace

const std::vector<BodySolver>& body_solvers() {
    static const std::vector<BodySolver> all = [] {
        std::vector<BodySolver> made;
        for_each_body_solver([&](const auto& rule, const BodyPrice& price) {
            using Rule = std::remove_cvref_t<decltype(rule)>;
            BodySolver solver{Rule::name, price, {}, {}, {}};
            solver.judge = [=](const auto& inertia, double spin, double h, bool even) {
                BodyAdvice advice;
                advice.method = Rule::name, advice.price = price;
                judge(advice, rule, Spun{inertia, spin, h, even});
                return advice;
            };
            solver.throw_body = [=](const auto& inertia, const auto& omega, const Frames& frames, double seconds,
                                    long most_steps) {
                return timestep::throw_body(rule, inertia, omega, frames, seconds, most_steps);
            };
            solver.gain = [=](const auto& inertia, const auto& omega) { return gain_of(rule, inertia, omega); };
            made.push_back(std::move(solver));
        });
        return made;
    }();
    return all;
}

const BodySolver& body_solver(std::string_view name) {
    for (const BodySolver& each : body_solvers())
        if (name == each.name) return each;
    refuse("there is no solver of bodies \"" + std::string(name) + "\"");
}

std::vector<BodyAdvice> advise_body(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                                    const Frames& frames) {
    const double spin = omega.stableNorm(), h = frames.longest();
    check_spin(spin, h);
    const Vector3<double> tilted = as_thrown(omega);
    std::vector<BodyAdvice> all;
    for (const BodySolver& solver : body_solvers()) {
        all.push_back(solver.judge(inertia, spin, h, frames.even()));
        all.back().thrown = solver.throw_body(inertia, tilted, frames, 10, most_thrown_steps);
    }
    return all;
}

BodyRecommendation recommend(const PrincipalInertia<double>& inertia, const Vector3<double>& omega,
                             const Frames& frames, bool contacts, long count, bool callback) {
    const Vector3<double>& I = inertia.moments;
    const double spin = omega.stableNorm(), turn = frames.longest() * spin;
    check_spin(spin, frames.longest());
    const double most = frames.even() ? fair_turn : fair_uneven_turn;
    if (turn > 1e9 * most)
        refuse("spin", spin,
               ("so slow that a step turns the body by at most " + number(1e9 * most) + " rad, 1e9 substeps of " +
                number(most))
                   .c_str());
    BodyQuestion question{{I.x(), I.y(), I.z()}, turn, contacts, count, frames.even(), callback};
    question.is_ball = passes_for_ball(inertia, spin);
    question.is_symmetric = passes_for_symmetric(inertia, omega, frames, contacts, callback);
    BodyRecommendation found{choose(question), 1};
    const double fair = found.choice.name == "free_fast"     ? fair_turn
                        : found.choice.name == "free_uneven" ? fair_uneven_turn
                                                             : turn;
    // 15 rad/s at 60 Hz is a quarter, whatever its last digit.
    found.substeps = std::llround(std::max(std::ceil(turn / fair * (1 - 1e-12)), 1.0));
    return found;
}

}  // namespace timestep
