#pragma once
// The scenes for the solvers and inertias of chapter 5.

#include <string_view>
#include <variant>

#include <timestep/gyroscopic.hpp>
#include <timestep/rigid/body.hpp>

#include "extremes.hpp"

namespace extremes {

template <class Real>
using AnyInertia = std::variant<UniformInertia<Real>, RodInertia<Real>, SymmetricInertia<Real>, PrincipalInertia<Real>,
                                FullInertia<Real>>;

template <class Real>
bool is_gyroscopic(const AnyInertia<Real>& any) {
    return std::visit([](const auto& inertia) { return inertia.gyroscopic; }, any);
}
// Of a spin in the body's axes.
template <class Real>
Real energy_of(const AnyInertia<Real>& any, const Vector3<Real>& omega) {
    return std::visit([&](const auto& inertia) { return kinetic_energy(inertia, omega); }, any);
}

// Any solver and the orientation's step, as a method that run() takes; the inertia is the model.
// The solver is a plain function, so that scenes and their runs are compiled once and not for each
// of thirty pairs.
template <class Real>
struct AnySolver {
    using S = RigidState<Real>;
    const char* name;
    S (*turned)(const AnyInertia<Real>&, const S&, Real h);

    template <class Solver>
    explicit AnySolver(const Solver&)
        : name(Solver::name), turned([](const AnyInertia<Real>& any, const S& s, Real h) {
              return std::visit([&](const auto& inertia) { return step_rotation(Solver{}, inertia, s, h); }, any);
          }) {}

    S step(const AnyInertia<Real>& inertia, const S& s, Real h) const { return turned(inertia, s, h); }
    bool is(std::string_view other) const { return name == other; }
};

// The five inertias, their moments times a unit: the full one is the principal one in axes of its
// own.
template <class Real>
AnyInertia<Real> inertia_of(const std::string& kind, Real unit) {
    if (kind == "ball") return UniformInertia<Real>(2 * unit);
    if (kind == "rod") return RodInertia<Real>(2 * unit);
    if (kind == "symmetric") return SymmetricInertia<Real>(2 * unit, unit);
    if (kind == "principal") return PrincipalInertia<Real>(unit, 2 * unit, Real(2.5) * unit);
    const Matrix3<Real> R = Quaternion<Real>(1, 2, 3, 4).normalized().toRotationMatrix();
    const Matrix3<Real> I = R * Vector3<Real>(1, 2, Real(2.5)).asDiagonal() * R.transpose();
    return FullInertia<Real>(unit * (I + I.transpose()) / 2);
}

template <class Real>
class Bodies {
    using S = RigidState<Real>;
    using V = Vector3<Real>;
    using Solver = AnySolver<Real>;
    using Inertia = AnyInertia<Real>;
    static constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    static constexpr Real inf = std::numeric_limits<Real>::infinity();
    static constexpr Real h = Real(1) / 64;

public:
    explicit Bodies(std::vector<Cell>& cells) : cells_(cells) {}

    // What an inertia refuses to be, whatever the solver.
    void inertias() {
        const auto refuse = [&](const char* scene, const char* kind, const char* named, const auto& make) {
            Solver solver(no_gyroscopic);
            solver.name = kind;
            cells_.push_back(cell<Inertia>(scene, solver, make, spinning(1, "ball"), h, 1, refused(named),
                                           [](const S&) { return 0.0; }));
        };
        const char* moment_named = "moment of inertia";
        const char* least = "least moment of inertia";
        for (const auto& [scene, bad] :
             {std::pair{"moment 0", Real(0)}, {"moment < 0", Real(-1)}, {"moment ∞", inf}, {"moment NaN", nan}}) {
            const Real moment = bad;
            refuse(scene, "ball", moment_named, [=] { return UniformInertia<Real>(moment); });
            refuse(scene, "rod", moment_named, [=] { return RodInertia<Real>(moment); });
            refuse(scene, "symmetric", moment_named, [=] { return SymmetricInertia<Real>(1, moment); });
            refuse(scene, "principal", moment_named, [=] { return PrincipalInertia<Real>(1, 1, moment); });
            refuse(scene, "full",
                   !std::isfinite(moment) ? "inertia"
                   : moment < 0           ? moment_named
                                          : least,
                   [=] { return FullInertia<Real>(V(1, 1, moment).asDiagonal()); });
        }
        // No body is so flat that one moment exceeds the sum of the others.
        refuse("moments 1, 1, 1e30", "symmetric", moment_named, [] { return SymmetricInertia<Real>(1, Real(1e30)); });
        refuse("moments 1, 1, 1e30", "principal", moment_named,
               [] { return PrincipalInertia<Real>(1, 1, Real(1e30)); });
        refuse("moments 1, 1, 1e30", "full", least, [] { return FullInertia<Real>(V(1, 1, Real(1e30)).asDiagonal()); });
        // A full matrix cannot tell so small a moment from its own roundoff.
        refuse("moments 1, 1, 1e−30", "full", least,
               [] { return FullInertia<Real>(V(1, 1, Real(1e-30)).asDiagonal()); });
    }

