#pragma once
/// \file
/// A rope: points stepped by Verlet and pulled back to their distances (position-based dynamics).

#include <cstddef>
#include <vector>

#include <timestep/checks.hpp>
#include <timestep/linear_solve.hpp>
#include <timestep/methods/verlet.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// A chain of points of equal mass, each at the distance `link` from the next; the first one is
/// held. As in Jakobsen's *Advanced Character Physics* (2001), Verlet moves every point as if it
/// were alone, and then the links are set to their length one after another, a few times over:
/// Gauss–Seidel iterations of constraint projection, position-based dynamics (PBD). Moving a point
/// changes its velocity too, because Verlet's state is two positions.
///
/// `X` is a fixed-size Eigen vector.
template <class X>
class Rope {
public:
    using Real = real_of<X>;  ///< the real number type

    /// A straight rope at rest, from `top` in the direction `along`. Throws
    /// `std::invalid_argument`.
    Rope(const X& top, const X& along, std::size_t links, Real link, const Projectile<X>& gravity)
        : gravity_(gravity), link_(positive("link", link)) {
        if (links == 0) refuse("links: must be one or more");
        if (!is_finite(top)) refuse("top: must be a finite place");
        positive("length of the direction", Real(norm(along)));
        for (std::size_t i = 0; i <= links; ++i) {
            const X x = top + Real(i) * link * direction(along);
            points_.push_back({x, x});
        }
    }

    /// One step of `h` seconds, which must be constant: Verlet, then `sweeps` iterations over all
    /// links. Throws `std::invalid_argument` unless h is above zero and `sweeps` zero or more.
    void step(Real h, int sweeps) {
        positive("step", h), not_negative("sweeps", Real(sweeps));
        for (std::size_t i = 1; i < points_.size(); ++i) {
            auto& [x, before] = points_[i];
            const X next = 2 * x - before + h * h * acceleration(gravity_, x);
            before = x;
            x = next;
        }
        for (int n = 0; n < sweeps; ++n)
            for (std::size_t i = 1; i < points_.size(); ++i) put_right(i);
    }

    /// A point of the rope.
    struct Point {
        X x;       ///< position, m
        X before;  ///< position a step earlier, m
    };
    /// The points, beginning with the held one.
    const std::vector<Point>& points() const { return points_; }

    /// The velocity of point i in the middle of the last step of length h, m/s.
    X velocity(std::size_t i, Real h) const { return (points_[i].x - points_[i].before) / h; }

    /// The relative excess length of the rope: 0 is right, 0.1 is a tenth too long.
    Real stretch() const {
        Real length = 0;
        for (std::size_t i = 1; i < points_.size(); ++i)
            length += norm(X(points_[i].x - points_[i - 1].x));
        return length / (link_ * Real(points_.size() - 1)) - 1;
    }

private:
    // The two ends of a link share the excess; the held point does not move. Two points in one
    // place have no direction and stay.
    void put_right(std::size_t i) {
        X& a = points_[i - 1].x;
        X& b = points_[i].x;
        const X apart = b - a;
        const X excess = apart - link_ * direction(apart);
        if (i > 1) a += excess / 2;
        b -= i > 1 ? X(excess / 2) : excess;
    }

    Projectile<X> gravity_;
    Real link_;
    std::vector<Point> points_;
};

}  // namespace timestep
