#pragma once
// Where a capsule truly is that falls on ice, on one end and then on its side. Nothing here takes
// steps across a contact: the three parts of its motion are computed one by one, each from the
// moment at which the one before ends.

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/free_body.hpp>
#include <timestep/rigid/plane.hpp>

namespace contest {

class SlidingCapsule {
    using V = timestep::plane::V;
    using Inertia = timestep::SymmetricInertia<double>;
    using Turning = timestep::RigidState<double>;

public:
    using Body = timestep::plane::Capsule<Inertia>;
    using BodyState = timestep::plane::BodyState;

    // `start` without a velocity and in the air. `slices`: steps of the one part that is not known
    // in closed form.
    SlidingCapsule(const Body& body, double gravity, const BodyState& start, long slices)
        : body_(body),
          gravity_(gravity),
          start_(start),
          slices_(slices),
          air_({body.inertia.across, body.inertia.across, body.inertia.along}, start.turning) {
        lands_ = crossing([&](double t) { return gap(flying(t)); }, 0);
        landed_ = on_one_end(flying(lands_));
        lies_ = crossing([&](double t) { return axis_up(sliding(t)); }, lands_);
        lying_ = on_its_side(sliding(lies_));
    }

    BodyState operator()(double t) const {
        if (t < lands_) return flying(t);
        const Turning s = t < lies_ ? sliding(t) : rolling(t);
        return {s, {0, 0, body_.radius - end(s).z()}, V::Zero()};  // nobody asks for the velocity
    }
    double lands() const { return lands_; }
    double lies() const { return lies_; }
    // The force in N by which the ice carries it after the landing: it must not pull.
    double pressure(double t) const { return pressure(sliding(t)); }

private:
    // 1. In the air: a free body that falls.
    BodyState flying(double t) const {
        const double fallen = gravity_ * t * t / 2;
        return {air_(t), start_.x - fallen * V::UnitZ(), -gravity_ * t * V::UnitZ()};
    }

    // The end that lands, seen from the centre.
    V end(const Turning& s) const { return body_.end(s.q, lower_); }
    double gap(const BodyState& m) const { return m.x.z() - std::fabs(end(m.turning).z()) - body_.radius; }
    // How the velocity of that end upwards changes with ω: by c·ω.
    V lever(const Turning& s) const { return end(s).cross(V::UnitZ()); }
    V turned_by(const Turning& s, const V& torque) const {  // I⁻¹ torque, world coordinates
        return s.q * body_.inertia.velocity(s.q.conjugate() * torque);
    }

    // One impulse upwards stops the end.
    Turning on_one_end(const BodyState& m) {
        lower_ = body_.end(m.turning.q, 0).z() < 0 ? 0 : 1;
        Turning s = m.turning;
        const V c = lever(s), kick = turned_by(s, c);
        const double speed = m.v.z() + c.dot(s.omega);
        s.omega -= speed / (1 / body_.mass + c.dot(kick)) * kick;
        return s;
    }

    // 2. One end slides without friction. The ice presses as hard as keeps that end at its height:
    // z = r − e_z, so m (g + z̈) = N with z̈ = −ω̇·c − (ω × (ω × e))_z and ω̇ = I⁻¹(N c − ω × Iω).
    double pressure(const Turning& s) const {
        const V e = end(s), c = lever(s);
        const V free = turned_by(s, -s.omega.cross(angular_momentum(body_.inertia, s)));
        const double up = -free.dot(c) - s.omega.cross(s.omega.cross(e)).z();
        return (gravity_ + up) / (1 / body_.mass + c.dot(turned_by(s, c)));
    }
    Turning sliding(double t) const {
        const timestep::FreeBody<Inertia> free(body_.inertia);
        const auto pressed = [&](double time, const auto& y) {
            const Turning s = timestep::unstacked(timestep::FirstOrder{time, y});
            auto rate = free(time, y);
            const V push = s.q.conjugate() * V(pressure(s) * lever(s));
            rate.template tail<3>() += body_.inertia.velocity(push);
            return rate;
        };
        auto s = timestep::stacked(landed_);
        const double h = (t - lands_) / double(slices_);
        for (long i = 0; i < slices_; ++i) s = orientation_scaled(timestep::runge_kutta_4.step(pressed, s, h));
        return timestep::unstacked(s);
    }
    double axis_up(const Turning& s) const { return -end(s).z(); }

    // Two impulses upwards stop both ends: what turns the axis up or down is gone.
    Turning on_its_side(Turning s) const {
        const V across = lever(s).normalized();
        s.omega -= across.dot(s.omega) * across;
        return s;
    }

    // 3. It lies, turns about the vertical and about its axis, and nothing stops it.
    Turning rolling(double t) const {
        using Turn = Eigen::AngleAxisd;
        const double since = t - lies_;
        const Turn about_vertical(lying_.omega.z() * since, V::UnitZ());
        const Turn about_axis((lying_.q.conjugate() * lying_.omega).z() * since, V::UnitZ());
        return {t, about_vertical * lying_.q * about_axis, about_vertical * lying_.omega};
    }

    // When f, above zero at `from`, first is zero.
    template <class F>
    static double crossing(const F& f, double from) {
        const double stride = 0.01;
        double before = from, after = from + stride;
        while (f(after) > 0) before = after, after += stride;
        for (int i = 0; i < 60; ++i) {
            const double middle = (before + after) / 2;
            (f(middle) > 0 ? before : after) = middle;
        }
        return after;
    }

    Body body_;
    double gravity_;
    BodyState start_;
    long slices_;
    timestep::ExactFreeBody<double> air_;
    int lower_ = 0;  // the end that lands
    double lands_, lies_;
    Turning landed_, lying_;
};

}  // namespace contest
