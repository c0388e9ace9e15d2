#pragma once
// The scenes for the methods of chapters 2 to 4, in all of its models.

#include "extreme_theory.hpp"

namespace extremes {

// Makes the model when it is wanted, so that what it refuses is seen.
template <class Model, class... Parameters>
Make<Model> of(Parameters... parameters) {
    return [=] { return Model(parameters...); };
}

template <class Real>
class Methods {
    using S = State<Real>;
    using Method = ExtremeMethod<Real>;
    static constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    static constexpr Real inf = std::numeric_limits<Real>::infinity();
    static constexpr Real h = Real(1) / 64;
    static constexpr Real far = std::numeric_limits<Real>::max() / 5;

public:
    explicit Methods(std::vector<Cell>& cells) : cells_(cells) {}

    void all(const Method& method) {
        inputs(method);
        springs(method);
        invariances(method);
        masses(method);
        other_forces(method);
        if (method.template on<Decay<Real>, FirstOrder<Real>>().takes_force()) decays(method);
    }

private:
    // A cell, or the word that the method does not take the force.
    template <class Model, class State>
    void add(const char* scene, const Method& method, const Make<Model>& make, const State& start, Real step,
             long steps, const Theory& theory, const std::type_identity_t<Size<State>>& size) {
        const AnyMethod<Model, State>& stepped = method.template on<Model, State>();
        if (stepped.takes_force())
            cells_.push_back(cell(scene, stepped, make, start, step, steps, theory, size));
        else
            cells_.push_back({is_float<Real> ? "float" : "double", scene, method.name, Outcome::does_not_compile,
                              Outcome::does_not_compile, ""});
    }

    // Input that models and runs refuse.
    void inputs(const Method& method) {
        const auto size = [](const auto&) { return 0.0; };
        const auto spring = of<Spring<Real>>(6);
        const S good{0, 1, 0};
        add("step 0", method, spring, good, 0, 10, refused("step"), size);
        add("step < 0", method, spring, good, -h, 10, refused("step"), size);
        add("step huge", method, spring, good, huge<Real>, 10, refused("step"), size);
        add("step ∞", method, spring, good, inf, 10, refused("step"), size);
        add("step NaN", method, spring, good, nan, 10, refused("step"), size);
        add("steps < 0", method, spring, good, h, -1, refused("steps"), size);
        add("start ∞", method, spring, S{0, inf, 0}, h, 10, refused("start"), size);
        add("start NaN", method, spring, S{0, 1, nan}, h, 10, refused("start"), size);
        add("time −∞", method, spring, S{-inf, 1, 0}, h, 10, refused("start"), size);
        for (const auto& [scene, omega] :
             {std::pair{"ω huge", huge<Real>}, {"ω < 0", Real(-1)}, {"ω ∞", inf}, {"ω NaN", nan}})
            add(scene, method, of<Spring<Real>>(omega), good, h, 10, refused("omega"), size);
        // ω² is a number, h²ω² is not: only an implicit step's divisor holds that product.
        const Theory blows_up{Outcome::reported, 0, 0, 10};
        add("ω² h² huge", method, of<Spring<Real>>(stiff<Real>), good, stiff<Real>, 10,
            method.is_implicit ? refused("step") : blows_up, size);
        // ω² is a number, 2ζω is not.
        add("damper huge", method, of<DampedSpring<Real>>(10, std::numeric_limits<Real>::max() / 2), good, h, 10,
            refused("zeta"), size);
        add("gravity NaN", method, of<Projectile<Real>>(nan), good, h, 10, refused("gravity"), size);
        add("gravity ∞", method, of<Projectile<Real>>(inf), good, h, 10, refused("gravity"), size);
        add("drag NaN", method, of<Drag<Real>>(nan), good, h, 10, refused("drag"), size);
    }

    // One that stays bounded must have moved as well: it dies as fast as theory says, or it has
    // swung to the other side.
    void one_spring(const char* scene, const Method& method, Real omega, const S& start, Real step, long steps) {
        Real lowest = start.x;
        const auto size = [&, omega](const S& s) {
            lowest = std::min(lowest, s.x);
            return std::fabs(double(s.x)) + std::fabs(double(s.v)) / omega;
        };
        Theory theory = spring_theory<Real>(method, omega, 0, step, steps);
        const double first = size(start);
        theory.size *= first;
        bool dies = false;
        if (method.factor) {
            const Complex z(0, double(omega) * double(step));
            const double log_last = 0.99 * steps * std::log(std::abs(method.factor(z)));
            dies = log_last < -3;
            if (dies)  // to a few of the least numbers
                theory.last_size =
                    8 * first * std::exp(log_last) + 1000 * double(std::numeric_limits<Real>::denorm_min());
        }
        add(scene, method, of<Spring<Real>>(omega), start, step, steps, theory, size);
        Cell& cell = cells_.back();
        if (cell.found == Outcome::bounded && !dies && !(lowest < -start.x / 2)) cell.found = Outcome::wrong;
    }

