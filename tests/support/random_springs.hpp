#pragma once
// Scenes of springs put together at random, spring by spring, and whether a method lets them grow: for tests that
// hold ./course advise to runs.

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Dense>

#include "advise.hpp"
#include <timestep/run.hpp>

namespace springs {

// M⁻¹ of a scene, its springs added one by one. Each pulls along one direction of all coordinates together, and
// has a damper beside it.
template <int N>
struct Net {
    using Vector = Eigen::Matrix<double, N, 1>;
    using Matrix = Eigen::Matrix<double, N, N>;

    Matrix stiffness = Matrix::Zero();
    Vector masses = Vector::Ones();
    double damping_share = 0;  // c/k, s

    void add(double k, const Vector& along) { stiffness += k * along * along.transpose(); }
    // Weak springs to the world that pull every way, ω² = `omega2`.
    void hold(double omega2) { stiffness += omega2 * Matrix(masses.asDiagonal()); }
    Matrix pull() const { return masses.cwiseInverse().asDiagonal() * stiffness; }
};

// As a model of the library: with dampers, and without where a method takes none.
template <int N>
struct Damped {
    typename Net<N>::Matrix a, b;
    explicit Damped(const Net<N>& net) : a(-net.pull()), b(net.damping_share * a) {}
    template <class X>
    X acceleration(const X& x, const X& v) const {
        return a * x + b * v;
    }
    const auto& slope_x() const { return a; }
    const auto& slope_v() const { return b; }
};
template <int N>
struct Undamped {
    typename Net<N>::Matrix a;
    explicit Undamped(const Net<N>& net) : a(-net.pull()) {}
    template <class X>
    X acceleration(const X& x) const {
        return a * x;
    }
    const auto& slope_x() const { return a; }
};

// The matrix of one step, column by column from the method's own step: what it makes of each state that has one
// coordinate. Two states where it needs two.
template <int N, class Method, class Model>
Eigen::MatrixXd step_of(const Method& method, const Model& model, double h) {
    using V = typename Net<N>::Vector;
    using S = timestep::State<V>;
    constexpr bool two = timestep::TwoStepMethod<Method, Model, S>;
    constexpr int size = two ? 4 * N : 2 * N;
    Eigen::MatrixXd step(size, size);
    for (int i = 0; i < size; ++i) {
        const Eigen::VectorXd y = Eigen::VectorXd::Unit(size, i);
        const S now{0, y.segment(0, N), y.segment(N, N)};
        if constexpr (two) {
            const S next = method.step(model, S{0, y.segment(2 * N, N), y.segment(3 * N, N)}, now, h);
            step.col(i) << next.x, next.v, now.x, now.v;
        } else {
            const S next = method.step(model, now, h);
            step.col(i) << next.x, next.v;
        }
    }
    return step;
}

// A hundred million steps, by squaring. What is free drifts, and so may double with the steps; what grows does not
// stop at that.
inline bool grows(Eigen::MatrixXd power) {
    double before = 0;
    for (int doublings = 0; doublings < 27; ++doublings) {
        before = power.norm();
        power = (power * power).eval();
        if (!(power.norm() < 1e100)) return true;
    }
    return power.norm() > 2.5 * before && power.norm() > 1e-30;
}
template <int N, class Method>
bool grows(const Method& method, const Net<N>& net, double h) {
    if constexpr (std::is_same_v<Method, timestep::Verlet>)  // its velocity is only for show
        return grows(step_of<N>(timestep::velocity_verlet, Undamped<N>(net), h));
    else if constexpr (Method::takes_damping)
        return grows(step_of<N>(method, Damped<N>(net), h));
    else
        return grows(step_of<N>(method, Undamped<N>(net), h));
}

class Random {
public:
    explicit Random(unsigned seed) : numbers_(seed) {}
    double even(double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>()(numbers_);
    }
    double in_log(double low, double high) { return low * std::pow(high / low, even(0, 1)); }
    int below(int n) { return static_cast<int>(numbers_() % static_cast<unsigned>(n)); }
    Eigen::Vector2d way() {
        const double angle = even(0, 6.283185307179586);
        return {std::cos(angle), std::sin(angle)};
    }

private:
    std::mt19937_64 numbers_;
};

// A body in the plane on springs to the world, at `arm` from its centre at most: all at one end pulling one way,
// like a plank on its two ends, or anywhere.
inline Net<3> body(Random& random, double mass, int count, double arm, double inertia) {
    Net<3> net;
    net.masses = {mass, mass, inertia};
    const int sort = random.below(3);
    for (int i = 0; i < count; ++i) {
        Eigen::Vector2d r(arm, 0), d(0, 1);
        if (sort == 1) r *= i % 2 ? -1 : 1;
        if (sort == 2) r = random.even(0, 1) * arm * random.way(), d = random.way();
        net.add(1, {d.x(), d.y(), r.x() * d.y() - r.y() * d.x()});
    }
    return net;
}

// Two bodies in the plane, held together in both directions.
inline Net<6> hinge(Random& random, double m1, double r1, double I1, double m2, double r2, double I2) {
    Net<6> net;
    net.masses << m1, m1, I1, m2, m2, I2;
    const Eigen::Vector2d a = r1 * random.way();
    const Eigen::Vector2d b = r2 * (random.below(2) ? Eigen::Vector2d(-a / r1) : random.way());
    for (const Eigen::Vector2d& d : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)}) {
        Eigen::Matrix<double, 6, 1> along;
        along << d, a.x() * d.y() - a.y() * d.x(), -d, -(b.x() * d.y() - b.y() * d.x());
        net.add(1, along);
    }
    return net;
}

// Points in rows and columns, each tied to its neighbours: straight, all springs pulling one way as in a net that
// is stretched, or crumpled, each in a direction of its own. One row is a chain. Its ends may be held.
template <int Rows, int Columns>
Net<2 * Rows * Columns> points(Random& random, double mass) {
    constexpr int N = 2 * Rows * Columns;
    Net<N> net;
    net.masses.setConstant(mass);
    const int sort = random.below(3);
    const auto tie = [&](int i, int j, const Eigen::Vector2d& straight) {
        const Eigen::Vector2d d = sort == 0 ? straight : sort == 1 ? Eigen::Vector2d(1, 0) : random.way();
        Eigen::Matrix<double, N, 1> along = Eigen::Matrix<double, N, 1>::Zero();
        if (i >= 0) along.template segment<2>(2 * i) = d;
        along.template segment<2>(2 * j) = -d;
        net.add(1, along);
    };
    for (int row = 0; row < Rows; ++row)
        for (int column = 0; column < Columns; ++column) {
            const int i = row * Columns + column;
            if (column + 1 < Columns) tie(i, i + 1, {1, 0});
            if (row + 1 < Rows) tie(i, i + Columns, {0, 1});
        }
    if (random.below(2)) tie(-1, 0, {1, 0});
    if (random.below(2)) tie(-1, Rows * Columns - 1, {1, 0});
    return net;
}

}  // namespace springs
