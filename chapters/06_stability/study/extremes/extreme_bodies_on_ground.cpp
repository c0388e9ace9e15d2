// The scenes of a ball on the ground.

#include <timestep/rigid/body_scene.hpp>

#include "extremes.hpp"

namespace extremes {
namespace {

// A ball on the ground, as run() takes it: the body is the model.
template <class Real>
struct Rolling {
    using Scalar = Real;
    Real t;
    BodyState<Real> motion;
};
template <class Real>
bool is_finite(const Rolling<Real>& s) {
    const BodyState<Real>& m = s.motion;
    return is_finite(m.turning) && timestep::is_finite(m.x) && timestep::is_finite(m.v);
}
template <class Real>
struct Ball {
    UniformInertia<Real> inertia;
    Real mass, radius;
};
template <class Real>
struct OnGround {
    static constexpr const char* name = "a ball on the ground";
    std::function<void(const Ball<Real>&, BodyState<Real>&, Real)> change;  // a step of one of the scenes
    Rolling<Real> step(const Ball<Real>& ball, const Rolling<Real>& s, Real h) const {
        BodyState<Real> m = s.motion;
        change(ball, m, h);
        return {m.turning.t, m};
    }
};
template <class... Terms>
auto on(const BodyScene<Terms...>& scene) {
    return [scene](const auto& ball, auto& motion, auto h) { scene.step(ball, motion, h); };
}

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
    const auto add = [&](const char* name, const OnGround<Real>& method, Real mass, Real radius, const S& start,
                         long steps, const Theory& theory, const Size<S>& size) {
        const Make<Ball<Real>> make = [&] {
            checked(start.motion);
            return checked(Ball<Real>{UniformInertia<Real>(Real(0.4) * r * r), mass, radius});
        };
        cells.push_back(cell(name, method, make, start, h, steps, theory, size));
    };
    const OnGround<Real> lawn{
        on(BodyScene(Weight<Real>(g), Ground<Real>(Real(0.5)), RollingResistance<Real>(Real(0.01))))};
    const auto none = [](const S&) { return 0.0; };
    const S good = from(1, 0, r);
    for (const auto& [name, bad] : {std::pair{"mass 0", Real(0)},
                                    {"mass < 0", Real(-1)},
                                    {"mass NaN", nan},
                                    {"mass subnormal", std::numeric_limits<Real>::denorm_min()}})
        add(name, lawn, bad, r, good, 10, refused("mass"), none);
    for (const auto& [name, bad] : {std::pair{"radius 0", Real(0)},
                                    {"radius NaN", nan},
                                    {"radius tiny", tiny<Real>},
                                    {"radius huge", huge<Real>}})
        add(name, lawn, 1, bad, good, 10, refused("radius"), none);
    add("ball's speed huge", lawn, 1, r, from(huge<Real>, 0, r), 10, refused("speed"), none);
    add("ball's spin huge", lawn, 1, r, from(0, huge<Real>, r), 10, refused("speed"), none);
    add("ball's height NaN", lawn, 1, r, from(1, 0, nan), 10, refused("motion"), none);

    // Too fast for friction to be felt: v stays, and friction turns the ball, by 5/2 μ g t/r.
    const OnGround<Real> ground{on(BodyScene(Weight<Real>(g), Ground<Real>(Real(0.5))))};
    add("ball's speed 1e150", ground, 1, r, from(fast, 0, r), 100, {Outcome::exact, 100 * 8 * eps<Real>},
        [=](const S& s) {
            const double right = 2.5 * 0.5 * g * double(s.t) / r;
            const double spin = double(s.motion.turning.omega.y());
            return std::fabs(double(s.motion.v.x() / fast - 1)) + std::fabs(spin - right) / std::fmax(right, 1);
        });
    // So rough a ground that sliding ends in a step, at 5/7 of the speed, or at 2/7 of the spin.
    const OnGround<Real> rough{on(BodyScene(Weight<Real>(g), Ground<Real>(huge<Real>)))};
    const auto rolls = [=](Real v) {
        return [=](const S& s) {
            const double x = double(s.motion.v.x() / v);
            const double y = double(r * s.motion.turning.omega.y() / v);
            return s.t > 0 ? std::fabs(x - 1) + std::fabs(y - 1) : 0;
        };
    };
    add("ball's speed 1e150, friction huge", rough, 1, r, from(fast, 0, r), 100, {Outcome::exact, 100 * 16 * eps<Real>},
        rolls(5 * fast / 7));
    add("ball's spin 1e150, friction huge", rough, 1, r, from(0, fast, r), 100, {Outcome::exact, 100 * 16 * eps<Real>},
        rolls(2 * r * fast / 7));
}

}  // namespace

std::vector<Cell> of_balls() {
    std::vector<Cell> cells;
    on_ground<double>(cells);
    on_ground<float>(cells);
    return cells;
}

}  // namespace extremes