    // A damper so hard that nothing moves any more: v = −(ω/2ζ) x. The implicit midpoint method
    // keeps the mean of two velocities there, and so jumps from 0 to twice of it and back; BDF2
    // starts with such a step.
    void hard_damper(const char* scene, const Method& method, Real zeta) {
        const bool jumps = method.is_midpoint;
        const Theory theory = spring_theory<Real>(method, 1, zeta, h, 100);
        add(scene, method, of<DampedSpring<Real>>(1, zeta), S{0, 1, 0}, h, 100, theory, [=](const S& s) {
            const double v = -2 * double(zeta) * double(s.v);  // 1 in theory
            const long step = std::lround(double(s.t / h));
            const double expected = jumps ? (step % 2 == 1 ? 2 : 0) : 1;
            const bool right = step < 10 || std::fabs(v - expected) < 1e-3;
            return theory.expected != Outcome::bounded || right ? std::fabs(double(s.x)) : 1e300;
        });
    }

    void springs(const Method& method) {
        const S start{0, 1, 0};
        one_spring("ωh = 5/3", method, 100, start, Real(1) / 60, 1000);
        one_spring("ω stiff", method, 64 * stiff<Real>, start, h, 100);
        one_spring("a million steps", method, 6, start, Real(1) / 60, 1'000'000);
        one_spring("start subnormal", method, 64, S{0, std::numeric_limits<Real>::min() / 128, 0}, h, 100);
        hard_damper("damper 1e30", method, Real(1e30));
        hard_damper("damper huge, ω = 1", method, huge<Real> / 2);

        // The force itself is too large for a number: no method can know what comes next.
        add("start huge", method, of<Spring<Real>>(6), S{0, far, 0}, h, 100, {Outcome::reported, 0, 0, 1},
            [](const S&) { return 0.0; });
    }

    // Answers that are known exactly, most of them from another run.
    void invariances(const Method& method) {
        const auto spring = of<Spring<Real>>(6);
        const auto from = [](Real t, Real x, Real v) { return S{t, x, v}; };
        // Nothing happens: in n steps so short v becomes n h ω², and x moves by less than its last
        // digit.
        const auto stands = [](const S& s) { return s.x == 1 ? std::fabs(double(s.v)) : 2; };
        add("step tiny", method, spring, from(0, 1, 0), tiny<Real>, 1000, {Outcome::exact, 40e3 * tiny<Real>}, stands);
        add("ω tiny", method, of<Spring<Real>>(tiny<Real>), from(0, 1, 0), h, 1000, {Outcome::exact, 0}, stands);
        // A straight line, each step rounded a few times.
        add("ω = 0", method, of<Spring<Real>>(0), from(0, 1, 1), h, 640, {Outcome::exact, 640 * 8 * 11 * eps<Real>},
            [](const S& s) { return std::fabs(double(s.x) - (1 + double(s.t))) + std::fabs(double(s.v) - 1); });
        // The force does not know the time, and does not care that it stands still: the same bits.
        const S reference = run(method.template on<Spring<Real>, S>(), spring(), from(0, 1, 0), h, 100);
        add("t + h = t", method, spring, from(huge<Real>, 1, 0), h, 100, {Outcome::exact, 0},
            [&](const S& s) { return s.t == huge<Real> && s.x == reference.x && s.v == reference.v ? 0.0 : 1.0; });
        // It does not know the unit of length either: a power of two changes no bit of the
        // mantissa.
        for (const auto& [scene, power] :
             {std::pair{"lengths × 2ⁿ", is_float<Real> ? 100 : 990}, {"lengths ÷ 2ⁿ", is_float<Real> ? -70 : -900}}) {
            const Real unit = std::ldexp(Real(1), power);
            add(scene, method, spring, from(0, unit, 0), h, 100, {Outcome::exact, 0},
                [&](const S& s) { return s.x == unit * reference.x && s.v == unit * reference.v ? 0.0 : 1.0; });
        }
        // v = g t, by every method, each step rounded a few times; Verlet's velocity is a
        // difference of positions that are 64 times as far from zero as a step is long.
        const Real g = -huge<Real> / 4;
        add("gravity huge", method, of<Projectile<Real>>(g), from(0, 0, 0), h, 64,
            {Outcome::exact, 64 * 64 * 8 * eps<Real>},
            [&](const S& s) { return std::fabs(double(s.v / g) - double(s.t)); });
    }

