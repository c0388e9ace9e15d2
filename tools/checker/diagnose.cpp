// Which of the known mistakes is it?

#include <algorithm>
#include <cmath>

#include "shown.hpp"

namespace checker {

namespace {

constexpr std::size_t enough = 2000;  // calls are looked at

// How far one answer lies from another. What is not finite agrees with its like.
double apart(const Numbers& a, const Numbers& b) {
    if (a.size() != b.size()) return HUGE_VAL;
    double difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i] || (!std::isfinite(a[i]) && !std::isfinite(b[i]))) continue;
        const double one = std::fabs(a[i] - b[i]);
        difference = std::isfinite(one) ? std::max(difference, one) : HUGE_VAL;
    }
    return difference;
}

// An answer that is not called wrong counts as such where it differs by more than `least` of the right one: where
// many answers are right, the one that is not the course's says most.
Shown sorted(const Truth& truth, const std::vector<Call>& calls, double least) {
    Shown shown;
    for (const Call& call : calls) {
        Numbers right = truth.answer(call.arguments);
        double size = least > 0 ? 1 : 0;
        for (const double number : right) size = std::max(size, std::fabs(number));
        const bool differs = !call.right || apart(call.result, right) > least * size;
        if (differs && shown.wrong.size() < enough) {
            shown.wrong.push_back(&call);
            shown.truth.push_back(std::move(right));
        } else if (!differs && shown.right.size() < enough) {
            shown.right.push_back(&call);
        }
    }
    return shown;
}

// The share of calls in which the mistake does as the learner does.
struct Fit {
    double where_wrong = 0, where_right = 0;
    // Of yes and no, or of two counts, many agree by chance.
    bool good(bool counted) const { return where_wrong >= 0.97 && where_right >= (counted ? 0.98 : 0.9); }
};

Fit fit_of(const Mistake& mistake, const Shown& shown) {
    Fit fit;
    for (std::size_t i = 0; i < shown.wrong.size(); ++i) {
        const Call& call = *shown.wrong[i];
        fit.where_wrong += errs_alike(mistake.made.answer(call.arguments), call.result, shown.truth[i]);
    }
    for (const Call* call : shown.right) {
        const Numbers answer = mistake.made.answer(call->arguments);
        double size = 0;
        for (const double number : call->result) size = std::max(size, std::fabs(number));
        fit.where_right += apart(call->result, answer) <= 1e-9 * size;
    }
    fit.where_wrong /= double(shown.wrong.size());
    fit.where_right = shown.right.empty() ? 1 : fit.where_right / double(shown.right.size());
    return fit;
}

// Is the mistake one that loses digits, and does the learner lose about as many? Which, another order of operations
// decides: so the two are off by other amounts of one size.
bool loses_as_many_digits(const Mistake& mistake, const Truth& truth, const Shown& shown) {
    std::size_t fits = 0, many = 0;
    for (std::size_t i = 0; i < shown.wrong.size(); ++i) {
        const Call& call = *shown.wrong[i];
        double lost = 0, least = HUGE_VAL;
        for (unsigned variation = 1; variation <= 8; ++variation) {
            const Numbers each = lost_by(mistake.made, truth, call.arguments, variation);
            const double one = each.empty() ? 0 : *std::max_element(each.begin(), each.end());
            lost = std::max(lost, one);
            least = std::min(least, one);
        }
        const double gap = apart(call.result, shown.truth[i]);
        // What is always off by as much is off by more than roundoff: there the two must agree.
        const bool is_roundoff = lost < HUGE_VAL && least < 0.7 * lost;
        const bool agrees = gap < HUGE_VAL && errs_alike(mistake.made.answer(call.arguments), call.result, shown.truth[i]);
        fits += agrees || (is_roundoff && gap <= 4 * lost);
        many += agrees || (is_roundoff && gap >= 0.05 * lost);
    }
    std::size_t alike = 0;
    for (const Call* call : shown.right) {
        double size = 0;
        for (const double number : call->result) size = std::max(size, std::fabs(number));
        alike += apart(call->result, mistake.made.answer(call->arguments)) <= 1e-5 * size;
    }
    return double(fits) >= 0.9 * double(shown.wrong.size()) && double(many) >= 0.6 * double(shown.wrong.size()) &&
           double(alike) >= 0.75 * double(shown.right.size());
}

// Is what is wrong no more than single precision makes of the arguments, and more than lost digits of a double?
bool is_single_precision(const Truth& truth, const Shown& shown) {
    constexpr double most = 0x1p-22;
    std::size_t fits = 0, large = 0;
    for (std::size_t call = 0; call < shown.wrong.size(); ++call) {
        const Numbers &found = shown.wrong[call]->result, &right = shown.truth[call];
        Numbers off(right.size());
        for (unsigned variation = 1; variation <= 12; ++variation) {
            const Numbers near = truth.nudged(shown.wrong[call]->arguments, variation, most);
            for (std::size_t i = 0; i < std::min(off.size(), near.size()); ++i) off[i] = std::max(off[i], std::fabs(near[i] - right[i]));
        }
        bool fit = found.size() == right.size(), is_large = false;
        for (std::size_t i = 0; fit && i < found.size(); ++i) {
            const bool counted = right[i] == std::floor(right[i]) && found[i] == std::floor(found[i]);
            fit = std::fabs(found[i] - right[i]) <= (counted ? 1 : 4) * std::max(off[i], counted ? 0 : most * std::fabs(right[i]));
            is_large |= std::fabs(found[i] - right[i]) > 0.06 * off[i];
        }
        fits += fit;
        large += is_large;
    }
    return double(fits) >= 0.95 * double(shown.wrong.size()) && 2 * large >= shown.wrong.size();
}

