#pragma once
// Dual numbers: exact derivatives, for tests that ask whether a solution solves its equation.

#include <cmath>

#include <Eigen/Core>

namespace test_support {

// a + bδ with δ² = 0. Put t + δ into a formula, and the factor of δ that comes out is the formula's
// derivative by the rules of calculus, with no difference quotient and no error but roundoff.
struct Dual {
    using Scalar = Dual;  // a real number, as far as the library is concerned

    double value = 0;
    double slope = 0;

    Dual() = default;
    Dual(double value_, double slope_ = 0) : value(value_), slope(slope_) {}

    friend Dual operator-(Dual a) { return {-a.value, -a.slope}; }
    friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
    friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
    friend Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
    friend Dual operator/(Dual a, Dual b) {
        const double q = a.value / b.value;
        return {q, (a.slope - q * b.slope) / b.value};
    }
    Dual& operator+=(Dual b) { return *this = *this + b; }
    Dual& operator-=(Dual b) { return *this = *this - b; }
    Dual& operator*=(Dual b) { return *this = *this * b; }
    Dual& operator/=(Dual b) { return *this = *this / b; }

    friend bool operator==(Dual a, Dual b) { return a.value == b.value; }
    friend bool operator<(Dual a, Dual b) { return a.value < b.value; }
    friend bool operator>(Dual a, Dual b) { return a.value > b.value; }

    friend Dual abs(Dual a) { return a < 0 ? -a : a; }
    friend Dual sqrt(Dual a) {
        const double root = std::sqrt(a.value);
        return {root, a.slope / (2 * root)};
    }
    friend Dual exp(Dual a) { return {std::exp(a.value), a.slope * std::exp(a.value)}; }
    friend Dual expm1(Dual a) { return {std::expm1(a.value), a.slope * std::exp(a.value)}; }
    friend Dual sin(Dual a) { return {std::sin(a.value), a.slope * std::cos(a.value)}; }
    friend Dual cos(Dual a) { return {std::cos(a.value), -a.slope * std::sin(a.value)}; }
    friend bool is_finite(const Dual& a) { return std::isfinite(a.value); }
};

}  // namespace test_support

template <>
struct Eigen::NumTraits<test_support::Dual> : Eigen::GenericNumTraits<test_support::Dual> {
    using Real = test_support::Dual;
    using NonInteger = test_support::Dual;
    using Nested = test_support::Dual;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 2,
        AddCost = 2,
        MulCost = 4
    };
};
