#pragma once
// Boost.odeint. Its states here are std::array: no memory is asked for, the compiler sees all.

#include <utility>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_controlled.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/symplectic_euler.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>

#include "peer.hpp"

namespace contest::odeint {

using namespace boost::numeric::odeint;

// Any of its steppers for ẏ = f(y), with a fixed step.
/// [fixed]
template <class Stepper, class Model, class X>
struct Fixed {
    static constexpr bool adaptive = false;
    Model model;
    timestep::State<X> start;

    template <class Observe>
    long run(long steps, const Observe& observe) const {
        const auto f = [this](const Flat<X>& y, Flat<X>& dydt, double) {
            slope<X>(model, y.data(), dydt.data());
        };
        const double h = duration / double(steps);
        double t = 0;
        Flat<X> y;
        write(start, y.data());
        Stepper stepper;
        for (long i = 0; i < steps; ++i, t += h) {
            stepper.do_step(f, y, t, h);
            observe(y.data());
        }
        sink = y[0];
        return steps;
    }
};
/// [fixed]

// Its symplectic Euler moves the coordinates with the old momenta, and then the momenta at the new
// coordinates. Semi-implicit Euler is that with the parts exchanged: here the velocity is the
// coordinate, and the position the momentum.
template <class Model, class X>
struct SymplecticEuler {
    static constexpr bool adaptive = false;
    Model model;
    timestep::State<X> start;

    template <class Observe>
    long run(long steps, const Observe& observe) const {
        const auto v_dot = [this](const Half<X>& x, Half<X>& dvdt) {
            write(acceleration(model, read<X>(x.data())), dvdt.data());
        };
        const auto x_dot = [](const Half<X>& v, Half<X>& dxdt) { dxdt = v; };
        const double h = duration / double(steps);
        double t = 0;
        std::pair<Half<X>, Half<X>> vx;
        write(start.v, vx.first.data());
        write(start.x, vx.second.data());
        symplectic_euler<Half<X>> stepper;
        for (long i = 0; i < steps; ++i, t += h) {
            stepper.do_step(std::make_pair(v_dot, x_dot), vx, t, h);
            observe(vx.second.data());
        }
        sink = vx.second[0];
        return steps;
    }
};

// It keeps the force at the end of a step for the next one: it asks once a step, ours asks twice.
template <class Model, class X>
struct VelocityVerlet {
    static constexpr bool adaptive = false;
    Model model;
    timestep::State<X> start;

    template <class Observe>
    long run(long steps, const Observe& observe) const {
        const auto a = [this](const Half<X>& x, const Half<X>&, Half<X>& dvdt, double) {
            write(acceleration(model, read<X>(x.data())), dvdt.data());
        };
        const double h = duration / double(steps);
        double t = 0;
        std::pair<Half<X>, Half<X>> xv;
        write(start.x, xv.first.data());
        write(start.v, xv.second.data());
        velocity_verlet<Half<X>> stepper;
        for (long i = 0; i < steps; ++i, t += h) {
            stepper.do_step(a, xv, t, h);
            observe(xv.first.data());
        }
        sink = xv.first[0];
        return steps;
    }
};

// Steps as long as the tolerance lets it, cut where a mark is near.
template <class Model, class X>
struct Adaptive {
    static constexpr bool adaptive = true;
    Model model;
    timestep::State<X> start;
    double size;

    template <class Observe>
    long run(long steps, const Observe& observe) const {
        const auto f = [this](const Flat<X>& y, Flat<X>& dydt, double) {
            slope<X>(model, y.data(), dydt.data());
        };
        auto stepper = make_controlled<runge_kutta_dopri5<Flat<X>>>(tolerance(steps) * size, 0.0);
        Flat<X> y;
        write(start, y.data());
        double t = 0, wish = duration / double(steps);
        long taken = 0;
        for (int mark = 1; mark <= marks; ++mark) {
            const double end = duration * mark / marks;
            while (t < end) {
                const bool cut = end - t < wish;
                double h = cut ? end - t : wish;
                if (stepper.try_step(f, y, t, h) == fail) {
                    wish = h;
                    continue;
                }
                ++taken;
                if (cut) t = end;
                wish = cut ? std::max(wish, h) : h;  // a cut step says nothing against a longer one
            }
            observe(y.data());
        }
        sink = y[0];
        return taken;
    }
};

template <class Model, class X>
void enter(Scene& scene, const Model& model, const timestep::State<X>& start) {
    const auto add = [&](const std::string& method, const auto& set_up) {
        scene.entries.push_back(peer<X>(method, "Boost.odeint", model, set_up));
    };
    const auto fixed = [&]<class Stepper>(const std::string& method, const Stepper&) {
        add(method, [start](const auto& m) {
            return Fixed<Stepper, std::decay_t<decltype(m)>, X>{m, start};
        });
    };
    fixed("explicit Euler", euler<Flat<X>>());
    if constexpr (timestep::PositionForce<Model, X>) {
        add("semi-implicit Euler", [start](const auto& m) {
            return SymplecticEuler<std::decay_t<decltype(m)>, X>{m, start};
        });
        add("velocity Verlet", [start](const auto& m) {
            return VelocityVerlet<std::decay_t<decltype(m)>, X>{m, start};
        });
    }
    fixed("Runge-Kutta 4", runge_kutta4<Flat<X>>());
    fixed("Dormand-Prince 5", runge_kutta_dopri5<Flat<X>>());
    add("Dormand-Prince 5, adaptive", [start, size = scene.size](const auto& m) {
        return Adaptive<std::decay_t<decltype(m)>, X>{m, start, size};
    });
}

}  // namespace contest::odeint