    void all(const Solver& solver) {
        for (const char* kind : {"ball", "rod", "symmetric", "principal", "full"}) {
            inputs(solver, kind);
            spins(solver, kind);
            const int power = is_float<Real> ? 110 : 990;
            scaled("moments × 2ⁿ", solver, kind, std::ldexp(Real(1), power));
            scaled("moments ÷ 2ⁿ", solver, kind, std::ldexp(Real(1), -power));
        }
        needles(solver);
    }

private:
    // Askew in the world; a rod cannot spin about itself, the others do.
    static S spinning(Real spin, const std::string& kind) {
        const Quaternion<Real> q = Quaternion<Real>(1, 2, -1, 3).normalized();
        const V body = kind == "rod" ? V(Real(0.6), Real(0.8), 0) : V(Real(0.48), Real(0.6), Real(0.64));
        return {0, q, spin * (q * body)};
    }

    void add(const char* scene, Solver solver, const std::string& kind, const Inertia& inertia, const S& start,
             Real step, long steps, const Theory& theory, const Size<S>& size) {
        const std::string name = std::string(solver.name) + ", " + kind;
        solver.name = name.c_str();
        cells_.push_back(cell<Inertia>(
            scene, solver, [&] { return inertia; }, start, step, steps, theory, size));
    }

    void inputs(const Solver& solver, const std::string& kind) {
        const auto refuse = [&](const char* scene, const char* named, const S& start, Real step) {
            add(scene, solver, kind, inertia_of<Real>(kind, 1), start, step, 10, refused(named),
                [](const S&) { return 0.0; });
        };
        const S good = spinning(1, kind);
        refuse("step 0", "step", good, 0);
        refuse("step huge", "step", good, huge<Real>);
        refuse("spin NaN", "start", {0, good.q, V(1, nan, 0)}, h);
        refuse("spin ∞", "start", {0, good.q, V(1, inf, 0)}, h);
        refuse("orientation NaN", "start", {0, Quaternion<Real>(nan, 0, 0, 0), good.omega}, h);
        refuse("orientation 0", "start", {0, Quaternion<Real>(0, 0, 0, 0), good.omega}, h);
    }

    // The energy that the solver lets a body reach, over that at the start. The passive and the
    // converged solver add none; the talk's adds none to a symmetric body, nor to any in steps as
    // short as ours. Dropped, ω stays in the world, and so in the body, which turns about it: the
    // energy stays. With the lagged inertia |L| stays, and the energy is at most that about the
    // axis of the least moment, 2.5 times that about the axis of the largest.
    void spins(const Solver& solver, const std::string& kind) {
        const Inertia inertia = inertia_of<Real>(kind, 1);
        const bool gyroscopic = is_gyroscopic(inertia);
        const bool blows_up = solver.is(ExplicitGyroscopic::name) && gyroscopic;
        const auto bound = [&](long steps) {
            return (solver.is(LaggedInertia::name) ? 2.5 : 1) * (1 + steps * 64 * eps<Real>);
        };
        const auto energy = [&](Real spin) {  // in units of spin², as squares would overflow
            const double first = energy_of(inertia, scaled_to_one(spinning(spin, kind), spin));
            return
                [=](const S& s) { return risen(solver, double(energy_of(inertia, scaled_to_one(s, spin))) / first); };
        };

        // Nothing happens: h ω is below the last digit of everything it is added to.
        const S slow = spinning(tiny<Real>, kind);
        add("spin tiny", solver, kind, inertia, slow, h, 100, {Outcome::exact, 100 * 100 * eps<Real>},
            [=](const S& s) { return double(((s.omega - slow.omega) / tiny<Real>).cwiseAbs().maxCoeff()); });
        // Explicitly the energy grows by h² times that of the torque, in every step: by 1 % at
        // least.
        if (blows_up) {
            const auto size = energy(1);
            add("spin 1", solver, kind, inertia, spinning(1, kind), h, 1000, {Outcome::exact, 0.5},
                [=](const S& s) { return s.t > 0 && size(s) <= 1.01 ? 1.0 : 0.0; });
            Cell& gain = cells_.back();  // that is no law of growth for judge(); if it holds, it grows
            gain.expected = Outcome::grows;
            if (gain.found == Outcome::exact) gain.found = Outcome::grows;
        } else {
            add("spin 1", solver, kind, inertia, spinning(1, kind), h, 1000, {Outcome::bounded, bound(1000)},
                energy(1));
        }
        // The explicit step multiplies the spin across the axis by 1e7 or more, or squares it. The
        // talk's one iteration promises nothing at hω = 1e8, but where it is the solution, on a
        // symmetric body.
        const bool promises = !solver.is(ImplicitGyroscopic::name) || !gyroscopic || kind == "symmetric";
        if (promises)
            add("spin 1e10", solver, kind, inertia, spinning(Real(1e10), kind), h, 100,
                blows_up ? Theory{Outcome::reported, 0, 0, 50} : Theory{Outcome::bounded, bound(100)},
                energy(Real(1e10)));
        // The same in steps of 100 s. In float the orientation's step, which squares hω/2, leaves
        // the numbers; whatever the solver, the run comes to its end.
        if (promises)
            add("hω = 1e20", solver, kind, inertia, spinning(Real(1e18), kind), 100, 10,
                is_float<Real> ? Theory{Outcome::reported, 0, 0, 1}
                : blows_up     ? Theory{Outcome::reported, 0, 0, 10}
                               : Theory{Outcome::bounded, bound(10)},
                energy(Real(1e18)));
        // The orientation's step squares hω/2.
        add("spin huge", solver, kind, inertia, spinning(is_float<Real> ? Real(1e24) : Real(1e200), kind), h, 10,
            {Outcome::reported, 0, 0, 1}, [](const S&) { return 0.0; });
    }

