// What the words mean: does a method converge, how accurate is it, is it stable?

#include <algorithm>
#include <cstdio>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/elliptic.hpp>
#include <timestep/scene.hpp>

#include "any_method.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

struct Always42 {
    static constexpr const char* name = "always 42";
    static constexpr bool takes_damping = true;

    template <class Model, class X>
    State<X> step(const Model&, const State<X>& state1, real_of<X> h) const {
        return {state1.t + h, 42, 0};
    }
    template <class System, class Y>
    FirstOrder<Y> step(const System&, const FirstOrder<Y>& state1, real_of<Y> h) const {
        return {state1.t + h, 42};
    }
};

using Fall = Scene<Projectile<double>, Drag<double>>;

// A method on the scenes of the two tables below.
struct Tried {
    const char* name;
    int order;  // as it declares; -1 where it declares none
    AnyMethod<Spring<double>, State<double>> spring;
    AnyMethod<DampedSpring<double>, State<double>> damped;
    AnyMethod<Pendulum<double>, State<double>> pendulum;
    AnyMethod<Fall, State<double>> fall;
    AnyMethod<Decay<double>, FirstOrder<double>> decay;

    template <class Method>
    Tried(const Method& m) : name(m.name), order(-1), spring(m), damped(m), pendulum(m), fall(m), decay(m) {
        if constexpr (requires { Method::order; }) order = Method::order;
    }
};

// Every method of the course, and one that is none.
std::vector<Tried> all_tried() {
    std::vector<Tried> all;
    for_all_methods([&](const auto& method) { all.push_back(method); });
    all.push_back(Always42{});
    return all;
}

double distance(const State<double>& a, const State<double>& b) { return std::hypot(a.x - b.x, a.v - b.v); }
double distance(const FirstOrder<double>& a, const FirstOrder<double>& b) { return std::fabs(a.y - b.y); }

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
    return {t, 2 * std::asin(sine), -2 * pendulum.omega * k * m1 * sn / (dn * dn) / std::sqrt(1 - sine * sine)};
}

// A fall from rest: v = −V tanh(gt/V), with the speed V at which the drag holds the weight.
State<double> fallen(double terminal, double g, double t) {
    const double u = g * t / terminal;
    return {t, -terminal * terminal / g * std::log(std::cosh(u)), -terminal * std::tanh(u)};
}

constexpr double seconds = 2;

// How fast the error at the end falls with the step. The compiler refuses a scene that the method
// does not take.
template <class Model, class S>
std::string order_on(const char* scene, const AnyMethod<Model, S>& method, int declared, const Model& model,
                     const S& start, const S& exact, lab::Table& errors, bool& as_declared) {
    if (!method.takes_force()) return "refused";
    std::vector<double> h, error;
    for (const int steps : {64, 128, 256, 512}) {
        h.push_back(seconds / steps);
        error.push_back(distance(run(method, model, start, h.back(), steps), exact));
        errors.row({std::string(method.name), std::string(scene), h.back(), error.back()});
    }
    const double order = measured_order(h, error);
    // The error is C hᵖ (1 + c h) with c of a few 1/s: for h of 0.01 s the slope is off by a
    // few hundredths.
    if (declared >= 0)
        as_declared = as_declared && std::fabs(order - declared) < 0.1;
    else
        as_declared = as_declared && std::fabs(order) < 1e-9 && error.back() > 1;
    return rounded(order);
}

