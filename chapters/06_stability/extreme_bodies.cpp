// The scenes for the solvers and inertias of chapter 5.

#include <timestep/gyroscopic.hpp>
#include <timestep/rigid/body_scene.hpp>

#include "extremes.hpp"

namespace extremes {
namespace {

// A solver and the attitude's step, as a method that run() takes; the inertia is the model.
template <class Solver>
struct Turning {
    Solver solver;
    const char* name;
    template <class Inertia, class Real>
    RigidState<Real> step(const Inertia& inertia, const RigidState<Real>& s, Real h) const {
        return turn(solver, inertia, s, h);
    }
};

// The five inertias, their moments times a unit: the full one is the principal one in axes of its own.
template <class Real, class Visit>
void for_each_inertia(const Visit& visit) {
    visit("ball", +[](Real unit) { return UniformInertia<Real>(2 * unit); });
    visit("rod", +[](Real unit) { return RodInertia<Real>(2 * unit); });
    visit("symmetric", +[](Real unit) { return SymmetricInertia<Real>(2 * unit, unit); });
    visit("principal", +[](Real unit) {
        return PrincipalInertia<Real>(unit, 2 * unit, Real(2.5) * unit);
    });
    visit("full", +[](Real unit) {
        const Matrix3<Real> R = Quaternion<Real>(1, 2, 3, 4).normalized().toRotationMatrix();
        const Matrix3<Real> I = R * Vector3<Real>(1, 2, Real(2.5)).asDiagonal() * R.transpose();
        return FullInertia<Real>(unit * (I + I.transpose()) / 2);
    });
}

template <class Real>
class Bodies {
    using S = RigidState<Real>;
    using V = Vector3<Real>;
    static constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    static constexpr Real inf = std::numeric_limits<Real>::infinity();
    static constexpr Real h = Real(1) / 64;

public:
    explicit Bodies(std::vector<Cell>& cells) : cells_(cells) {}

    // What an inertia refuses to be, whatever the solver.
    void inertias() {
        const auto refuse = [&](const char* scene, const char* kind, const char* named,
                                const auto& make) {
            cells_.push_back(cell<decltype(make())>(
                scene, Turning<NoGyroscopic>{no_gyroscopic, kind}, make, spinning(1, "ball"), h, 1,
                refused(named), [](const S&) { return 0.0; }));
        };
        const char* moment_named = "moment of inertia";
        const char* least = "least moment of inertia";
        for (const auto& [scene, bad] : {std::pair{"moment 0", Real(0)},
                                         {"moment < 0", Real(-1)},
                                         {"moment ∞", inf},
                                         {"moment NaN", nan}}) {
            const Real moment = bad;
            refuse(scene, "ball", moment_named, [=] { return UniformInertia<Real>(moment); });
            refuse(scene, "rod", moment_named, [=] { return RodInertia<Real>(moment); });
            refuse(scene, "symmetric", moment_named,
                   [=] { return SymmetricInertia<Real>(1, moment); });
            refuse(scene, "principal", moment_named,
                   [=] { return PrincipalInertia<Real>(1, 1, moment); });
            refuse(scene, "full", !std::isfinite(moment) ? "inertia" : moment < 0 ? moment_named : least,
                   [=] { return FullInertia<Real>(V(1, 1, moment).asDiagonal()); });
        }
        // No body is so flat that one moment exceeds the sum of the others.
        refuse("moments 1, 1, 1e30", "symmetric", moment_named,
               [] { return SymmetricInertia<Real>(1, Real(1e30)); });
        refuse("moments 1, 1, 1e30", "principal", moment_named,
               [] { return PrincipalInertia<Real>(1, 1, Real(1e30)); });
        refuse("moments 1, 1, 1e30", "full", least,
               [] { return FullInertia<Real>(V(1, 1, Real(1e30)).asDiagonal()); });
        // A full matrix cannot tell so small a moment from its own roundoff.
        refuse("moments 1, 1, 1e−30", "full", least,
               [] { return FullInertia<Real>(V(1, 1, Real(1e-30)).asDiagonal()); });
    }

