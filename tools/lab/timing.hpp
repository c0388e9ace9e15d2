#pragma once
// How long something takes, by the clock.

#include <algorithm>
#include <chrono>
#include <limits>

namespace lab {

template <class Work>
double seconds_of(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The fastest of so many goes: the one that nothing disturbed.
template <class Work>
double fastest(int goes, const Work& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < goes; ++i) least = std::min(least, seconds_of(work));
    return least;
}

}  // namespace lab
