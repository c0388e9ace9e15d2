#include "top_step.hpp"

#include "property_eigen.hpp"

// All turns as one quaternion: where the two kicks nearly cancel, their roundoff is left.
static std::array<Vector3d, 2> by_quaternion(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    const Vector3d kick(0, 0, -mgl * h / 2);
    L += kick.cross(up);
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (const auto& [i, time] : {std::pair{0, h / 2}, {1, h / 2}, {2, h}, {1, h / 2}, {0, h / 2}})
        turn = Eigen::AngleAxisd(-(turn * L)[i] * time / inertia[i], Vector3d::Unit(i)) * turn;
    up = turn * up;
    return {turn * L + kick.cross(up), up};
}
EXERCISE_BESIDE(top_step, 2e-12, by_quaternion);

namespace {

struct Top {
    Vector3d inertia;
    double mgl;
    Vector3d L, up;
    double h;

    Top after(double step) const {
        REQUIRE(is_of_a_body(inertia));
        const auto [L2, up2] = learner(inertia, mgl, L, up, step);
        return {inertia, mgl, L2, up2, h};
    }
    Top after() const { return after(h); }
    double energy() const { return L.dot(L.cwiseQuotient(inertia)) / 2 + mgl * up.z(); }
    // All that L could be, by its spin or by its fall.
    double size() const { return L.norm() + std::sqrt(std::fabs(mgl) * inertia.maxCoeff()) + std::fabs(h * mgl); }
};

// All that the exercise allows, from 1e-5 to 1e3: draw_moments reaches from 0.004 to 200.
Vector3d draw_inertia(Draw& draw) { return draw.log(0.0025, 5) * draw_moments(draw, 5); }

// `angle` is about what the top turns by in the step, `fall` how strong gravity is: one where it
// changes the spin as fast as the top turns.
Top draw_top(Draw& draw, double angle, double fall) {
    const double speed = draw.log(0.1, 50);
    Top top{draw_inertia(draw), 0, {}, draw_direction(draw), draw.sign() * angle / speed};
    top.L = top.inertia.cwiseProduct(speed * draw_direction(draw));
    top.mgl = draw.sign() * fall * top.inertia.minCoeff() * speed * speed;
    return top;
}

// Steps that are good, and steps that are far too long. Every fifth top has no spin yet.
Top draw_any(Draw& draw, int i) {
    const double angle = i % 2 == 0 ? draw.log(0.1, 1) : draw.log(1, 1000);
    Top top = draw_top(draw, angle, draw.log(0.1, 1));
    if (i % 5 == 4) top.L.setZero();
    return top;
}

// Let go without any spin, or with hardly any: at most a hundredth of what gravity gives to it in
// the step. With the least of the moments, h^2 mgl/I is `turn`.
Top draw_let_go(Draw& draw, int i, double turn) {
    const double rate = draw.log(0.1, 50);
    Top top{draw_inertia(draw), 0, Vector3d::Zero(), draw_direction(draw), draw.sign() * std::sqrt(turn) / rate};
    top.mgl = draw.sign() * top.inertia.minCoeff() * rate * rate;
    const double hardly = draw.log(1e-9, 1e-2) * std::fabs(top.h * top.mgl);
    if (i % 2 == 1) top.L = hardly * draw_direction(draw);
    return top;
}

// Of clearly different moments, in no order, with gravity and spin alike; or let go without spin.
Top draw_dance(Draw& draw, bool let_go) {
    Vector3d moments(draw.real(0.62, 0.7), draw.real(0.9, 1.1), draw.real(1.3, 1.5));
    std::swap(moments[0], moments[draw.integer(0, 2)]);
    std::swap(moments[1], moments[draw.integer(1, 2)]);
    const double size = draw.log(0.01, 100);
    Vector3d L = size * moments.cwiseProduct(draw.real(1, 1.5) * draw_direction(draw));
    if (let_go) L.setZero();
    return {size * moments, draw.sign() * draw.real(0.5, 1) * size, L, draw_direction(draw), 0};
}

}  // namespace

// Up to the energy of a long dance a few digits will do: where mistakes answer alike, single
// precision should not be taken for one of them.
PROPERTY("a step of zero changes nothing; a top that rests upright, or hangs at rest, stays so") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Top top = draw_any(draw, i), same = top.after(0);
        REQUIRE(close(same.L, top.L, 1e-5));
        REQUIRE(close(same.up, top.up, 1e-5));
        Top still = draw_any(draw, i);
        still.L.setZero();
        still.up = draw.sign() * Vector3d::UnitZ();
        REQUIRE(still.after().L.norm() <= 1e-9 * still.size());
        REQUIRE(close(still.after().up, still.up, 1e-5));
    }
}