    template <class Solver>
    void all(const Solver& solver) {
        for_each_inertia<Real>([&](const std::string& kind, auto* inertia_of) {
            const std::string name = std::string(solver.name) + ", " + kind;
            const Turning<Solver> method{solver, name.c_str()};
            const auto inertia = inertia_of(1);
            inputs(method, kind, inertia);
            spins(method, kind, inertia);
            const int power = is_float<Real> ? 110 : 990;
            scaled("moments × 2ⁿ", method, kind, inertia, inertia_of(std::ldexp(Real(1), power)));
            scaled("moments ÷ 2ⁿ", method, kind, inertia, inertia_of(std::ldexp(Real(1), -power)));
        });
        needles(solver);
    }

private:
    // Askew in the world; a rod cannot spin about itself, the others do.
    static S spinning(Real spin, const std::string& kind) {
        const Quaternion<Real> q = Quaternion<Real>(1, 2, -1, 3).normalized();
        const V body =
            kind == "rod" ? V(Real(0.6), Real(0.8), 0) : V(Real(0.48), Real(0.6), Real(0.64));
        return {0, q, spin * (q * body)};
    }

    template <class Method, class Inertia>
    void add(const char* scene, const Method& method, const Inertia& inertia, const S& start, Real step,
             long steps, const Theory& theory, const Size<S>& size) {
        cells_.push_back(cell<Inertia>(scene, method, [&] { return inertia; }, start, step, steps, theory, size));
    }

    template <class Method, class Inertia>
    void inputs(const Method& method, const std::string& kind, const Inertia& inertia) {
        const auto refuse = [&](const char* scene, const char* named, const S& start, Real step) {
            add(scene, method, inertia, start, step, 10, refused(named),
                [](const S&) { return 0.0; });
        };
        const S good = spinning(1, kind);
        refuse("step 0", "step", good, 0);
        refuse("step huge", "step", good, huge<Real>);
        refuse("spin NaN", "start", {0, good.q, V(1, nan, 0)}, h);
        refuse("spin ∞", "start", {0, good.q, V(1, inf, 0)}, h);
        refuse("attitude NaN", "start", {0, Quaternion<Real>(nan, 0, 0, 0), good.omega}, h);
        refuse("attitude 0", "start", {0, Quaternion<Real>(0, 0, 0, 0), good.omega}, h);
    }

    // The energy that the solver lets a body reach, over that at the start. The passive and the
    // converged solver add none; the talk's adds none to a symmetric body, nor to any in steps as
    // short as ours. Dropped, ω stays in the world, and so in the body, which turns about it: the
    // energy stays. With the old inertia |L| stays, and the energy is at most that about the axis of
    // the least moment, 2.5 times that about the axis of the largest.
    template <class Method, class Inertia>
    void spins(const Method& method, const std::string& kind, const Inertia& inertia) {
        using Solver = decltype(method.solver);
        constexpr bool gyroscopic = Inertia::gyroscopic;
        constexpr bool blows_up = std::is_same_v<Solver, ExplicitGyroscopic> && gyroscopic;
        const auto bound = [](long steps) {
            return (std::is_same_v<Solver, OldInertia> ? 2.5 : 1) * (1 + steps * 64 * eps<Real>);
        };
        const auto energy = [&](Real spin) {  // in units of spin², as squares would overflow
            const double first =
                kinetic_energy(inertia, V(scaled_to_one(spinning(spin, kind), spin)));
            return [=](const S& s) {
                return risen<Solver>(double(kinetic_energy(inertia, V(scaled_to_one(s, spin)))) /
                                     first);
            };
        };

        // Nothing happens: h ω is below the last digit of everything it is added to.
        const S slow = spinning(tiny<Real>, kind);
        add("spin tiny", method, inertia, slow, h, 100, {Word::exact, 100 * 100 * eps<Real>},
            [=](const S& s) {
                return double(((s.omega - slow.omega) / tiny<Real>).cwiseAbs().maxCoeff());
            });
        // Explicitly the energy grows by h² times that of the torque, in every step: by 1 % at least.
        if constexpr (blows_up) {
            const auto size = energy(1);
            add("spin 1", method, inertia, spinning(1, kind), h, 1000, {Word::exact, 0.5},
                [=](const S& s) { return s.t > 0 && size(s) <= 1.01 ? 1.0 : 0.0; });
            Cell& gain = cells_.back();  // that is no law of growth for judge(); if it holds, it grows
            gain.expected = Word::grows;
            if (gain.found == Word::exact) gain.found = Word::grows;
        } else {
            add("spin 1", method, inertia, spinning(1, kind), h, 1000, {Word::bounded, bound(1000)},
                energy(1));
        }
        // The explicit step multiplies the spin across the axis by 1e7 or more, or squares it. The
        // talk's one iteration promises nothing at hω = 1e8, but where it is the solution, on a
        // symmetric body.
        const bool promises =
            !std::is_same_v<Solver, ImplicitGyroscopic> || !gyroscopic || kind == "symmetric";
        if (promises)
            add("spin 1e10", method, inertia, spinning(Real(1e10), kind), h, 100,
                blows_up ? Theory{Word::reported, 0, 0, 50} : Theory{Word::bounded, bound(100)},
                energy(Real(1e10)));
        // The same in steps of 100 s. In float the attitude's step, which squares hω/2, leaves the
        // numbers; whatever the solver, the run comes to its end.
        if (promises)
            add("hω = 1e20", method, inertia, spinning(Real(1e18), kind), 100, 10,
                is_float<Real> ? Theory{Word::reported, 0, 0, 1}
                : blows_up     ? Theory{Word::reported, 0, 0, 10}
                               : Theory{Word::bounded, bound(10)},
                energy(Real(1e18)));
        // The attitude's step squares hω/2.
        add("spin huge", method, inertia, spinning(is_float<Real> ? Real(1e24) : Real(1e200), kind), h, 10,
            {Word::reported, 0, 0, 1}, [](const S&) { return 0.0; });
    }

