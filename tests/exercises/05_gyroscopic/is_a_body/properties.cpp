#include "is_a_body.hpp"

#include <Eigen/Eigenvalues>

#include "property_eigen.hpp"

// The task allows a tolerance, and the course's solution has none.
EXERCISE_WITHIN(is_a_body, checker::many_are_right);

namespace {

// All six orders of the axes.
std::array<Vector3d, 6> orders(double a, double b, double c) {
    return {Vector3d{a, b, c}, {b, c, a}, {c, a, b}, {c, b, a}, {b, a, c}, {a, c, b}};
}

// Is it a body in every order of the axes?
bool all_are(double a, double b, double c) {
    const auto moments = orders(a, b, c);
    return std::all_of(moments.begin(), moments.end(), learner);
}

// Is it one in any?
bool any_is(double a, double b, double c) {
    const auto moments = orders(a, b, c);
    return std::any_of(moments.begin(), moments.end(), learner);
}

// A tolerance that is a fixed number of kg m², say from 1e-13 to 1e-6, gets nothing right of what is
// much smaller, and all of what is larger. Nothing between is drawn: so it is known for what it is,
// whichever number it is.

// Very small, or not small.
double draw_size(Draw& draw) { return draw.integer(0, 1) == 0 ? draw.log(1e-20, 1e-16) : draw.log(2, 1e20); }

// A power of two: it changes the size of numbers and nothing else.
double draw_unit(Draw& draw, int least, int most) { return std::ldexp(1, draw.integer(least, most)); }

// What a third moment has too much, beside two of `size` at most: a share of them from `least` on.
double draw_excess(Draw& draw, double size, double least) {
    const bool small = size < 1e-18;
    const double from = small ? least * size : std::max(least * size, 4e-6);
    return draw.log(from, small ? 100 * size : 1e10 * from);
}

// Whole numbers that differ, and add up without rounding.
std::array<double, 2> draw_sides(Draw& draw) {
    const double a = draw.integer(1, 1 << 20);
    return {a, a + draw.integer(1, 1 << 20)};
}

}  // namespace

PROPERTY("the moments of a cloud of masses are those of a body, whichever way it is turned") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Vector3d reach(draw.log(0.05, 2), draw.log(0.05, 2), draw.log(0.05, 2));
        const Eigen::Matrix3d turn = draw_rotation(draw).toRotationMatrix();
        Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
        for (int points = draw.integer(6, 15); points > 0; --points) {
            const Vector3d r = turn * reach.cwiseProduct(draw_vector(draw, -1, 1));
            const Eigen::Matrix3d square = r.squaredNorm() * Eigen::Matrix3d::Identity();
            tensor += draw.log(0.1, 10) * (square - r * r.transpose());
        }
        REQUIRE(learner(tensor.diagonal()));
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(tensor);
        const Vector3d moments = principal.eigenvalues();
        REQUIRE(all_are(moments[0], moments[1], moments[2]));
    }
}

PROPERTY("a ball is a body, however small, and so is a thin staff: two moments equal, one less") {
    Draw draw;
    for (int i = 0; i < 10; ++i) {
        const double a = draw_size(draw);
        REQUIRE(all_are(a, a, a));
        REQUIRE(all_are(draw.log(std::max(1e-6 * a, 1e-20), a), a, a));
    }
}

PROPERTY("a flat plate is a body, whichever way it lies") {
    Draw draw;
    for (int i = 0; i < 4; ++i) {  // small ones, for whoever works them out by hand
        const int a = draw.integer(1, 9), b = draw.integer(1, 9);
        REQUIRE(all_are(a, b, a + b));
    }
    for (int i = 0; i < 20; ++i) {
        const auto [a, b] = draw_sides(draw);
        const double unit = i % 2 == 0 ? draw_unit(draw, 0, 44) : draw_unit(draw, -66, -64);
        REQUIRE(all_are(unit * a, unit * b, unit * (a + b)));
    }
}

// A tolerance of a billionth of the largest, or of the sum of all three, is within the task.
PROPERTY("no body has a moment above the sum of the other two, not even by a little") {
    Draw draw;
    for (int i = 0; i < 4; ++i) {  // small ones, for whoever works them out by hand
        const int a = draw.integer(1, 9), b = draw.integer(1, 9);
        REQUIRE_FALSE(any_is(a, b, a + b + draw.integer(1, 9)));
    }
    for (int i = 0; i < 50; ++i) {
        const double a = draw.log(1e3, 1e18), b = draw.log(0.02, 1) * a;
        REQUIRE_FALSE(any_is(a, b, (a + b) * (1 + draw.log(2.2e-9, 4e-9))));
        REQUIRE_FALSE(any_is(a, b, (a + b) * (1 + draw.log(1e-8, 100))));
    }
}

PROPERTY("no small body has a moment above the sum of the other two: what is a little depends on its size") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double a = draw.log(1e-18, 1e3), b = draw.log(0.02, 1) * a;
        REQUIRE_FALSE(any_is(a, b, a + b + draw_excess(draw, a, 1e-8)));
        const double c = draw.log(2e-20, 1e-18), d = draw.real(0.5, 1) * c;
        REQUIRE_FALSE(any_is(c, d, c + d + draw_excess(draw, c, 1e-8)));
    }
}

