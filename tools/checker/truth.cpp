#include "truth.hpp"

#include <algorithm>
#include <cmath>

#include "shown.hpp"

namespace checker {

namespace {

constexpr unsigned variations = 6;

// Another way to write an answer: one of these may be lucky and lose nothing, hardly all of them. A third way loses some
// digits more.
constexpr unsigned variations_beside = 16;
constexpr double some_ways = 8;

// Its digits are lost to other roundings in each variation: so far the arguments must lie apart.
constexpr double apart_enough = 0.3;

bool agree(const Numbers& found, const Numbers& right, const Numbers& allowed) {
    for (std::size_t i = 0; i < found.size(); ++i)
        if (!(found[i] == right[i] || std::fabs(found[i] - right[i]) <= allowed[i])) return false;
    return true;
}

}  // namespace

Numbers lost_within(double most, const Function& way, const Truth& truth, const Numbers& arguments, unsigned variation) {
    Numbers lost = way.nudged(arguments, variation, most);
    const Numbers right = truth.nudged(arguments, variation, most);
    if (lost.size() != right.size()) return Numbers(1, HUGE_VAL);
    for (std::size_t i = 0; i < right.size(); ++i) lost[i] = std::fabs(lost[i] - right[i]);
    return lost;
}

Numbers lost_by(const Function& way, const Truth& truth, const Numbers& arguments, unsigned variation) {
    constexpr double near_by = 1e-3;  // all but roundoff is alike there, and a sum with 1 is rounded otherwise
    return lost_within(near_by, way, truth, arguments, variation);
}

bool is_right(const Truth& truth, const Numbers& arguments, const Numbers& found, const Within& within, const Spoken& spoken) {
    const double relative = within.relative;
    if (relative == many_are_right) return true;
    const Numbers right = truth.answer(arguments);
    if (found == right) return true;
    // Where roundoff decides how many numbers there are, or which whole one, anything is right.
    Numbers allowed(right.size());
    const double scale = relative / (2 * std::numeric_limits<double>::epsilon());
    for (unsigned variation = 1; variation <= variations; ++variation) {
        const Numbers near = truth.nudged(arguments, variation, few_units);
        if (near.size() != right.size()) return true;
        for (std::size_t i = 0; i < right.size(); ++i) {
            const double apart = std::fabs(near[i] - right[i]);
            const bool counted = near[i] == std::floor(near[i]) && right[i] == std::floor(right[i]);  // one or the other
            allowed[i] = std::max(allowed[i], !std::isfinite(apart) ? HUGE_VAL : counted ? apart : scale * apart);
        }
    }
    if (found.size() != right.size()) return false;
    for (unsigned variation = 1; within.beside.nudged && variation <= variations_beside; ++variation) {
        const Numbers lost = lost_within(apart_enough, within.beside, truth, arguments, variation);
        for (std::size_t i = 0; i < std::min(lost.size(), right.size()); ++i)
            if (std::isfinite(lost[i])) allowed[i] = std::max(allowed[i], some_ways * lost[i]);
    }
    double largest = 0;
    for (const double number : right) largest = std::max(largest, std::fabs(number));
    for (std::size_t i = 0; i < right.size(); ++i)
        allowed[i] = std::max(allowed[i], relative * (spoken.one_size ? largest : std::fabs(right[i])));
    if (agree(found, right, allowed)) return true;
    if (!spoken.or_minus) return false;
    Numbers minus = found;
    for (double& number : minus) number = -number;
    return agree(minus, right, allowed);
}

Numbers without_roundoff(const Truth& truth, const Numbers& arguments) {
    Numbers right = truth.answer(arguments);
    std::vector<bool> is_roundoff(right.size());
    for (unsigned variation = 1; variation <= variations; ++variation) {
        const Numbers near = truth.nudged(arguments, variation, few_units);
        if (near.size() != right.size()) return right;
        for (std::size_t i = 0; i < right.size(); ++i)
            // A whole number, or a yes or no, may flip by roundoff: that makes it no zero.
            if (right[i] != std::floor(right[i]) && std::fabs(near[i] - right[i]) >= std::fabs(right[i])) is_roundoff[i] = true;
    }
    for (std::size_t i = 0; i < right.size(); ++i)
        if (is_roundoff[i] || right[i] == 0) right[i] = 0;  // no -0
    return right;
}

}  // namespace checker
