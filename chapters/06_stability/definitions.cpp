// What the words mean: does a method converge, how accurate is it, is it stable?

#include <algorithm>
#include <cstdio>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/elliptic.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

/// [always 42]
struct Always42 {
    static constexpr const char* name = "always 42";

    template <class Model, class X>
    State<X> step(const Model&, const State<X>& state1, real_of<X> h) const {
        return {state1.t + h, 42, 0};
    }
    template <class System, class Y>
    FirstOrder<Y> step(const System&, const FirstOrder<Y>& state1,
                       real_of<Y> h) const {
        return {state1.t + h, 42};
    }
};
/// [always 42]

// Every method of the course, and one that is none.
template <class Visit>
void for_each(const Visit& visit) {
    for_each_method(visit);
    visit(semi_implicit_euler_new_damping);
    for_each_verlet_method(visit);
    visit(Always42{});
}

// Verlet's kind takes no velocity, new damping wants a linear force, and a first-order system is
// not for methods that treat position and velocity differently.
template <class Method, class Model, class X>
constexpr bool takes(const State<X>&) {
    if constexpr (std::is_same_v<Method, Verlet> || std::is_same_v<Method, VelocityVerlet> ||
                  std::is_same_v<Method, Leapfrog>)
        return PositionForce<Model, X>;
    else if constexpr (std::is_same_v<Method, SemiImplicitEulerNewDamping>)
        return LinearForce<Model, X>;
    else
        return true;
}
template <class Method, class Model, class Y>
constexpr bool takes(const FirstOrder<Y>&) {
    using S = FirstOrder<Y>;
    return TwoStepMethod<Method, Model, S> || requires(const Method& m, const Model& f, S s) {
        m.step(f, s, 0.1);
    };
}

double distance(const State<double>& a, const State<double>& b) {
    return std::hypot(a.x - b.x, a.v - b.v);
}
double distance(const FirstOrder<double>& a, const FirstOrder<double>& b) {
    return std::fabs(a.y - b.y);
}

std::string rounded(double value) {
    char text[24];
    std::snprintf(text, sizeof text, "%.2f", std::fabs(value));
    return text;
}

// The pendulum let go at the angle x₀: sin(x/2) = k cn/dn with k = sin(x₀/2).
State<double> swung(const Pendulum<double>& pendulum, double x0, double t) {
    const double k = std::sin(x0 / 2), m1 = 1 - k * k;
    const auto [sn, cn, dn] = jacobi(pendulum.omega * t, m1);
    const double sine = k * cn / dn;  // of half the angle
    return {t, 2 * std::asin(sine),
            -2 * pendulum.omega * k * m1 * sn / (dn * dn) / std::sqrt(1 - sine * sine)};
}

// A fall from rest: v = −V tanh(gt/V), with the speed V at which the drag holds the weight.
State<double> fallen(double terminal, double g, double t) {
    const double u = g * t / terminal;
    return {t, -terminal * terminal / g * std::log(std::cosh(u)), -terminal * std::tanh(u)};
}

constexpr double seconds = 2;

// How fast the error at the end falls with the step. The compiler refuses a scene that the method
// does not take.
template <class Method, class Model, class S>
std::string order_on(const char* scene, const Method& method, const Model& model, const S& start,
                     const S& exact, lab::Table& errors, bool& as_declared) {
    if constexpr (!takes<Method, Model>(S{})) {
        return "refused";
    } else {
        std::vector<double> h, error;
        for (const int steps : {64, 128, 256, 512}) {
            h.push_back(seconds / steps);
            error.push_back(distance(run(method, model, start, h.back(), steps), exact));
            errors.row({std::string(method.name), std::string(scene), h.back(), error.back()});
        }
        const double order = measured_order(h, error);
        // The error is C hᵖ (1 + c h) with c of a few 1/s: for h of 0.01 s the slope is off by a
        // few hundredths.
        if constexpr (requires { Method::order; })
            as_declared = as_declared && std::fabs(order - Method::order) < 0.1;
        else
            as_declared = as_declared && std::fabs(order) < 1e-9 && error.back() > 1;
        return rounded(order);
    }
}