    // An energy over that at the start, for a bound above. Dropped, it must not fall either.
    template <class Solver>
    static double risen(double energy) {
        return std::is_same_v<Solver, NoGyroscopic> ? 1 + std::fabs(energy - 1) : energy;
    }

    static V scaled_to_one(const S& s, Real spin) { return s.q.conjugate() * V(s.omega / spin); }

    // Only the moments' ratios matter: the same motion with the unit 2ⁿ, but for roundoff. In a
    // thousand steps, some hundred roundings each, every rounding is kept or grows with the angle
    // turned.
    template <class Method, class Inertia>
    void scaled(const char* scene, const Method& method, const std::string& kind, const Inertia& plain,
                const Inertia& inertia) {
        const S right = run(method, plain, spinning(1, kind), h, 1000, [](const S&) {});
        add(scene, method, inertia, spinning(1, kind), h, 1000, {Word::exact, 1000 * 100 * eps<Real>},
            [=](const S& s) {
                return double((s.omega - right.omega).norm() +
                              (s.q.coeffs() - right.q.coeffs()).norm());
            });
    }

    // A needle 1e30 times as easily turned about itself. Old inertia divides roundoff by that
    // moment, and nobody can say what comes of it.
    template <class Solver>
    void needles(const Solver& solver) {
        if constexpr (std::is_same_v<Solver, OldInertia>) return;
        const auto needle = [&](const std::string& kind, const auto& inertia) {
            const std::string name = std::string(solver.name) + ", " + kind;
            const S start = spinning(1, kind);
            const double first = kinetic_energy(inertia, start);
            const auto size = [=](const S& s) {
                return risen<Solver>(double(kinetic_energy(inertia, s)) / first);
            };
            // Explicitly the spin across grows by √(1 + θ²) a step, θ = h ω_z.
            Theory theory{Word::bounded, 1 + 1000 * 64 * eps<Real>};
            if (std::is_same_v<Solver, ExplicitGyroscopic>)
                theory = {Word::grows, 0, 1000 * std::log1p(0.64 * 0.64 / 64)};
            add("moments 1, 1, 1e−30", Turning<Solver>{solver, name.c_str()}, inertia, start, Real(1) / 8,
                1000, theory, size);
        };
        needle("symmetric", SymmetricInertia<Real>(1, Real(1e-30)));
        needle("principal", PrincipalInertia<Real>(1, 1, Real(1e-30)));
    }

