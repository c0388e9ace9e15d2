#include "leash_force.hpp"

#include "property_eigen.hpp"

EXERCISE(leash_force);

namespace {

// One leash in five has no rest length. The least stretch is still some thousand roundoffs.
struct Scene {
    explicit Scene(Draw& draw)
        : length(draw.integer(0, 4) == 0 ? 0 : draw.log(0.01, 10)),
          stretch(draw.log(1e-10, 2)),
          k(draw.log(1, 100)),
          c(draw.log(1e-3, 20)),
          outwards(draw_direction(draw)),
          x((length + stretch) * outwards) {}
    Vector3d force(const Vector3d& v) const { return learner(x, v, k, c, length); }
    // The size of the numbers that make up a force.
    double size(const Vector3d& v) const { return k * (length + stretch) + c * v.norm(); }

    double length, stretch, k, c;
    Vector3d outwards, x;
};

}  // namespace

PROPERTY("a slack leash has no force however the ball moves, nor has one of no length at all") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Scene scene(draw);
        const Vector3d v = draw_vector(draw, -5, 5);
        const Vector3d near = draw.real(0.01, 0.99) * scene.length * scene.outwards;
        const Vector3d here = Vector3d::Zero();
        REQUIRE(learner(near, v, scene.k, scene.c, scene.length).norm() == 0);
        REQUIRE(learner(here, v, scene.k, scene.c, scene.length).norm() == 0);
        REQUIRE(learner(here, v, scene.k, scene.c, 0).norm() == 0);
    }
}

// Vectors whose length is a whole number, so that every way to find it is exact; the largest
// component is a power of two, by which some ways divide.
PROPERTY("a leash that is just as long as at rest is slack, even if it is getting longer") {
    Draw draw;
    const std::array vectors{Vector3d(3, 4, 0), Vector3d(1, 2, 2), Vector3d(1, 4, 8)};
    for (int i = 0; i < 30; ++i) {
        const double unit = std::pow(2, draw.integer(-4, 2)), c = draw.log(0.1, 20);
        Vector3d x = unit * vectors[static_cast<std::size_t>(draw.integer(0, 2))];
        const double length = x.norm();
        std::swap(x[draw.integer(0, 2)], x[draw.integer(0, 2)]);
        for (int axis = 0; axis < 3; ++axis) x[axis] *= draw.sign();
        const Vector3d v = draw.real(0.1, 5) * x + x.cross(draw_vector(draw, -5, 5));
        REQUIRE(learner(x, v, draw.log(1, 100), c, length).norm() == 0);
    }
}

PROPERTY("at rest the force pulls the ball towards its owner, the stiffness times the stretch") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Scene scene(draw);
        const Vector3d rest = Vector3d::Zero();
        const Vector3d force = scene.force(rest);
        REQUIRE(force.dot(scene.x) < 0);
        REQUIRE(close(force.norm(), scene.k * scene.stretch, 0, 1e-14 * scene.size(rest)));
        REQUIRE(force.cross(scene.outwards).norm() <= 1e-14 * scene.size(rest));
        const Vector3d unstretched = learner(scene.x, rest, scene.k, scene.c, 0);
        REQUIRE(close(unstretched, -scene.k * scene.x, 1e-14));
    }
}

PROPERTY("a ball that moves across the leash feels the same force as one at rest") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Scene scene(draw);
        const Vector3d rest = Vector3d::Zero();
        const Vector3d across = scene.outwards.cross(draw_vector(draw, -5, 5));
        REQUIRE(close(scene.force(across), scene.force(rest), 0, 3e-14 * scene.size(across)));
    }
}

PROPERTY("a leash that gets longer takes energy, the damping times the square of that rate") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Scene scene(draw);
        const double rate = draw.log(0.1, 5);
        const Vector3d v = rate * scene.outwards + scene.outwards.cross(draw_vector(draw, -5, 5));
        const double power = (scene.force(v) - scene.force(Vector3d::Zero())).dot(v);
        REQUIRE(close(power, -scene.c * rate * rate, 0, 5e-14 * scene.size(v) * v.norm()));
    }
}

// The damper just takes up the spring at the rate −k stretch/c: on both sides of it.
PROPERTY("a leash that gets shorter pulls less, and one that does so fast does not push") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Scene scene(draw);
        const double part = draw.real(0.05, 0.95), limit = scene.k * scene.stretch / scene.c;
        const Vector3d slow = -part * limit * scene.outwards;
        const Vector3d fast = -(1 + part) * limit * scene.outwards;
        const Vector3d left = -(1 - part) * scene.k * scene.stretch * scene.outwards;
        REQUIRE(close(scene.force(slow), left, 0, 5e-14 * scene.size(slow)));
        REQUIRE(scene.force(fast).norm() == 0);
    }
}

// Of a spider and of a ship at its anchor; along an axis, too. In each call the answer must be the
// right one.
PROPERTY(
    "leashes of any length and any stretch, with any damper, and balls that fly any way have their "
    "force") {
    Draw draw;
    for (int i = 0; i < 600; ++i) {
        const double size = draw.log(1e-6, 1e6), length = size * draw.any_of(0, 5, {0, 1});
        // Every fifth is slack.
        const double stretch =
            i % 5 == 0 && length > 0 ? -length * draw.real(0.05, 0.9) : size * draw.log(i % 2 == 0 ? 1e-6 : 0.1, 10);
        const double k = draw.log(1e-3, 1e6), c = i % 6 == 0 ? 0 : draw.log(1e-3, 1e6);
        const Vector3d axes[] = {Vector3d::UnitX(), -Vector3d::UnitY(), Vector3d::UnitZ(), draw_direction(draw)};
        const Vector3d& outwards = axes[draw.integer(0, 3)];
        // As fast as lets the damper weigh as much as the spring, now and then in one direction
        // only.
        Vector3d v = k * stretch / (c > 0 ? c : k) * draw_vector(draw, -2, 2);
        if (draw.integer(0, 3) == 0) v = v.dot(outwards) * outwards;
        if (draw.integer(0, 3) == 0) v = v.cross(outwards);
        REQUIRE(learner((length + stretch) * outwards, v, k, c, length).dot(outwards) <= 0);
    }
}

// So fast that the damper weighs as much as the spring.
PROPERTY("no spring and no damper is too weak or too strong for it, and no leash too short or too long") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double k = draw.spread(1e-12, 1e12, i, 20), c = draw.spread(1e-12, 1e12, i, 21);
        const double size = draw.spread(1e-12, 1e12, i, 19), length = size * draw.any_of(0, 5, {0, 1});
        const double stretch = size * draw.log(1e-2, 10);
        const Vector3d outwards = draw_direction(draw), v = k * stretch / c * draw_vector(draw, -2, 2);
        REQUIRE(learner((length + stretch) * outwards, v, k, c, length).dot(outwards) <= 0);
    }
}