    // Two masses between two walls, the second `ratio` times the first.
    void masses(const Method& method) {
        using V = Eigen::Matrix<Real, 2, 1>;
        using V3 = Eigen::Matrix<Real, 3, 1>;
        const State<V> start{0, V(1, 0), V(0, 0)};
        const auto row = [&](const char* scene, Real ratio, Real step) {
            const CoupledSprings<Real, 2> springs(V(1, ratio), V3(1, 1, 1));
            const double omega = springs.frequencies().maxCoeff();
            const Make<CoupledSprings<Real, 2>> make = [&] { return springs; };
            add(scene, method, make, start, step, 100, spring_theory<Real>(method, omega, 0, step, 100),
                [&](const State<V>& s) {
                    return double(s.x.cwiseAbs().maxCoeff()) + double(s.v.cwiseAbs().maxCoeff()) / omega;
                });
        };
        row("masses 1 : 1e30", Real(1e30), Real(0.7));
        row("masses 1 : 1e−30", Real(1e-30), h);
        add("stiffness / mass ∞", method, of<CoupledSprings<Real, 2>>(V(1, tiny<Real>), V3(1, huge<Real>, 1)), start, h,
            100, refused("stiffness / mass"), [](const State<V>&) { return 0.0; });
    }

    void other_forces(const Method& method) {
        const long n = 1000;
        // No method changes v by more than 2 h ω² a step. An explicit one adds h times a mean of
        // forces, each ω² or less. An implicit one adds h times a force, and Newton–Raphson leaves
        // no more of its equation open than there was at the start, h ω² again.
        const Real omega = 1e10;
        add("pendulum stiff", method, of<Pendulum<Real>>(omega), S{0, 3, 0}, h, n,
            {Outcome::bounded, 2.1 * n * double(h) * omega * omega}, [](const S& s) { return std::fabs(double(s.v)); });
        // A spin that gravity cannot even be felt by: v stays, and x is v t.
        add("pendulum's spin huge", method, of<Pendulum<Real>>(1), S{0, 0, huge<Real> / 128}, h, 100,
            {Outcome::exact, 100 * 100 * eps<Real>}, [](const S& s) {
                const double v = double(huge<Real>) / 128;
                return std::fabs(s.v / v - 1) + (s.t > 0 ? std::fabs(s.x / v / s.t - 1) : 0);
            });
        // Explicitly, hk|v| is squared a step or worse. Implicit Euler stops the body: hk v² is
        // what it had, so v falls to 1e-14 and less in the first step. So does BDF2 in its second,
        // from (4|v₁| + |v₀|)/3; its first is an implicit midpoint step. That one stops the body in
        // the middle, and goes on as far again: v turns, and is no larger.
        const bool turns = method.is_midpoint;
        add("drag 1e30", method, of<Drag<Real>>(Real(1e30)), S{0, 0, 1}, h, 100,
            method.is_implicit ? Theory{Outcome::bounded, 1 + 8 * eps<Real>} : Theory{Outcome::reported, 0, 0, 6},
            [turns](const S& s) {
                const double v = std::fabs(double(s.v));
                const long step = std::lround(double(s.t / h));
                if (turns)
                    return (s.v > 0) == (step % 2 == 0) && v > 0.5 ? v : 2;
                else
                    return step > 3 ? v / 1e-10 : v;
            });
        // Forces that are too large for a number, and one that is not: far off, x stays there.
        const auto none = [](const auto&) { return 0.0; };
        add("drag 1e30, start huge", method, of<Drag<Real>>(Real(1e30)), S{0, 0, far}, h, 100,
            {Outcome::reported, 0, 0, 1}, none);
        add("drag, start huge", method, of<Drag<Real>>(1), S{0, 0, far}, h, 100, {Outcome::reported, 0, 0, 1}, none);
        add("pendulum's start huge", method, of<Pendulum<Real>>(6), S{0, far, 0}, h, 100,
            {Outcome::exact, 100 * 8 * eps<Real>}, [&](const S& s) {
                const double most = 36 * double(s.t) * 1.01;  // |sin| is 1 or less
                return std::fabs(double(s.v)) <= most ? std::fabs(double(s.x / far - 1)) : 1;
            });
        // From a subnormal length, in a plane. Along itself the tether is a spring: x = L (1 − cos
        // ωt) + sin ωt / ω. Methods of order one miss a tenth of the first term in ten steps, a
        // fortieth of the whole. (From rest there, a circle of states solves the implicit equation,
        // and none can be found.)
        using V = Eigen::Matrix<Real, 2, 1>;
        add("tether, start huge", method, of<Tether<Real>>(6, 1), State<V>{0, V(far, far), V(0, 0)}, h, 100,
            {Outcome::reported, 0, 0, 1}, none);
        add("tether's length subnormal", method, of<Tether<Real>>(6, 1),
            State<V>{0, V(std::numeric_limits<Real>::min() / 128, 0), V(1, 0)}, Real(1) / 600, 10,
            {Outcome::exact, 0.03}, [](const State<V>& s) {
                const double angle = 6 * double(s.t), right = 1 - std::cos(angle) + std::sin(angle) / 6;
                return s.t > 0 ? std::fabs(double(s.x.x()) / right - 1) : 0;
            });
        // A sum of forces: a weight of 1e20 N/kg on a spring swings about −g/ω², as far again at
        // the most.
        using Weight = Scene<Spring<Real>, Projectile<Real>>;
        const Real g = Real(1e20);
        Theory theory = spring_theory<Real>(method, 64, 0, h, 100);
        theory.size *= 2 * double(g) / (64 * 64);
        if (theory.expected == Outcome::grows)
            theory.log_growth += std::log(double(g) / (64 * 64));  // from a size of 1
        add("weight 1e20 on a spring", method, of<Weight>(Spring<Real>(64), Projectile<Real>(-g)), S{0, 1, 0}, h, 100,
            theory, [](const S& s) { return std::fabs(double(s.x)) + std::fabs(double(s.v)) / 64; });
    }

