// Which solver for my spinning body?

#include <algorithm>
#include <array>
#include <cmath>

#include "advise_body.hpp"
#include "method_on_spring.hpp"

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

template <class Rule>
void find_worst(BodyAdvice& advice, const Rule& rule, const PrincipalInertia<double>& inertia, double spin, double h) {
    const Worst worst = worst_direction([&](const Vector3<double>& direction) {
        return gain_of(rule, inertia, Vector3<double>(h * spin * direction));  // |ω| may be any size
    });
    advice.worst_gain = std::max(worst.gain, 1.0);
    advice.worst_spin = spin * worst.direction;
    if (worst.gain > 1 + more_than_roundoff) return;
    advice.adds = AddsEnergy::too_close_to_call;
    advice.reason += "; here less than 1e-12 of the energy, lost in roundoff";
}

// The solvers of chapter 5, from what one step of theirs can do.
template <class Solver>
void judge(BodyAdvice& advice, const Tumble<Solver>&, const PrincipalInertia<double>& inertia, double spin, double h,
           bool) {
    const SpinAdvice one = gyroscopic_solver(Solver::name).judge(inertia, spin, h);
    advice.adds = one.verdict == Verdict::stable  ? AddsEnergy::never
                  : one.verdict == Verdict::grows ? AddsEnergy::one_step_can
                                                  : AddsEnergy::too_close_to_call;
    advice.reason = one.reason;
    advice.longest_step = one.longest_step;
    advice.bound = advice.adds == AddsEnergy::never ? 1 : std::numeric_limits<double>::infinity();
    if (advice.adds == AddsEnergy::never) return;
    advice.worst_gain = one.worst_gain;
    advice.worst_spin = one.worst_spin;
}

void judge(BodyAdvice& advice, const LaggedInertiaSpin&, const PrincipalInertia<double>& inertia, double spin, double h,
           bool even) {
    judge(advice, Tumble<LaggedInertia>{}, inertia, spin, h, even);
    if (advice.adds == AddsEnergy::never) return;
    advice.bound = moment_ratio(inertia);
    advice.reason =
        "every step may add; |L| stays, so at most I_max/I_min = " + number(advice.bound) + " times the first";
}

// It keeps E/Δ with Δ = 1 − c (hω₂/2)², ω₂ that about the axis of the intermediate moment and c the
// middle share. As Δ is at most 1, E is never more than the first one over the first Δ, while that
// is above zero.
void judge(BodyAdvice& advice, const Tumble<HalfStepJacobian>& rule, const PrincipalInertia<double>& inertia,
           double spin, double h, bool even) {
    const double share = middle_share(inertia);
    if (share == 0) return void(advice.reason = "two equal moments: the energy stays");
    const double root = std::sqrt(share) * (h * spin / 2), left = 1 - root * root;
    advice.longest_step = 2 / std::sqrt(share) / spin;
    const Verdict side = verdict(root, 1);
    const std::string formula = "E/(1 − c (hω₂/2)²) stays, c = (I₂−I₁)(I₃−I₂)/(I₁I₃) = " + number(share);
    advice.bound = std::numeric_limits<double>::infinity();
    if (side == Verdict::stable && even) {
        advice.adds = AddsEnergy::bounded;
        advice.bound = 1 / left;
        advice.reason = formula + ": c (h|ω|/2)² = " + number(root * root) + " < 1; for every body h|ω| < 2 will do";
        return;
    }
    advice.adds = AddsEnergy::one_step_can;
    if (side == Verdict::stable) {
        advice.longest_step = 0;
        advice.reason =
            "frame by frame the energy may rise × " + number(1 / left) + ": the bound is that of a constant step";
        return find_worst(advice, rule, inertia, spin, h);
    }
    advice.reason = formula + ": c (h|ω|/2)² = " + number(root * root) + ", and from 1 on the Jacobian can be singular";
    if (side != Verdict::grows) return void(advice.adds = AddsEnergy::too_close_to_call);
    advice.worst_gain = std::numeric_limits<double>::infinity();
    advice.worst_spin = Vector3<double>::Zero();
}

void judge(BodyAdvice& advice, const Tumble<CayleyGyroscopic>&, const PrincipalInertia<double>&, double, double, bool) {
    advice.reason = "√I ω is turned: the energy stays, whatever the step";
}

void judge(BodyAdvice& advice, const Tumble<CalmHalfStep>&, const PrincipalInertia<double>&, double, double, bool) {
    advice.reason = "scaled back to the energy that the step began with, whatever the step";
}

void by_momentum(BodyAdvice& advice, const PrincipalInertia<double>& inertia) {
    advice.bound = moment_ratio(inertia);
    advice.adds = AddsEnergy::bounded;
    advice.reason = "|L| stays and E ≤ |L|²/2I_min: at most I_max/I_min = " + number(advice.bound) + " times the first";
}
void judge(BodyAdvice& advice, const Strang&, const PrincipalInertia<double>& inertia, double, double, bool) {
    if (no_torque(inertia)) return void(advice.reason = "equal moments: the energy is |L|²/2I, and |L| stays");
    by_momentum(advice, inertia);
}
template <class Rule>
void judge_remainder(BodyAdvice& advice, const Rule&, const PrincipalInertia<double>& inertia) {
    if (two_equal(inertia)) return void(advice.reason = "two equal moments: the exact motion");
    by_momentum(advice, inertia);
}
void judge(BodyAdvice& advice, const BallAndRemainder2& rule, const PrincipalInertia<double>& inertia, double, double,
           bool) {
    judge_remainder(advice, rule, inertia);
}
void judge(BodyAdvice& advice, const BallAndRemainder4& rule, const PrincipalInertia<double>& inertia, double, double,
           bool) {
    judge_remainder(advice, rule, inertia);
}

// With two equal moments the other two components of ω go round with the angle
// h·precession_ratio·ω_z a step, and chapter 3's 2√2 is the limit.
void judge(BodyAdvice& advice, const RungeKuttaSpin& rule, const PrincipalInertia<double>& inertia, double spin,
           double h, bool) {
    if (no_torque(inertia)) return void(advice.reason = "equal moments: no gyroscopic torque");
    const double limit = 2 * std::sqrt(2.0);
    advice.bound = std::numeric_limits<double>::infinity();
    if (two_equal(inertia)) {
        const double wobble = inertia.ratio.cwiseAbs().maxCoeff();
        advice.longest_step = limit / wobble / spin;
        const Verdict side = verdict(h * spin * wobble, limit);
        advice.reason = "two equal moments: h|ω| |I_along − I_across|/I_across = " + number(h * spin * wobble) +
                        (side == Verdict::grows ? " > 2√2" : " < 2√2");
        if (side == Verdict::stable) return void(advice.bound = 1);
        advice.adds = side == Verdict::grows ? AddsEnergy::one_step_can : AddsEnergy::too_close_to_call;
        if (side != Verdict::grows) return;
    } else {
        advice.adds = AddsEnergy::one_step_can;
        advice.longest_step = 0;
        advice.reason =
            "keeps nothing: a step changes the energy by a share that goes with (h|ω|)⁵, up or "
            "down";
    }
    find_worst(advice, rule, inertia, spin, h);
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
    const GyroscopicSolver& newton_step = gyroscopic_solver(ImplicitGyroscopic::name);
    if (callback)
        return turn < unbounded_step(inertia, 1) &&
               worst_direction([&](const Vector3<double>& way) { return newton_step.gain(inertia, way, turn); }, 1.001)
                       .gain <= 1.001;
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
                judge(advice, rule, inertia, spin, h, even);
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
