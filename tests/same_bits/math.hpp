#pragma once
// The library's own functions, by themselves: few of the other rows' numbers are such that another library rounds them
// in another way.
#include <timestep/own_math.hpp>

#include "hash.hpp"

namespace math {

template <class Real>
void print_all() {
    Hash roots, turns;
    for (int i = -bits_steps; i < bits_steps; ++i) {
        const Real x = Real(i) * Real(0.0731), far = x * Real(7919);
        roots.add(timestep::cube_root(x)), roots.add(timestep::cube_root(far));
        for (const Real angle : {x / 64, x, far}) {
            const auto [sine, cosine] = timestep::sine_cosine(angle);
            turns.add(sine), turns.add(cosine);
        }
    }
    row(roots, name_of<Real>, "cube roots", "own");
    row(turns, name_of<Real>, "sines and cosines", "own");
}

inline void print_rows() {
    print_all<float>();
    print_all<double>();
}

}  // namespace math
