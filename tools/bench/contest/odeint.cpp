// Boost.odeint's solvers, for the forces of the scenes. Its states here are std::array: nothing is allocated, and the
// compiler sees everything.

#ifdef TIMESTEP_WITH_ODEINT

#include <algorithm>
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

#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/scene.hpp>

#include "peers.hpp"

namespace contest::odeint {

using timestep::State;
using namespace boost::numeric::odeint;

// The forms in which its steppers take a problem: the state Y, and the functions of it that `system` returns.

// ẏ = f(y). (A stepper that keeps the force for the next step evaluates it again in each call, with the same result.)
template <class Stepper_, class X>
struct FirstOrderForm {
    using Stepper = Stepper_;
    using Y = Flat<X>;

    static void begin(Y& y, const State<X>& start) { write(start, y.data()); }
    template <class Model>
    static auto system(const Model& model) {
        return [&model](const Y& y, Y& dydt, double) { slope<X>(model, y.data(), dydt.data()); };
    }
    static const double* place(const Y& y) { return y.data(); }
};

// Its symplectic Euler moves the coordinates with the old momenta, and then the momenta at the new coordinates.
// Exchange the two and it is semi-implicit Euler: here the velocity is the coordinate, and the position the momentum.
template <class X>
struct SymplecticEulerForm {
    using Stepper = symplectic_euler<Half<X>>;
    using Y = std::pair<Half<X>, Half<X>>;  // v, x

    static void begin(Y& vx, const State<X>& start) {
        write(start.v, vx.first.data()), write(start.x, vx.second.data());
    }
    template <class Model>
    static auto system(const Model& model) {
        const auto v_dot = [&model](const Half<X>& x, Half<X>& dvdt) {
            write(acceleration(model, read<X>(x.data())), dvdt.data());
        };
        return std::make_pair(v_dot, [](const Half<X>& v, Half<X>& dxdt) { dxdt = v; });
    }
    static const double* place(const Y& vx) { return vx.second.data(); }
};

// It keeps the force at the end of a step for the next one: it asks once a step, ours asks twice.
template <class X>
struct VelocityVerletForm {
    using Stepper = velocity_verlet<Half<X>>;
    using Y = std::pair<Half<X>, Half<X>>;  // x, v

    static void begin(Y& xv, const State<X>& start) {
        write(start.x, xv.first.data()), write(start.v, xv.second.data());
    }
    template <class Model>
    static auto system(const Model& model) {
        return [&model](const Half<X>& x, const Half<X>&, Half<X>& dvdt, double) {
            write(acceleration(model, read<X>(x.data())), dvdt.data());
        };
    }
    static const double* place(const Y& xv) { return xv.first.data(); }
};

// With a fixed step.
template <class Form, class Model, class X>
class Fixed : public Solver {
public:
    Fixed(const Model& model, const State<X>& start) : model_(model), start_(start) {}

    void restart(long steps) override { h_ = duration / double(steps), Form::begin(y_, start_); }
    void advance(long n) override {
        const auto f = Form::system(model_);
        double t = 0;
        typename Form::Y y = y_;  // nobody else has a pointer to the copy: it may stay in registers
        typename Form::Stepper stepper;
        for (long i = 0; i < n; ++i, t += h_) stepper.do_step(f, y, t, h_);
        y_ = y;
    }
    const double* numbers() const override { return Form::place(y_); }

private:
    Model model_;
    State<X> start_;
    double h_ = 0;
    typename Form::Y y_ = {};
};

// Steps as long as the tolerance lets it, cut where a mark is near.
template <class Model, class X>
class Adaptive : public AdaptiveSolver {
    using Dopri5 = runge_kutta_dopri5<Flat<X>>;

public:
    Adaptive(const Model& model, const State<X>& start, double size) : model_(model), start_(start), size_(size) {}

    void begin(long steps) override {
        stepper_ = make_controlled<Dopri5>(tolerance(steps) * size_, 0.0);
        wish_ = duration / double(steps);
        t_ = 0, taken_ = 0;
        write(start_, y_.data());
    }
    void go_to(double end) override {
        const auto f = [this](const Flat<X>& y, Flat<X>& dydt, double) { slope<X>(model_, y.data(), dydt.data()); };
        Flat<X> y = y_;
        double t = t_, wish = wish_;
        while (t < end) {
            const bool cut = end - t < wish;
            double h = cut ? end - t : wish;
            if (stepper_.try_step(f, y, t, h) == fail) {
                wish = h;
                continue;
            }
            ++taken_;
            if (cut) t = end;
            wish = cut ? std::max(wish, h) : h;  // a cut step says nothing against a longer one
        }
        y_ = y, t_ = t, wish_ = wish;
    }
    const double* numbers() const override { return y_.data(); }
    long steps_taken() const override { return taken_; }

private:
    Model model_;
    State<X> start_;
    double size_, t_ = 0, wish_ = 0;
    long taken_ = 0;
    Flat<X> y_ = {};
    decltype(make_controlled<Dopri5>(0.0, 0.0)) stepper_;
};

template <class Model, class X>
Methods methods(const Model& model, const State<X>& start, double size) {
    Methods all;
    const auto fixed = [&]<class Form>(const char* name, Form) {
        all.push_back({name, std::make_unique<Fixed<Form, Model, X>>(model, start)});
    };
    fixed("explicit Euler", FirstOrderForm<euler<Flat<X>>, X>());
    if constexpr (timestep::PositionForce<Model, X>) {
        fixed("semi-implicit Euler", SymplecticEulerForm<X>());
        fixed("velocity Verlet", VelocityVerletForm<X>());
    }
    fixed("Runge-Kutta 4", FirstOrderForm<runge_kutta4<Flat<X>>, X>());
    fixed("Dormand-Prince 5", FirstOrderForm<runge_kutta_dopri5<Flat<X>>, X>());
    all.push_back({"Dormand-Prince 5, adaptive", std::make_unique<Adaptive<Model, X>>(model, start, size)});
    return all;
}

template <class Model, class S>
void enter(Scene& scene, const Model& model, const S& start) {
    contest::enter<std::decay_t<decltype(start.x)>>(scene, "Boost.odeint", model,
                                                    [&](const auto& m) { return methods(m, start, scene.size); });
}

// They go into this file alone, whose headers are dear to compile.
using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using ThroughAir = timestep::Scene<timestep::Projectile<Vector2>, timestep::Drag<double>>;
template void enter(Scene&, const timestep::Spring<double>&, const State<double>&);
template void enter(Scene&, const timestep::DampedSpring<double>&, const State<double>&);
template void enter(Scene&, const timestep::Spring<double>&, const State<Vector3>&);
template void enter(Scene&, const timestep::CoupledSprings<double, 2>&, const State<Vector2>&);
template void enter(Scene&, const timestep::Projectile<Vector2>&, const State<Vector2>&);
template void enter(Scene&, const ThroughAir&, const State<Vector2>&);

}  // namespace contest::odeint

#endif