    // ẏ = λy. The implicit methods never grow where λ < 0; the others multiply by hλ, 1.6e28, at
    // least.
    void decays(const Method& method) {
        using Y = FirstOrder<Real>;
        const auto size = [](const Y& s) { return std::fabs(double(s.y)); };
        add("decay 1e30", method, of<Decay<Real>>(Real(-1e30)), Y{0, 1}, h, 100,
            method.is_implicit ? Theory{Outcome::bounded, 1 + 100 * 8 * eps<Real>}
                               : Theory{Outcome::reported, 0, 0, 12},
            size);
        add("decay 1e30, start huge", method, of<Decay<Real>>(Real(-1e30)), Y{0, far}, h, 100,
            {Outcome::reported, 0, 0, 1}, size);
        // It grows by R(0.95) a step, whatever a method makes of that.
        const double log_step = std::log(std::abs(method.factor(0.95)));
        const double log_largest = std::log(double(std::numeric_limits<Real>::max()));
        Theory growth{Outcome::reported, 0, 0, log_largest * 1.01 / log_step + 3};
        growth.earliest = log_largest * 0.99 / log_step - 3;
        add("decay upwards", method, of<Decay<Real>>(Real(0.95)), Y{0, 1}, 1, 2000, growth, size);
        add("decay 0", method, of<Decay<Real>>(0), Y{0, 1}, h, 100, {Outcome::exact, 0},
            [](const Y& s) { return std::fabs(double(s.y) - 1); });
        add("decay NaN", method, of<Decay<Real>>(nan), Y{0, 1}, h, 100, refused("lambda"), size);
        add("decay's start NaN", method, of<Decay<Real>>(-1), Y{0, nan}, h, 100, refused("start"), size);
    }

    std::vector<Cell>& cells_;
};

// The cells of every method in one kind of number.
template <class Real>
std::vector<Cell> of_methods_in() {
    std::vector<Cell> cells;
    for_all_methods([&](const auto& method) { Methods<Real>(cells).all(ExtremeMethod<Real>(method)); });
    return cells;
}
extern template std::vector<Cell> of_methods_in<float>();  // in extreme_methods_float.cpp

}  // namespace extremes