    // An energy over that at the start, for a bound above. Dropped, it must not fall either.
    static double risen(const Solver& solver, double energy) {
        return solver.is(NoGyroscopic::name) ? 1 + std::fabs(energy - 1) : energy;
    }

    static V scaled_to_one(const S& s, Real spin) { return s.q.conjugate() * V(s.omega / spin); }

    // Only the moments' ratios matter: the same motion with the unit 2ⁿ, but for roundoff. In a
    // thousand steps, some hundred roundings each, every rounding is kept or grows with the angle
    // turned.
    void scaled(const char* scene, const Solver& solver, const std::string& kind, Real unit) {
        const S right = run(solver, inertia_of<Real>(kind, 1), spinning(1, kind), h, 1000);
        add(scene, solver, kind, inertia_of(kind, unit), spinning(1, kind), h, 1000,
            {Outcome::exact, 1000 * 100 * eps<Real>}, [=](const S& s) {
                return double((s.omega - right.omega).norm() + (s.q.coeffs() - right.q.coeffs()).norm());
            });
    }

    // A needle 1e30 times as easily turned about itself. Old inertia divides roundoff by that
    // moment, and nobody can say what comes of it.
    void needles(const Solver& solver) {
        if (solver.is(LaggedInertia::name)) return;
        const auto needle = [&](const std::string& kind, const Inertia& inertia) {
            const S start = spinning(1, kind);
            const double first = energy_of(inertia, scaled_to_one(start, 1));
            const auto size = [=](const S& s) {
                return risen(solver, double(energy_of(inertia, scaled_to_one(s, 1))) / first);
            };
            // Explicitly the spin across grows by √(1 + θ²) a step, θ = h ω_z.
            Theory theory{Outcome::bounded, 1 + 1000 * 64 * eps<Real>};
            if (solver.is(ExplicitGyroscopic::name)) theory = {Outcome::grows, 0, 1000 * std::log1p(0.64 * 0.64 / 64)};
            add("moments 1, 1, 1e−30", solver, kind, inertia, start, Real(1) / 8, 1000, theory, size);
        };
        needle("symmetric", SymmetricInertia<Real>(1, Real(1e-30)));
        needle("principal", PrincipalInertia<Real>(1, 1, Real(1e-30)));
    }

    std::vector<Cell>& cells_;
};

// The cells of every solver in one kind of number.
template <class Real>
std::vector<Cell> of_bodies_in() {
    std::vector<Cell> cells;
    Bodies<Real>(cells).inertias();
    for_each_gyroscopic([&](const auto& solver) { Bodies<Real>(cells).all(AnySolver<Real>(solver)); });
    return cells;
}
extern template std::vector<Cell> of_bodies_in<float>();  // in extreme_bodies_float.cpp

}  // namespace extremes