PROPERTY("a body has no moment that is zero or below") {
    Draw draw;
    REQUIRE_FALSE(any_is(0, 0, 0));
    for (int i = 0; i < 10; ++i) {
        const double a = draw.log(2e-20, 1e20);
        const double b = draw.real(0.5, 1) * a, c = draw.real(0.5, 1) * a;
        REQUIRE_FALSE(any_is(0, a, a));
        REQUIRE_FALSE(any_is(0, a, b));
        REQUIRE_FALSE(any_is(0, 0, a));
        REQUIRE_FALSE(any_is(-a, b, c));
        REQUIRE_FALSE(any_is(-a, -b, c));
        REQUIRE_FALSE(any_is(-a, -b, -c));
    }
}

// The larger of the two always does for the third. From there to either side the end is found by
// halving, for each place that the third may have.
PROPERTY("beside two moments the third may be from their difference to their sum, no farther") {
    Draw draw;
    for (int i = 0; i < 4; ++i) {
        const double a = i < 2 ? draw.log(1e8, 1e20) : draw.log(1e-18, 1e-17);
        const double b = draw.real(0.05, 0.95) * a;
        const auto ends_towards = [&](double out) {
            Vector3d ends;
            for (int place = 0; place < 3; ++place) {
                double in = a, off = out;
                for (int halvings = 0; halvings < 32; ++halvings) {
                    Vector3d inertia;
                    inertia[place] = (in + off) / 2;
                    inertia[(place + 1) % 3] = a;
                    inertia[(place + 2) % 3] = b;
                    (learner(inertia) ? in : off) = inertia[place];
                }
                ends[place] = in;
            }
            return ends;
        };
        const Vector3d highest = ends_towards(4 * a), least = ends_towards(0);
        for (int place = 0; place < 3; ++place) {
            REQUIRE(close(highest[place], a + b, 0, 1e-8 * a));
            REQUIRE(close(least[place], a - b, 0, 1e-8 * a));
        }
    }
}

PROPERTY("the same moments in other units, or in another order, get the same answer") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        // No plates: in another order their moments may add up to something else in the last digit.
        const double a = draw.real(0.1, 1), b = draw.real(0.1, 1);
        const double sum = a + b, apart = std::fabs(a - b);
        const double c = i % 3 == 0 ? sum * draw.real(1.01, 2) : apart + 2 * std::min(a, b) * draw.real(0.01, 0.99);
        const bool body = learner({a, b, c});
        const double unit = i % 2 == 0 ? draw_unit(draw, 0, 60) : draw_unit(draw, -63, -58);
        for (const Vector3d& moments : orders(a, b, c)) REQUIRE(learner(unit * moments) == body);
    }
}

// From the difference of two to their sum, and below and beyond: by a hair, by a little and by far. All are asked
// for, whatever the answers: so one mistake is told from another.
PROPERTY("it is right for staffs and plates, and for what is not quite one, of any size") {
    Draw draw;
    Every all;
    const auto ask = [&](const Vector3d& inertia, bool body) { all &= learner(inertia) == body; };
    for (int i = 0; i < 400; ++i) {
        const double a = draw.spread(1e-17, 1e17, i, 40), b = draw.log(1e-2, 1) * a;
        const double hair = draw.log(2.2e-9, 0.01), more = draw.real(0.2, 0.8), far = draw.log(2, 100);
        const int place = draw.integer(0, 2), turn = draw.integer(1, 2);
        Vector3d inertia;
        inertia[(place + turn) % 3] = a;
        inertia[(place + 2 * turn) % 3] = b;
        for (const double share : {-1e-8, -0.5, hair, 0.2, more, far}) {
            inertia[place] = a + b + share * (share < 0 ? 2 * b : a + b);
            ask(inertia, share < 0);
        }
        if (i % 4 == 0) {
            inertia[place] = a;
            inertia[draw.integer(0, 2)] *= draw.integer(0, 1) == 0 ? 0 : -1;
            ask(inertia, false);
        }
    }
    REQUIRE(bool(all));
}

// A needle's third moment is far less than the other two, which differ by less than that. Which are nearly the same
// is all that tells it from what no body has: by a billionth of them, and more.
PROPERTY("it is right up to the ends of what the task allows: the least and the largest numbers, needles, slabs") {
    Draw draw;
    Every all;
    const auto ask = [&](const Vector3d& inertia, bool body) { all &= learner(inertia) == body; };
    for (int i = 0; i < 240; ++i) {
        const double a = draw.spread(1e-20, 1e20, i, 40), thin = std::max(1e-20, a * draw.spread(1e-12, 1, i, 13));
        const double b = thin < 1e-8 * a ? a : std::min(a + 0.5 * thin, 1e20);
        const double more = draw.log(1e-8, 1) * a + thin, far = draw.spread(1e-20, 1e20, i, 29);
        for (int place = 0; place < 3; ++place) {
            Vector3d inertia;
            inertia[place] = thin, inertia[(place + 1) % 3] = a, inertia[(place + 2) % 3] = b;
            ask(inertia, true);
            std::swap(inertia[(place + 1) % 3], inertia[(place + 2) % 3]);
            ask(inertia, true);
            if (a + more <= 1e20)
                inertia[(place + 1) % 3] = a, inertia[(place + 2) % 3] = a + more, ask(inertia, false);
            inertia.setConstant(a);
            inertia[place] = far;  // what is larger than two alike can be a body up to their sum
            if (std::fabs(far - 2 * a) > 1e-6 * a) ask(inertia, far < 2 * a);
            inertia[place] = -far;
            ask(inertia, false);
        }
    }
    REQUIRE(bool(all));
}
