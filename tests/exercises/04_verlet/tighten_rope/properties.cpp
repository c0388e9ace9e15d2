#include "tighten_rope.hpp"

#include "property_eigen.hpp"

using Eigen::Vector3d;

EXERCISE(tighten_rope);

// Two ends with masses, and a rope that is too short for them, by a millionth at least; or, with
// `slack`, a loose one.
struct Ends {
    explicit Ends(Draw& draw, bool slack = false)
        : a(draw_vector(draw, -5, 5)),
          b(a + draw.real(1, 5) * draw_direction(draw)),
          wa(draw.log(0.02, 5)),
          wb(draw.log(0.02, 5)),
          length((b - a).norm() * (slack ? 1 + draw.log(1e-6, 2) : 1 - draw.log(1e-6, 0.8))) {}

    Vector3d a, b;
    double wa, wb, length;
};

PROPERTY("a loose rope moves nothing") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Ends ends(draw, true);
        const auto [a, b] = learner(ends.a, ends.b, ends.wa, ends.wb, ends.length);
        REQUIRE((a == ends.a && b == ends.b));
    }
}

// Roundoff here and below: positions of at most 15 metres.
PROPERTY("a rope that was too long has its length again") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Ends ends(draw);
        const auto [a, b] = learner(ends.a, ends.b, ends.wa, ends.wb, ends.length);
        REQUIRE(close((b - a).norm(), ends.length, 0, 1e-13));
    }
}

PROPERTY("an end that is held stays, and the rope has its length all the same") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Ends ends(draw);
        const auto [wall, player] = learner(ends.a, ends.b, 0, ends.wb, ends.length);
        REQUIRE((wall - ends.a).norm() <= 1e-13);
        REQUIRE(close((player - wall).norm(), ends.length, 0, 1e-13));
        const auto [crate, hook] = learner(ends.a, ends.b, ends.wa, 0, ends.length);
        REQUIRE((hook - ends.b).norm() <= 1e-13);
        REQUIRE(close((hook - crate).norm(), ends.length, 0, 1e-13));
    }
}

PROPERTY("both ends move only along the line between them") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Ends ends(draw);
        const Vector3d along = (ends.b - ends.a).normalized();
        const auto [a, b] = learner(ends.a, ends.b, ends.wa, ends.wb, ends.length);
        REQUIRE((a - ends.a).cross(along).norm() <= 1e-13);
        REQUIRE((b - ends.b).cross(along).norm() <= 1e-13);
    }
}

PROPERTY("two ends that are held stay where they are, however long the rope") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Ends ends(draw, i % 2 == 0);
        const auto [a, b] = learner(ends.a, ends.b, 0, 0, ends.length);
        REQUIRE((a == ends.a && b == ends.b));
    }
}

PROPERTY("two ends in one place stay there") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Ends ends(draw);
        const auto [a, b] = learner(ends.a, ends.a, ends.wa, ends.wb, ends.length);
        REQUIRE((a == ends.a && b == ends.a));
    }
}

PROPERTY("it is right wherever the task allows: any masses and walls, too long by a hair or by miles") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double size = draw.log(1e-9, 1e6), unit = draw.log(1e-12, 1e12);
        const Vector3d a = i % 2 == 0 ? Vector3d(0, 0, 0) : Vector3d(size * draw_vector(draw, -5, 5));
        Vector3d along = draw_direction(draw);
        if (i % 9 == 4)
            along = (Vector3d::Unit(i / 9 % 3) + draw.log(1e-5, 1e-2) * along).normalized();  // nearly upright
        const Vector3d b = a + (i % 20 == 19 ? 0 : size) * along;
        // A heavy end at zero hardly moves: whoever has its share as one less the other's has the roundoff of that.
        if ((b.array() == 0 && a.array() != 0).any()) continue;
        const double hair = 1 + draw.sign() * draw.log(1e-11, 1e-2);
        const double length = size * (i % 3 == 0 ? hair : draw.log(1e-3, i % 3 == 1 ? 1 : 1e3));
        const double wa = unit * draw.any_of(0, 1, {0}), wb = unit * draw.any_of(0, 1, {0});
        const auto [new_a, new_b] = learner(a, b, wa, wb, length);
        REQUIRE((new_b - new_a).norm() <= (b - a).norm() * (1 + 1e-12) + 1e-15 * a.norm());
    }
}

PROPERTY("no mass is too small or too large for it beside the other, no rope too short, and no place too far away") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double size = draw.spread(1e-12, 1e12, i, 19), far = i % 3 == 0 ? draw.log(1, 1e3) : 0;
        const Vector3d a = far * size * draw_direction(draw), b = a + size * draw_direction(draw);
        // An end that comes to where the other is held has lost the digits of the way: not so, where both move.
        const double wa = draw.spread(1e-12, 1e12, i, 20);
        const double wb = i % 2 == 0 ? draw.spread(1e-12, 1e12, i, 21) : wa * draw.log(1e-2, 1e2);
        const double length = size * draw.log(i % 2 == 0 ? 1e-3 : 1e-12, 1.2);
        const auto [new_a, new_b] = learner(a, b, wa, wb, length);
        REQUIRE((new_b - new_a).norm() <= (b - a).norm() * (1 + 1e-12) + 1e-14 * a.norm());
    }
}
