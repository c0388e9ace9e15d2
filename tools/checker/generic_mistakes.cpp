// Mistakes of a kind that every exercise knows: what is the answer of the right one?

#include <algorithm>
#include <cmath>

#include "evidence.hpp"

namespace checker {

namespace {

// Is what is wrong no more than single precision makes of the arguments, and more than lost digits of a double?
bool is_single_precision(const Truth& truth, const Evidence& evidence) {
    constexpr double most = 0x1p-22;
    std::size_t fits = 0, large = 0;
    for (std::size_t call = 0; call < evidence.wrong.size(); ++call) {
        const Numbers &found = evidence.wrong[call]->result, &right = evidence.truth[call];
        Numbers off(right.size());
        for (unsigned variation = 1; variation <= 12; ++variation) {
            const Numbers near = truth.nudged(evidence.wrong[call]->arguments, variation, most);
            for (std::size_t i = 0; i < std::min(off.size(), near.size()); ++i)
                off[i] = std::max(off[i], std::fabs(near[i] - right[i]));
        }
        bool fit = found.size() == right.size(), is_large = false;
        for (std::size_t i = 0; fit && i < found.size(); ++i) {
            const bool counted = right[i] == std::floor(right[i]) && found[i] == std::floor(found[i]);
            fit = std::fabs(found[i] - right[i]) <=
                  (counted ? 1 : 4) * std::max(off[i], counted ? 0 : most * std::fabs(right[i]));
            is_large |= std::fabs(found[i] - right[i]) > 0.06 * off[i];
        }
        fits += fit;
        large += is_large;
    }
    return double(fits) >= 0.95 * double(evidence.wrong.size()) && 2 * large >= evidence.wrong.size();
}

constexpr double little = 2e-3;  // of the right answer: more than 3.14 for π costs, and its square

// Is each number that is wrong the right one times a number near one, and that always the same?
bool is_nearly_one_share(const Evidence& evidence) {
    double share = 0;
    std::size_t fits = 0;
    for (std::size_t call = 0; call < evidence.wrong.size(); ++call) {
        const Numbers &found = evidence.wrong[call]->result, &right = evidence.truth[call];
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
    return double(fits) >= 0.95 * double(evidence.wrong.size());
}

// Is the answer wrong by a small part of it in most calls?
bool is_off_by_little(const Evidence& evidence) {
    std::size_t fits = 0, parts = 0;
    for (std::size_t call = 0; call < evidence.wrong.size(); ++call) {
        const double size = size_of(evidence.truth[call]);
        if (size == 0) continue;  // of nothing there is no part
        ++parts;
        fits += apart(evidence.wrong[call]->result, evidence.truth[call]) <= little * size;
    }
    return parts > 0 && double(fits) >= 0.97 * double(parts);  // another method errs by much somewhere
}

// Are the wrong answers numbers of single precision throughout, where the right ones are none?
bool is_rounded_to_single(const Evidence& evidence) {
    std::size_t numbers = 0, single = 0, by_nature = 0;
    for (std::size_t call = 0; call < evidence.wrong.size(); ++call) {
        for (const double number : evidence.wrong[call]->result) {
            ++numbers;
            single += double(float(number)) == number;
        }
        for (const double number : evidence.truth[call]) by_nature += double(float(number)) == number;
    }
    return single == numbers && 2 * by_nature < numbers && is_off_by_little(evidence);
}

}  // namespace

std::string generic_mistake_of(const Evidence& evidence) {
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
        {"absolute", [](double x) { return std::fabs(x); }},
        {"squared", [](double x) { return x * x; }},
        {"root", [](double x) { return std::sqrt(x); }},
        {"inverse", [](double x) { return 1 / x; }},
    };
    if (evidence.wrong.size() < 3) return {};  // a property that breaks calls no more
    for (const Family& family : families) {
        const auto made_of = [&](Numbers right) {
            for (double& number : right) number = family.makes(number);
            return right;
        };
        std::size_t fits = 0, misfits = 0;
        for (std::size_t i = 0; i < evidence.wrong.size(); ++i) {
            const double gap = apart(evidence.wrong[i]->result, evidence.truth[i]);
            fits += gap < HUGE_VAL && apart(evidence.wrong[i]->result, made_of(evidence.truth[i])) <= 1e-6 * gap;
        }
        for (const Call* call : evidence.right) misfits += apart(call->result, made_of(call->result)) > 1e-12;
        if (double(fits) >= 0.95 * double(evidence.wrong.size()) &&
            double(misfits) <= 0.05 * double(evidence.wrong.size() + evidence.right.size()))
            return family.name;
    }
    return {};
}

bool is_negated(const std::vector<Call>& calls, const Evidence& evidence) {
    std::size_t yes = 0;
    for (std::size_t i = 0; i < evidence.wrong.size(); ++i) {
        const Numbers &found = evidence.wrong[i]->result, &right = evidence.truth[i];
        if (found.size() != 1 || right.size() != 1 || found[0] != 1 - right[0] || (right[0] != 0 && right[0] != 1))
            return false;
        yes += right[0] == 1;
    }
    return evidence.wrong.size() == std::min(calls.size(), enough_calls) && yes > 0 && yes < evidence.wrong.size();
}

std::string off_by_one(const Evidence& evidence) {
    std::size_t more = 0, less = 0;
    for (std::size_t i = 0; i < evidence.wrong.size(); ++i) {
        const double off = evidence.wrong[i]->result[0] - evidence.truth[i][0];
        more += off == 1;
        less += off == -1;
    }
    const std::size_t all = evidence.wrong.size();
    return all < 10 ? "" : more == all ? "one_more" : less == all ? "one_less" : "";
}

std::string inexact(const Truth& truth, const Evidence& evidence) {
    if (evidence.wrong.size() < 3) return {};
    if (is_nearly_one_share(evidence)) return "constant";
    if (is_rounded_to_single(evidence) || is_single_precision(truth, evidence)) return "single";
    return is_off_by_little(evidence) ? "digits" : "";
}

std::string changed(const Truth& truth, const Evidence& evidence) {
    struct Family {
        const char* name;
        double share;
    };
    static constexpr Family families[] = {{"changed_twice", 2}, {"changed_half", 0.5}, {"changed_back", -1}};
    if (evidence.wrong.size() < 6) return {};
    const std::size_t size = evidence.truth[0].size();
    for (const Family& family : families)
        for (std::size_t at = 0; at + size <= truth.leading; ++at) {
            const auto made = [&](const Numbers& given, const Numbers& right, const Numbers& found) {
                Numbers numbers = right;
                for (std::size_t i = 0; i < size && found.size() == size; ++i)
                    if (found[i] != right[i]) numbers[i] = given[at + i] + family.share * (right[i] - given[at + i]);
                return numbers;
            };
            bool fits = true;
            for (std::size_t i = 0; fits && i < evidence.wrong.size(); ++i) {
                const Call& call = *evidence.wrong[i];
                fits = evidence.truth[i].size() == size &&
                       errs_alike(made(call.arguments, evidence.truth[i], call.result), call.result, evidence.truth[i],
                                  evidence.roundoff[i]);
            }
            if (fits) return family.name;
        }
    return {};
}

bool is_case_of_generic_mistake(const std::string& name, const Truth& truth, const Evidence& one) {
    if (name == "negated" || name == "near") return true;
    if (name == "constant") return is_nearly_one_share(one);
    if (name == "single") return is_off_by_little(one) || is_single_precision(truth, one);
    if (name == "digits") return is_off_by_little(one);
    if (name == "one_more" || name == "one_less") return off_by_one(one) == name;
    return (name.starts_with("changed_") ? changed(truth, one) : generic_mistake_of(one)) == name;
}

}  // namespace checker
