#pragma once
// The functions whose slopes chapter 1 takes, each with all of its derivatives.

#include <cmath>
#include <string>

// eˣ: every derivative is eˣ again.
struct Exponential {
    static constexpr const char* name = "exp";

    template <class Real>
    Real operator()(Real x) const {
        return std::exp(x);
    }
    template <class Real>
    Real derivative(int, Real x) const {
        return std::exp(x);
    }
};

// sin x: the derivatives go round sin, cos, −sin, −cos.
struct Sine {
    static constexpr const char* name = "sin";

    template <class Real>
    Real operator()(Real x) const {
        return std::sin(x);
    }
    template <class Real>
    Real derivative(int k, Real x) const {
        const Real value = k % 2 == 0 ? std::sin(x) : std::cos(x);
        return k % 4 < 2 ? value : -value;
    }
};

// x³: from the fourth derivative on there is nothing left.
struct Cube {
    static constexpr const char* name = "cube";

    template <class Real>
    Real operator()(Real x) const {
        return x * x * x;
    }
    template <class Real>
    Real derivative(int k, Real x) const {
        switch (k) {
            case 0:
                return x * x * x;
            case 1:
                return 3 * x * x;
            case 2:
                return 6 * x;
            case 3:
                return 6;
            default:
                return 0;
        }
    }
};

// Calls `visit` with the function of that name.
template <class Visit>
void with_function(const std::string& name, const Visit& visit) {
    if (name == Sine::name)
        visit(Sine{});
    else if (name == Cube::name)
        visit(Cube{});
    else
        visit(Exponential{});
}