void convergence(lab::Findings& out) {
    const Spring spring(1.0);
    const DampedSpring damped(1.0, 0.3);
    const Pendulum pendulum(1.0);
    const double terminal = 4, g = 9.81, angle = 2;
    const Scene fall{Projectile(-g), Drag<double>::from_terminal_speed(terminal, g)};
    const Decay decay(-1.0);
    const State<double> swing{0, 1.0, 0.3}, tilted{0, angle, 0.0}, rest{0, 0.0, 0.0};
    const FirstOrder<double> one{0, 1.0};

    std::printf("  %-32s %8s %8s %8s %8s %8s\n", "the error falls with h to the power", "spring",
                "damped", "pendulum", "fall", "decay");
    auto& table = out.table("orders.tsv", {"method", "spring", "damped spring", "pendulum",
                                           "fall with drag", "decay", "converges"});
    auto& errors = out.table("errors.tsv", {"method", "scene", "h", "error"});
    bool every = true, fails = false;
    for_each([&](const auto& method) {
        bool good = true;
        const std::vector<std::string> cell{
            order_on("spring", method, spring, swing, spring.exact(swing, seconds), errors, good),
            order_on("damped", method, damped, swing, damped.exact(swing, seconds), errors, good),
            order_on("pendulum", method, pendulum, tilted, swung(pendulum, angle, seconds), errors,
                     good),
            order_on("fall", method, fall, rest, fallen(terminal, g, seconds), errors, good),
            order_on("decay", method, decay, one, decay.exact(one, seconds), errors, good)};
        const bool converges = requires {
            method.order;
        };
        if (converges)
            every = every && good;
        else
            fails = good;
        std::printf("  %-32s %8s %8s %8s %8s %8s\n", method.name, cell[0].c_str(), cell[1].c_str(),
                    cell[2].c_str(), cell[3].c_str(), cell[4].c_str());
        table.row({std::string(method.name), cell[0], cell[1], cell[2], cell[3], cell[4],
                   std::string(converges ? "yes" : "no")});
    });
    out.check("converges", every,
              "every method converges on every scene it takes, with the order it declares");
    out.check("always_42_fails", fails, "the answer 42 has an error that no step makes smaller");
}

constexpr int many = 20000;  // steps

// Does the answer leave every bound? A swing of size 1 or a decay may reach a few times that on its
// way; what grows by a thousandth a step is past 10⁶ after as many steps.
template <class Method, class Model, class S>
std::string bounded(const Method& method, const Model& model, const S& start, double h) {
    if constexpr (!takes<Method, Model>(S{})) {
        return "refused";
    } else {
        double most = 0;
        run(method, model, start, h, many, [&](const S& s) {
            const double size = distance(s, S{});
            most = std::isfinite(size) ? std::max(most, size) : 1e300;
        });
        return most < 1e4 ? "bounded" : "grows";
    }
}

void boundedness(lab::Findings& out) {
    std::printf("\n  %-32s %9s %9s %9s %9s\n", "", "swing .5", "swing 2.5", "damped2.5",
                "decay -10");
    auto& table = out.table("bounded.tsv", {"method", "swing, ωh = 0.5", "swing, ωh = 2.5",
                                            "the same, ζ = 0.5", "decay, hλ = −10"});
    const State<double> swing{0, 1.0, 0.0};
    const FirstOrder<double> one{0, 1.0};
    out.number("bounded_steps", many, "",
               "steps of each run that is asked whether it stays bounded");
    std::string holds;
    for_each([&](const auto& method) {
        const std::string cell[] = {bounded(method, Spring(1.0), swing, 0.5),
                                    bounded(method, Spring(1.0), swing, 2.5),
                                    bounded(method, DampedSpring(1.0, 0.5), swing, 2.5),
                                    bounded(method, Decay(-1.0), one, 10)};
        std::printf("  %-32s %9s %9s %9s %9s\n", method.name, cell[0].c_str(), cell[1].c_str(),
                    cell[2].c_str(), cell[3].c_str());
        table.row({std::string(method.name), cell[0], cell[1], cell[2], cell[3]});
        if (std::none_of(std::begin(cell), std::end(cell),
                         [](const auto& c) { return c == "grows"; }))
            holds += std::string(method.name) + "; ";
    });
    out.check(
        "stable_everywhere", holds == "implicit Euler; implicit midpoint; BDF2; always 42; ",
        "only implicit Euler, implicit midpoint, BDF2 and the answer 42 stay bounded on all four");
}

// After one swing at ωh = 0.5: how much of its size is left, or how much it has gained.
void accuracy(lab::Findings& out) {
    const double h = 0.5;
    const int steps = 13;  // 2π/0.5 and a little more
    const auto size = [&](const auto& method) {
        const State<double> end = run(method, Spring(1.0), State{0, 1.0, 0.0}, h, steps);
        return std::hypot(end.x, end.v);
    };
    out.number("swing_wh", h, "", "omega h of a swing stepped once round");
    out.number("swing_implicit", 100 * size(implicit_euler), "%",
               "what implicit Euler leaves of a swing");
    out.number("swing_explicit", size(explicit_euler), "", "what explicit Euler makes of a swing");
    out.check("stable_not_accurate", size(implicit_euler) < 0.3,
              "implicit Euler, which is stable, loses most of the first swing at omega h = 0.5");
}

}  // namespace

void definitions(const Settings&, lab::Findings& out) {
    out.section("Does it converge, does it stay bounded?");
    convergence(out);
    boundedness(out);
    accuracy(out);
}