    std::vector<Cell>& cells_;
};

// A ball on the ground, as run() takes it: the body is the model.
template <class Real>
struct Rolling {
    using Scalar = Real;
    Real t;
    Motion<Real> motion;
};
template <class Real>
bool is_finite(const Rolling<Real>& s) {
    const Motion<Real>& m = s.motion;
    return is_finite(m.turning) && timestep::is_finite(m.x) && timestep::is_finite(m.v);
}
template <class Real>
struct Ball {
    UniformInertia<Real> inertia;
    Real mass, radius;
};
template <class Scene>
struct OnGround {
    static constexpr const char* name = "a ball on the ground";
    Scene scene;
    template <class Real>
    Rolling<Real> step(const Ball<Real>& ball, const Rolling<Real>& s, Real h) const {
        Motion<Real> m = s.motion;
        scene.step(ball, m, h);
        return {m.turning.t, m};
    }
};

template <class Real>
void on_ground(std::vector<Cell>& cells) {
    using S = Rolling<Real>;
    using V = Vector3<Real>;
    const Real nan = std::numeric_limits<Real>::quiet_NaN(), r = Real(0.5), g = Real(9.81);
    const Real h = Real(1) / 64;
    const Real fast = is_float<Real> ? Real(1e16) : Real(1e150);  // its square is a number
    const auto from = [&](Real v, Real spin, Real z) {
        return S{0, {{0, Quaternion<Real>::Identity(), V(0, spin, 0)}, V(0, 0, z), V(v, 0, 0)}};
    };
    const auto add = [&](const char* name, const auto& scene, Real mass, Real radius,
                         const S& start, long steps, const Theory& theory, const Size<S>& size) {
        const auto make = [&] {
            checked(start.motion);
            return checked(Ball<Real>{UniformInertia<Real>(Real(0.4) * r * r), mass, radius});
        };
        const OnGround<decltype(scene)> method{scene};
        cells.push_back(cell<Ball<Real>>(name, method, make, start, h, steps, theory, size));
    };
    const BodyScene lawn(Weight<Real>(g), Ground<Real>(Real(0.5)),
                         RollingResistance<Real>(Real(0.01)));
    const auto none = [](const S&) { return 0.0; };
    const S good = from(1, 0, r);
    for (const auto& [name, bad] : {std::pair{"mass 0", Real(0)},
                                    {"mass < 0", Real(-1)},
                                    {"mass NaN", nan},
                                    {"mass subnormal", std::numeric_limits<Real>::denorm_min()}})
        add(name, lawn, bad, r, good, 10, refused("mass"), none);
    for (const auto& [name, bad] : {std::pair{"radius 0", Real(0)}, {"radius NaN", nan},
                                    {"radius tiny", tiny<Real>}, {"radius huge", huge<Real>}})
        add(name, lawn, 1, bad, good, 10, refused("radius"), none);
    add("ball's speed huge", lawn, 1, r, from(huge<Real>, 0, r), 10, refused("speed"), none);
    add("ball's spin huge", lawn, 1, r, from(0, huge<Real>, r), 10, refused("speed"), none);
    add("ball's height NaN", lawn, 1, r, from(1, 0, nan), 10, refused("motion"), none);

    // Too fast for friction to be felt: v stays, and friction turns the ball, by 5/2 μ g t/r.
    const BodyScene ground(Weight<Real>(g), Ground<Real>(Real(0.5)));
    add("ball's speed 1e150", ground, 1, r, from(fast, 0, r), 100,
        {Word::exact, 100 * 8 * eps<Real>}, [=](const S& s) {
            const double right = 2.5 * 0.5 * g * double(s.t) / r;
            const double spin = double(s.motion.turning.omega.y());
            return std::fabs(double(s.motion.v.x() / fast - 1)) +
                   std::fabs(spin - right) / std::fmax(right, 1);
        });
    // So rough a ground that sliding ends in a step, at 5/7 of the speed, or at 2/7 of the spin.
    const BodyScene rough(Weight<Real>(g), Ground<Real>(huge<Real>));
    const auto rolls = [=](Real v) {
        return [=](const S& s) {
            const double x = double(s.motion.v.x() / v);
            const double y = double(r * s.motion.turning.omega.y() / v);
            return s.t > 0 ? std::fabs(x - 1) + std::fabs(y - 1) : 0;
        };
    };
    add("ball's speed 1e150, friction huge", rough, 1, r, from(fast, 0, r), 100,
        {Word::exact, 100 * 16 * eps<Real>}, rolls(5 * fast / 7));
    add("ball's spin 1e150, friction huge", rough, 1, r, from(0, fast, r), 100,
        {Word::exact, 100 * 16 * eps<Real>}, rolls(2 * r * fast / 7));
}

}  // namespace

std::vector<Cell> of_bodies() {
    std::vector<Cell> cells;
    Bodies<double>(cells).inertias();
    Bodies<float>(cells).inertias();
    on_ground<double>(cells);
    on_ground<float>(cells);
    for_each_gyroscopic([&](const auto& solver) {
        Bodies<double>(cells).all(solver);
        Bodies<float>(cells).all(solver);
    });
    return cells;
}

}  // namespace extremes
