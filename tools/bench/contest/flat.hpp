#pragma once
// Other libraries step arrays of numbers: y = (x, v), and ẏ = (v, a(x, v)).

#include <array>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <timestep/forces.hpp>

namespace contest {

template <class X>
constexpr int size_of() {
    if constexpr (std::is_arithmetic_v<X>)
        return 1;
    else
        return X::SizeAtCompileTime;
}

template <class X>
using Half = std::array<double, size_of<X>()>;  // x or v
template <class X>
using Flat = std::array<double, 2 * size_of<X>()>;  // both

template <class X>
X read(const double* from) {
    if constexpr (std::is_arithmetic_v<X>)
        return *from;
    else
        return Eigen::Map<const X>(from);
}

template <class X>
void write(const X& x, double* to) {
    if constexpr (std::is_arithmetic_v<X>)
        *to = x;
    else
        Eigen::Map<X>{to} = x;
}

template <class X>
void write(const timestep::State<X>& s, double* y) {
    write(s.x, y);
    write(s.v, y + size_of<X>());
}

// A state as they want it, where the size is not known to the compiler.
template <class X>
std::vector<double> flat(const timestep::State<X>& s) {
    std::vector<double> y(2 * size_of<X>());
    write(s, y.data());
    return y;
}

/// [slope]
template <class X, class Model>
void slope(const Model& model, const double* y, double* dydt) {
    const X x = read<X>(y), v = read<X>(y + size_of<X>());
    const X a = acceleration(model, x, v);
    write(v, dydt);
    write(a, dydt + size_of<X>());
}
/// [slope]

// ∂ẏ/∂y in row i and column j: on top the ones of ẋ = v, below them the slopes of the force.
template <class X, class Slope>
double element(const Slope& slope, int i, int j) {
    if constexpr (std::is_arithmetic_v<Slope>)
        return i == j ? slope : 0;
    else
        return slope(i, j);
}

template <class X, class Model, class Put>
void jacobian(const Model& model, const double* y, const Put& put) {
    constexpr int n = size_of<X>();
    const X x = read<X>(y), v = read<X>(y + n);
    const auto of_x = slope_x(model, x, v);
    const auto of_v = slope_v(model, x, v);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            put(i, j, 0.0);
            put(i, n + j, i == j ? 1.0 : 0.0);
            put(n + i, j, element<X>(of_x, i, j));
            put(n + i, n + j, element<X>(of_v, i, j));
        }
}

}  // namespace contest
