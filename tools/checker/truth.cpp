#include "truth.hpp"

#include <algorithm>
#include <cmath>

namespace checker {

namespace {

constexpr unsigned variations = 6;

bool agree(const Numbers& found, const Numbers& right, const Numbers& allowed) {
    for (std::size_t i = 0; i < found.size(); ++i)
        if (!(found[i] == right[i] || std::fabs(found[i] - right[i]) <= allowed[i])) return false;
    return true;
}

}  // namespace

bool is_right(const Truth& truth, const Numbers& arguments, const Numbers& found, double relative, bool or_minus) {
    if (relative == many_are_right) return true;
    const Numbers right = truth.answer(arguments);
    if (found == right) return true;
    // Where roundoff decides how many numbers there are, or which whole one, anything is right.
    Numbers allowed(right.size());
    const double scale = relative / (4 * std::numeric_limits<double>::epsilon());
    for (unsigned variation = 1; variation <= variations; ++variation) {
        const Numbers near = truth.nudged(arguments, variation);
        if (near.size() != right.size()) return true;
        for (std::size_t i = 0; i < right.size(); ++i) {
            const double apart = std::fabs(near[i] - right[i]);
            allowed[i] = std::max(allowed[i], std::isfinite(apart) ? scale * apart : HUGE_VAL);
        }
    }
    if (found.size() != right.size()) return false;
    for (std::size_t i = 0; i < right.size(); ++i)
        allowed[i] = std::max(allowed[i], relative * std::fabs(right[i]));
    if (agree(found, right, allowed)) return true;
    if (!or_minus) return false;
    Numbers minus = found;
    for (double& number : minus) number = -number;
    return agree(minus, right, allowed);
}

}  // namespace checker
