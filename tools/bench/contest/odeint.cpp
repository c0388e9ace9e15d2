// Boost.odeint's solvers, for the forces of the scenes. Its states here are std::array: nothing is allocated, and the
// compiler sees everything.

#ifdef TIMESTEP_WITH_ODEINT

#include "peers/odeint.hpp"

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

#include "peers/peer.hpp"

namespace contest::odeint {

using timestep::State;
using namespace boost::numeric::odeint;

// Any of its steppers for ẏ = f(y), with a fixed step. (A stepper that keeps the force for the next step evaluates it
// again in each call, with the same result.)
/// [fixed]
template <class Stepper, class Model, class X>
struct Fixed {
    using Y = Flat<X>;
    Model model;
    State<X> start;

    Y begin() const {
        Y y;
        write(start, y.data());
        return y;
    }
    void advance(Y& all, double h, long steps) const {
        const auto f = [this](const Y& y, Y& dydt, double) { slope<X>(model, y.data(), dydt.data()); };
        double t = 0;
        Y y = all;  // nobody else has a pointer to the copy: it may stay in registers
        Stepper stepper;
        for (long i = 0; i < steps; ++i, t += h) stepper.do_step(f, y, t, h);
        all = y;
    }
    static const double* place(const Y& y) { return y.data(); }
};
/// [fixed]

// Its symplectic Euler moves the coordinates with the old momenta, and then the momenta at the new coordinates.
// Exchange the two and it is semi-implicit Euler: here the velocity is the coordinate, and the position the momentum.
template <class Model, class X>
struct SymplecticEuler {
    using Y = std::pair<Half<X>, Half<X>>;  // v, x
    Model model;
    State<X> start;

    Y begin() const {
        Y vx;
        write(start.v, vx.first.data());
        write(start.x, vx.second.data());
        return vx;
    }
    void advance(Y& all, double h, long steps) const {
        const auto v_dot = [this](const Half<X>& x, Half<X>& dvdt) {
            write(acceleration(model, read<X>(x.data())), dvdt.data());
        };
        const auto x_dot = [](const Half<X>& v, Half<X>& dxdt) { dxdt = v; };
        double t = 0;
        Y vx = all;
        symplectic_euler<Half<X>> stepper;
        for (long i = 0; i < steps; ++i, t += h) stepper.do_step(std::make_pair(v_dot, x_dot), vx, t, h);
        all = vx;
    }
    static const double* place(const Y& vx) { return vx.second.data(); }
};

// It keeps the force at the end of a step for the next one: it asks once a step, ours asks twice.
template <class Model, class X>
struct VelocityVerlet {
    using Y = std::pair<Half<X>, Half<X>>;  // x, v
    Model model;
    State<X> start;

    Y begin() const {
        Y xv;
        write(start.x, xv.first.data());
        write(start.v, xv.second.data());
        return xv;
    }
    void advance(Y& all, double h, long steps) const {
        const auto a = [this](const Half<X>& x, const Half<X>&, Half<X>& dvdt, double) {
            write(acceleration(model, read<X>(x.data())), dvdt.data());
        };
        double t = 0;
        Y xv = all;
        velocity_verlet<Half<X>> stepper;
        for (long i = 0; i < steps; ++i, t += h) stepper.do_step(a, xv, t, h);
        all = xv;
    }
    static const double* place(const Y& xv) { return xv.first.data(); }
};

// Any of these as a solver.
template <class Way>
class Marching : public Solver {
public:
    explicit Marching(const Way& way) : Solver(false), way_(way) {}

    void restart(long steps) override { h_ = duration / double(steps), y_ = way_.begin(); }
    void advance(long n) override { way_.advance(y_, h_, n); }
    const double* place() const override { return Way::place(y_); }

private:
    Way way_;
    double h_ = 0;
    typename Way::Y y_ = {};
};

// Steps as long as the tolerance lets it, cut where a mark is near.
template <class Model, class X>
class Adaptive : public Solver {
public:
    Adaptive(const Model& model, const State<X>& start, double size)
        : Solver(true), model_(model), start_(start), size_(size) {}

    void restart(long steps) override {
        allowed_ = tolerance(steps) * size_;
        wish_ = duration / double(steps);
        t_ = 0, mark_ = 0, taken_ = 0;
        write(start_, y_.data());
    }
    void advance(long n) override {
        const auto f = [this](const Flat<X>& y, Flat<X>& dydt, double) { slope<X>(model_, y.data(), dydt.data()); };
        auto stepper = make_controlled<runge_kutta_dopri5<Flat<X>>>(allowed_, 0.0);
        Flat<X> y = y_;
        double t = t_, wish = wish_;
        long taken = taken_;
        for (const int last = mark_ + int(n); mark_ < last;) {
            const double end = duration * ++mark_ / marks;
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
        }
        y_ = y, t_ = t, wish_ = wish, taken_ = taken;
    }
    const double* place() const override { return y_.data(); }
    long steps_taken() const override { return taken_; }

private:
    Model model_;
    State<X> start_;
    double size_, allowed_ = 0, t_ = 0, wish_ = 0;
    int mark_ = 0;
    long taken_ = 0;
    Flat<X> y_ = {};
};

template <class Model, class X>
Methods methods(const Model& model, const State<X>& start, double size) {
    Methods all;
    const auto add = [&](const char* name, Solver* solver) { all.push_back({name, std::unique_ptr<Solver>(solver)}); };
    using Dopri5 = runge_kutta_dopri5<Flat<X>>;
    add("explicit Euler", new Marching<Fixed<euler<Flat<X>>, Model, X>>({model, start}));
    if constexpr (timestep::PositionForce<Model, X>) {
        add("semi-implicit Euler", new Marching<SymplecticEuler<Model, X>>({model, start}));
        add("velocity Verlet", new Marching<VelocityVerlet<Model, X>>({model, start}));
    }
    add("Runge-Kutta 4", new Marching<Fixed<runge_kutta4<Flat<X>>, Model, X>>({model, start}));
    add("Dormand-Prince 5", new Marching<Fixed<Dopri5, Model, X>>({model, start}));
    add("Dormand-Prince 5, adaptive", new Adaptive<Model, X>(model, start, size));
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