// Said without a rotation: in the world the top turns forwards, so in the top's axes up turns
// backwards.
PROPERTY("without gravity, a spin about one axis stays, and up turns about it, the right way") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        Top top = draw_top(draw, draw.log(0.1, 3), 0);
        const Vector3d axis = Vector3d::Unit(i % 3);
        const double speed = draw.sign() * top.L.norm() / top.inertia[i % 3];
        top.L = speed * top.inertia[i % 3] * axis;
        const Vector3d along = axis.dot(top.up) * axis, across = top.up - along;
        const double angle = speed * top.h;
        const Vector3d up = along + std::cos(angle) * across + std::sin(angle) * across.cross(axis);
        REQUIRE(close(top.after().L, top.L, 1e-5));
        REQUIRE(close(top.after().up, up, 0, 3e-5));
    }
}

// G = |h mgl| + |L| is more than L ever gets, and t = |h| G / I, for the least I. In the mean over
// the step L is 0.51 G at most, so the turns about the three axes add up to 0.51 sqrt(3) t < 0.9 t.
// They change what L gains by less than t G, and what up gains by less than t^2, in any order of
// the parts that reads the same from both ends, and in the exact fall.
PROPERTY("a tilted top that is let go begins to fall: gravity gives it L, and L moves up") {
    Draw draw;
    for (int i = 0; i < 40; ++i) {
        const Top top = draw_let_go(draw, i, draw.log(0.01, 0.1)), next = top.after();
        const Vector3d given = top.h * top.mgl * top.up.cross(Vector3d::UnitZ());
        const Vector3d mean = (top.L + given / 2).cwiseQuotient(top.inertia);
        const double most = std::fabs(top.h * top.mgl) + top.L.norm();
        const double t = std::fabs(top.h) * most / top.inertia.minCoeff();
        REQUIRE(close(next.L, Vector3d(top.L + given), 0, t * most));
        REQUIRE(close(next.up, Vector3d(top.up + top.h * top.up.cross(mean)), 0, t * t));
    }
}

PROPERTY("the energy of a long dance stays within a twentieth: it oscillates and does not drift") {
    Draw draw;
    for (int i = 0; i < 3; ++i) {
        const Top begin = draw_dance(draw, i == 2);
        const double size = begin.L.dot(begin.L.cwiseQuotient(begin.inertia)) / 2 + std::fabs(begin.mgl);
        Top top = begin;
        for (int j = 0; j < 400; ++j) {
            top = top.after(0.1);
            REQUIRE(close(top.energy(), begin.energy(), 0, 0.05 * size));
        }
    }
}

// Roundoff of an angle of a thousand radians is 1e-13.
PROPERTY("what stays and what comes back does so to eleven digits") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Top top = draw_any(draw, i), next = top.after();
        REQUIRE(close(next.up.norm(), 1, 1e-13));
        REQUIRE(close(next.L.dot(next.up), top.L.dot(top.up), 0, 1e-11 * top.size()));
        const Top tame = draw_top(draw, draw.log(0.01, 0.6), draw.log(0.1, 1));
        const Top back = tame.after().after(-tame.h);
        REQUIRE(close(back.L, tame.L, 0, 1e-11 * tame.size()));
        REQUIRE(close(back.up, tame.up, 1e-11));
    }
}

PROPERTY("it is right wherever the task allows: any angle, forth and back, hardly a spin, hardly any gravity") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 400; ++i) {
        Top top = draw_top(draw, i % 2 == 0 ? draw.real(0.1, 12) : draw.log(1e-6, 1000), draw.log(1e-6, 1));
        if (i % 3 == 0) top.L = top.inertia.cwiseProduct(top.L.norm() / top.inertia[i % 2] * Vector3d::Unit(i / 3 % 3));
        if (i % 6 == 4)
            top.L = top.L.norm() / 1.02 * (Vector3d::Unit(i / 6 % 3) + draw.log(1e-8, 1e-2) * draw_direction(draw));
        if (i % 5 == 1) top.L *= draw.any_of(0, 1, {0});
        if (i % 5 == 2) top.mgl = 0;
        if (i % 7 == 3) top.up = draw.sign() * Vector3d::Unit(i / 7 % 3);
        if (i % 7 == 5)
            top.up =
                (draw.sign() * Vector3d::Unit(i / 7 % 3) + draw.log(1e-9, 1e-3) * draw_direction(draw)).normalized();
        all &= close(top.after().up.norm(), 1, 1e-13);
    }
    REQUIRE(all);
}

PROPERTY("no top is too light or too heavy for it, no spin too slow or too fast, and no step too short or too long") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 420; ++i) {
        const double speed = draw.spread(1e-9, 1e9, i, 20), near = draw.real(900, 1000);
        const double angle = i % 21 == 20 ? near : draw.spread(1e-9, 1000, i, 21);
        Top top = draw_top(draw, 1, 1);
        const double least = draw.spread(1e-5, 100, i, 17), fall = draw.spread(1e-12, 1, i, 19);
        top.inertia = draw_rod(draw, least, 10);
        if (i % 2 == 0) std::swap(top.inertia[0], top.inertia[1 + i / 2 % 2]);
        top.h = draw.sign() * angle / speed;
        top.L = top.inertia.cwiseProduct(speed * draw_direction(draw));
        top.mgl = draw.sign() * fall * least * speed * speed;
        all &= close(top.after().up.norm(), 1, 1e-13);
    }
    REQUIRE(all);
}
