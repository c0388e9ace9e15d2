#include "newton_step.hpp"

#include "property_eigen.hpp"

// Ten digits count, says the task.
static constexpr double near_enough = 1e-10;
EXERCISE_WITHIN(newton_step, near_enough);

// One problem: f(ω₂) = I (ω₂ − ω₁) + h ω₂ × Iω₂.
struct Problem {
    Matrix3d inertia;
    Vector3d omega1;
    double h;

    Vector3d improved(const Vector3d& guess) const { return learner(inertia, omega1, guess, h); }
    Vector3d residual(const Vector3d& omega2) const {
        return inertia * (omega2 - omega1) + h * omega2.cross(inertia * omega2);
    }
};

static Vector3d draw_spin(Draw& draw, double largest) { return draw.real(0.2, 1) * largest * draw_direction(draw); }

// The tensor of a body that lies in other axes.
static Matrix3d turned(const Matrix3d& axes, const Matrix3d& inertia) {
    const Matrix3d half = axes * inertia;
    return half * axes.transpose();
}

// A tensor in axes that are nobody's principal ones.
static Matrix3d draw_inertia(Draw& draw, const Vector3d& moments) {
    const Matrix3d axes = draw_rotation(draw).toRotationMatrix();
    const Matrix3d inertia = turned(axes, moments.asDiagonal());
    return (inertia + inertia.transpose()) / 2;
}

static Problem draw_problem(Draw& draw) {
    const double h = draw.log(0.001, 0.2);
    return {draw_inertia(draw, draw_moments(draw, 20)), draw_spin(draw, 0.5 / h), h};
}

// A problem with a known root ω₂, of a body with three clearly different moments.
struct Solved : Problem {
    Vector3d root;
};

static Solved draw_solved(Draw& draw) {
    const double h = draw.log(0.001, 0.2), size = draw.log(0.01, 100);
    const Vector3d moments(draw.real(0.62, 0.7), draw.real(0.9, 1.1), draw.real(1.3, 1.5));
    const Matrix3d inertia = draw_inertia(draw, size * moments);
    const Vector3d root = draw_spin(draw, 0.25 / h);
    const Vector3d change = solve_linear(inertia, root.cross(inertia * root));
    return {{inertia, root + h * change, h}, root};
}

// Up to the root that stays, a few digits will do: where mistakes answer alike, single precision
// should not be taken for one of them.
PROPERTY("a step of zero ends with omega1, whatever the guess") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        Problem p = draw_problem(draw);
        const Vector3d guess = draw_spin(draw, 0.5 / p.h);
        p.h = 0;
        REQUIRE(close(p.improved(guess), p.omega1, 0, 1e-5 * (p.omega1.norm() + guess.norm())));
    }
}

PROPERTY("a ball keeps its spin: one iteration finds omega1 from any guess") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        Problem p = draw_problem(draw);
        p.inertia = draw.log(0.01, 100) * Matrix3d::Identity();
        const Vector3d guess = draw_spin(draw, 0.5 / p.h);
        REQUIRE(close(p.improved(guess), p.omega1, 0, 1e-5 * (p.omega1.norm() + guess.norm())));
    }
}

// f is quadratic: its differences to both sides give the slope J d of the tangent without an error,
// however long d is. Roundoff times the ratio of the moments is below 1e-13.
PROPERTY("the answer lies where the tangent to f at the guess is zero") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const Problem p = draw_problem(draw);
        const Vector3d guess = draw_spin(draw, 0.5 / p.h);
        const Vector3d d = p.improved(guess) - guess;
        const Vector3d rise = (p.residual(guess + d) - p.residual(guess - d)) / 2;
        const double largest = std::max({p.omega1.norm(), guess.norm(), d.norm()});
        REQUIRE(close(p.residual(guess) + rise, Vector3d(0, 0, 0), 0, 4 * near_enough * p.inertia.norm() * largest));
    }
}

PROPERTY("a few iterations from omega1 find the root") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Solved p = draw_solved(draw);
        Vector3d omega2 = p.omega1;
        for (int round = 0; round < 8; ++round) omega2 = p.improved(omega2);
        REQUIRE(close(omega2, p.root, 2 * near_enough));
    }
}

PROPERTY("it is right for any body, tiny or huge, any two spins or none, and any step") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        Vector3d moments = draw.log(1e-12, 1e12) * draw_moments(draw, 100);
        if (i % 3 == 0) moments[i % 2] = moments[2] = moments.maxCoeff();
        const double fast = draw.log(1e-2, 1e3), h = draw.any_of(0, 0.5, {0}) / fast;
        const Vector3d first = fast * draw_direction(draw);
        const Vector3d second = fast * draw.any_of(0, 1, {0, 1}) * draw_direction(draw);
        const Matrix3d inertia = i % 4 == 0 ? Matrix3d(moments.asDiagonal()) : draw_inertia(draw, moments);
        REQUIRE(learner(inertia, first, second, h).allFinite());
        REQUIRE(learner(inertia, first, first + second / 1e3, h).allFinite());
        // The answer is of omega1's size: a guess far larger would cost it digits.
        REQUIRE(learner(inertia, 0.1 * first, fast * draw_direction(draw), h).allFinite());
    }
}

PROPERTY("from rest it goes to where the tangent is zero, too") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        Solved p = draw_solved(draw);
        p.omega1 = Vector3d(0, 0, 0);
        const Vector3d guess = draw.real(0.2, 0.5) / p.h * draw_direction(draw), better = p.improved(guess),
                       d = better - guess;
        const Vector3d rise = (p.residual(guess + d) - p.residual(guess - d)) / 2;
        REQUIRE(
            close(p.residual(guess) + rise, Vector3d(0, 0, 0), 0, 4 * near_enough * p.inertia.norm() * guess.norm()));
    }
}

// Whoever finds the slope by wide differences, one rad/s or more to either side, needs no slower spins.
PROPERTY("no moment is too small or too large for it, no spin too fast, and no step too short or too long") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const Vector3d moments = draw.spread(1e-12, 1e12, i, 19) * draw_moments(draw, 100);
        const double fast = draw.spread(1e-2, 1e12, i, 20), h = draw.spread(1e-9, 0.5, i, 21) / fast;
        const Vector3d first = fast * draw_direction(draw), second = fast * draw.real(0.1, 1) * draw_direction(draw);
        REQUIRE(learner(draw_inertia(draw, moments), first, second, h).allFinite());
    }
}