constexpr double little = 2e-3;  // of the right answer: more than 3.14 for π costs, and its square

// Is each number that is wrong the right one times a number near one, and that always the same?
bool is_nearly_one_share(const Shown& shown) {
    double share = 0;
    std::size_t fits = 0;
    for (std::size_t call = 0; call < shown.wrong.size(); ++call) {
        const Numbers &found = shown.wrong[call]->result, &right = shown.truth[call];
        bool fit = found.size() == right.size();
        for (std::size_t i = 0; fit && i < found.size(); ++i) {
            if (found[i] == right[i]) continue;
            const double off = found[i] / right[i] - 1;
            const bool is_little = std::fabs(off) <= little && std::fabs(off) > 1e-13;
            if (share == 0 && is_little) share = off;
            fit = is_little && std::fabs(off - share) <= 1e-2 * std::fabs(share);
        }
        fits += fit;
    }
    return double(fits) >= 0.95 * double(shown.wrong.size());
}

// Is the answer wrong by a small part of it in most calls?
bool is_off_by_little(const Shown& shown) {
    std::size_t fits = 0, parts = 0;
    for (std::size_t call = 0; call < shown.wrong.size(); ++call) {
        double size = 0;
        for (const double number : shown.truth[call]) size = std::max(size, std::fabs(number));
        if (size == 0) continue;  // of nothing there is no part
        ++parts;
        fits += apart(shown.wrong[call]->result, shown.truth[call]) <= little * size;
    }
    return parts > 0 && double(fits) >= 0.97 * double(parts);  // another method errs by much somewhere
}

// Are the wrong answers numbers of single precision throughout, where the right ones are none?
bool is_rounded_to_single(const Shown& shown) {
    std::size_t numbers = 0, single = 0, by_nature = 0;
    for (std::size_t call = 0; call < shown.wrong.size(); ++call) {
        for (const double number : shown.wrong[call]->result) {
            ++numbers;
            single += double(float(number)) == number;
        }
        for (const double number : shown.truth[call]) by_nature += double(float(number)) == number;
    }
    return single == numbers && 2 * by_nature < numbers && is_off_by_little(shown);
}

// Mistakes of a kind that every exercise knows: by what is the answer off?
std::string family_of(const Shown& shown) {
    struct Family {
        const char* name;
        double (*makes)(double right);
    };
    static constexpr Family families[] = {
        {"minus", [](double x) { return -x; }},
        {"twice", [](double x) { return 2 * x; }},
        {"half", [](double x) { return x / 2; }},
        {"degrees", [](double x) { return x * 57.29577951308232; }},
        {"radians", [](double x) { return x / 57.29577951308232; }},
        {"squared", [](double x) { return x * x; }},
        {"root", [](double x) { return std::sqrt(x); }},
        {"inverse", [](double x) { return 1 / x; }},
    };
    if (shown.wrong.size() < 3) return {};  // a property that breaks calls no more
    for (const Family& family : families) {
        const auto made_of = [&](Numbers right) {
            for (double& number : right) number = family.makes(number);
            return right;
        };
        std::size_t fits = 0, misfits = 0;
        for (std::size_t i = 0; i < shown.wrong.size(); ++i) {
            const double gap = apart(shown.wrong[i]->result, shown.truth[i]);
            fits += gap < HUGE_VAL && apart(shown.wrong[i]->result, made_of(shown.truth[i])) <= 1e-6 * gap;
        }
        for (const Call* call : shown.right) misfits += apart(call->result, made_of(call->result)) > 1e-12;
        if (double(fits) >= 0.95 * double(shown.wrong.size()) && double(misfits) <= 0.05 * double(shown.wrong.size() + shown.right.size()))
            return family.name;
    }
    return {};
}

// Mistakes that make the answer inexact, whatever the exercise.
std::string inexact(const Truth& truth, const Shown& shown) {
    if (shown.wrong.size() < 3) return {};
    if (is_nearly_one_share(shown)) return "constant";
    if (is_rounded_to_single(shown) || is_single_precision(truth, shown)) return "single";
    return is_off_by_little(shown) ? "digits" : "";
}

}  // namespace

std::string diagnose(const std::string& exercise, const Truth& truth, const std::vector<Call>& calls) {
    // Where nothing is wrong by more than roundoff, a property has seen more: what differs at all.
    Shown shown = sorted(truth, calls, 1e-6);
    if (shown.wrong.empty()) shown = sorted(truth, calls, 0);
    if (shown.wrong.empty()) return {};
    const bool counted = std::all_of(calls.begin(), calls.end(), [](const Call& call) {
        return call.result.size() == 1 && call.result[0] == std::floor(call.result[0]);
    });
    std::string best;
    double most = 0;
    for (const Mistake& mistake : mistakes_of(exercise)) {
        const Fit fit = fit_of(mistake, shown);
        if (fit.good(counted) && fit.where_wrong + fit.where_right > most) {
            most = fit.where_wrong + fit.where_right;
            best = mistake.name;
        }
    }
    if (best.empty()) best = family_of(shown);
    if (best.empty()) best = slip_of(exercise, shown, counted);
    // Of whole numbers too many agree by chance with one of so many pairs.
    if (!best.empty() || counted) return best;
    for (const Mistake& mistake : mistakes_of(exercise))
        if (loses_as_many_digits(mistake, truth, shown)) return mistake.name;
    const std::string how = inexact(truth, shown);
    if (how.empty() || how == "digits") best = two_slips_of(exercise, shown);
    return best.empty() ? how : best;
}

}  // namespace checker