void convergence(lab::Findings& out) {
    const Spring spring(1.0);
    const DampedSpring damped(1.0, 0.3);
    const Pendulum pendulum(1.0);
    const double terminal = 4, g = 9.81, angle = 2;
    const Fall fall{Projectile(-g), Drag<double>::from_terminal_speed(terminal, g)};
    const Decay decay(-1.0);
    const State<double> swing{0, 1.0, 0.3}, tilted{0, angle, 0.0}, rest{0, 0.0, 0.0};
    const FirstOrder<double> one{0, 1.0};

    std::printf("  %-32s %8s %8s %8s %8s %8s\n", "the error falls with h to the power", "spring", "damped", "pendulum",
                "fall", "decay");
    auto& table = out.table("orders.tsv",
                            {"method", "spring", "damped spring", "pendulum", "fall with drag", "decay", "converges"});
    auto& errors = out.table("errors.tsv", {"method", "scene", "h", "error"});
    bool every = true, fails = false;
    for (const Tried& m : all_tried()) {
        bool good = true;
        const auto order = [&](const char* scene, const auto& method, const auto& model, const auto& start,
                               const auto& exact) {
            return order_on(scene, method, m.order, model, start, exact, errors, good);
        };
        const std::vector<std::string> cell{
            order("spring", m.spring, spring, swing, spring.exact(swing, seconds)),
            order("damped", m.damped, damped, swing, damped.exact(swing, seconds)),
            order("pendulum", m.pendulum, pendulum, tilted, swung(pendulum, angle, seconds)),
            order("fall", m.fall, fall, rest, fallen(terminal, g, seconds)),
            order("decay", m.decay, decay, one, decay.exact(one, seconds))};
        const bool converges = m.order >= 0;
        if (converges)
            every = every && good;
        else
            fails = good;
        std::printf("  %-32s %8s %8s %8s %8s %8s\n", m.name, cell[0].c_str(), cell[1].c_str(), cell[2].c_str(),
                    cell[3].c_str(), cell[4].c_str());
        table.row(
            {std::string(m.name), cell[0], cell[1], cell[2], cell[3], cell[4], std::string(converges ? "yes" : "no")});
    }
    out.check("converges", every, "every method converges on every scene it takes, with the order it declares");
    out.check("always_42_fails", fails, "the answer 42 has an error that no step makes smaller");
}

constexpr int many = 20000;  // steps

// Does the answer leave every bound? A swing of size 1 or a decay may reach a few times that on its
// way; what grows by a thousandth a step is past 10⁶ after as many steps.
template <class Model, class S>
std::string bounded(const AnyMethod<Model, S>& method, const Model& model, const S& start, double h) {
    if (!method.takes_force()) return "refused";
    double most = 0;
    run(method, model, start, h, many, [&](const S& s) {
        const double size = distance(s, S{});
        most = std::isfinite(size) ? std::max(most, size) : 1e300;
    });
    return most < 1e4 ? "bounded" : "grows";
}

void boundedness(lab::Findings& out) {
    std::printf("\n  %-32s %9s %9s %9s %9s\n", "", "swing .5", "swing 2.5", "damped2.5", "decay -10");
    auto& table = out.table("bounded.tsv", {"method", "oscillation, ωh = 0.5", "oscillation, ωh = 2.5",
                                            "the same, ζ = 0.5", "decay, hλ = −10"});
    const State<double> swing{0, 1.0, 0.0};
    const FirstOrder<double> one{0, 1.0};
    out.number("bounded_steps", many, "", "steps of each run that is asked whether it stays bounded");
    std::string holds;
    for (const Tried& m : all_tried()) {
        const std::string cell[] = {
            bounded(m.spring, Spring(1.0), swing, 0.5), bounded(m.spring, Spring(1.0), swing, 2.5),
            bounded(m.damped, DampedSpring(1.0, 0.5), swing, 2.5), bounded(m.decay, Decay(-1.0), one, 10)};
        std::printf("  %-32s %9s %9s %9s %9s\n", m.name, cell[0].c_str(), cell[1].c_str(), cell[2].c_str(),
                    cell[3].c_str());
        table.row({std::string(m.name), cell[0], cell[1], cell[2], cell[3]});
        if (std::none_of(std::begin(cell), std::end(cell), [](const auto& c) { return c == "grows"; }))
            holds += std::string(m.name) + "; ";
    }
    out.check("stable_everywhere", holds == "implicit Euler; implicit midpoint; BDF2; always 42; ",
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
    out.number("swing_wh", h, "", "omega h of an oscillation stepped for about a period");
    out.number("swing_steps", steps, "", "in so many steps");
    out.number("swing_implicit", 100 * size(implicit_euler), "%", "what implicit Euler leaves of an oscillation");
    out.check("stable_not_accurate", size(implicit_euler) < 0.3,
              "implicit Euler, which is stable, loses most of an oscillation in 13 steps, about a "
              "period, at omega h = 0.5");
}

}  // namespace

void definitions(const Settings&, lab::Findings& out) {
    out.section("Does it converge, does it stay bounded?");
    convergence(out);
    boundedness(out);
    accuracy(out);
}
