#include "truth.hpp"

#include <algorithm>
#include <cmath>

#include "evidence.hpp"
#include "slips.hpp"

namespace checker {

namespace {

constexpr unsigned variations = 6;

// A wrong answer is tried against so many: some may be lucky and show no roundoff, hardly all of them.
constexpr unsigned trials = 24;

// A third way to write an answer loses some digits more.
constexpr double some_ways = 8;

// The roundings of each way that the course knows are drawn so often.
constexpr unsigned drawn = 4;

// Its digits are lost to other roundings in each variation: so far the arguments must lie apart.
constexpr double apart_enough = 0.3;

bool agree(const Numbers& found, const Numbers& right, const Numbers& allowed) {
    for (std::size_t i = 0; i < found.size(); ++i)
        if (!(found[i] == right[i] || std::fabs(found[i] - right[i]) <= allowed[i])) return false;
    return true;
}

// Allows what roundings that are drawn at random make of a right way to write the answer.
void allow_roundings(const Answer& way, const Numbers& arguments, const Numbers& right, double constant, bool or_minus,
                     unsigned variation, Numbers& allowed) {
    const Numbers near = slip::rounded(way, arguments, variation, constant);
    if (near.size() != right.size()) return;
    double apart = 0, apart_from_minus = 0;
    for (std::size_t i = 0; i < right.size(); ++i)
        apart += std::fabs(near[i] - right[i]), apart_from_minus += std::fabs(near[i] + right[i]);
    const double sign = or_minus && apart_from_minus < apart ? -1 : 1;
    for (std::size_t i = 0; i < right.size(); ++i) {
        const double off = some_ways * std::fabs(sign * near[i] - right[i]);
        if (std::isfinite(off)) allowed[i] = std::max(allowed[i], off);
    }
}

}  // namespace

Numbers lost_within(double most, const Function& way, const Truth& truth, const Numbers& arguments,
                    unsigned variation) {
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

bool is_right(const Truth& truth, const Numbers& arguments, const Numbers& found, const Within& within,
              const Spoken& spoken) {
    const double relative = within.relative;
    if (relative == many_are_right) return true;
    const Numbers right = truth.answer(arguments);
    const double largest = size_of(right);
    Numbers allowed(right.size()), minus = found;
    for (std::size_t i = 0; i < right.size(); ++i)
        allowed[i] = relative * (spoken.one_size ? largest : std::fabs(right[i]));
    for (double& number : minus) number = -number;
    const auto allows = [&](const Numbers& numbers) {
        return numbers.size() == right.size() && agree(numbers, right, allowed);
    };
    const double of_arguments = within.of_arguments > 0 ? within.of_arguments : relative;
    const double scale = of_arguments / (2 * std::numeric_limits<double>::epsilon());
    const double constant = std::max(few_units, within.of_arguments > 0 ? relative / some_ways : 0);
    const bool is_rounded = within.ways && spoken.has_reals;
    for (unsigned variation = 1; !allows(found) && !(spoken.or_minus && allows(minus)); ++variation) {
        if (variation > trials) return false;
        const Numbers near = truth.nudged(arguments, variation, few_units);
        // Where roundoff decides how many numbers there are, or which whole one, anything is right.
        if (near.size() != right.size()) return true;
        const Numbers lost = within.beside.nudged
                                 ? lost_within(apart_enough, within.beside, truth, arguments, variation)
                                 : Numbers(right.size());
        for (std::size_t i = 0; i < right.size(); ++i) {
            if (i < lost.size() && std::isfinite(lost[i])) allowed[i] = std::max(allowed[i], some_ways * lost[i]);
            const double apart = std::fabs(near[i] - right[i]);
            const bool counted =
                near[i] == std::floor(near[i]) && right[i] == std::floor(right[i]);  // one or the other
            allowed[i] = std::max(allowed[i], !std::isfinite(apart) ? HUGE_VAL : counted ? apart : scale * apart);
        }
        if (is_rounded && variation <= drawn)
            for (const Answer& way : *within.ways)
                allow_roundings(way, arguments, right, constant, spoken.or_minus, variation, allowed);
    }
    return true;
}

Numbers without_roundoff(const Truth& truth, const Numbers& arguments) {
    Numbers right = truth.answer(arguments);
    std::vector<bool> is_roundoff(right.size());
    for (unsigned variation = 1; variation <= variations; ++variation) {
        const Numbers near = truth.nudged(arguments, variation, few_units);
        if (near.size() != right.size()) return right;
        for (std::size_t i = 0; i < right.size(); ++i)
            // A whole number, or a yes or no, may flip by roundoff: that makes it no zero.
            if (right[i] != std::floor(right[i]) && std::fabs(near[i] - right[i]) >= std::fabs(right[i]))
                is_roundoff[i] = true;
    }
    for (std::size_t i = 0; i < right.size(); ++i)
        if (is_roundoff[i] || right[i] == 0) right[i] = 0;  // no -0
    return right;
}

}  // namespace checker
