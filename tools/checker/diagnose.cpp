// Which of the known mistakes is it?

#include <algorithm>
#include <cmath>
#include <utility>

#include "evidence.hpp"
#include "slips.hpp"

namespace checker {

double size_of(const Numbers& numbers) {
    double size = 0;
    for (const double number : numbers) size = std::max(size, std::isfinite(number) ? std::fabs(number) : 0);
    return size;
}

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

namespace {

double largest(const Numbers& each) { return each.empty() ? 0 : *std::max_element(each.begin(), each.end()); }

// What roundoff of the arguments makes of each number of the right answer; of a count nothing.
Numbers roundoff_of(const Truth& truth, const Numbers& arguments, const Numbers& right) {
    constexpr double another_way = 8;  // to write it makes so much more of it
    constexpr double jump = 1e-3;      // of the answer: two numbers are equal, or something lies just at its edge
    Numbers roundoff(right.size());
    const double size = size_of(right);
    for (unsigned variation = 1; variation <= 3; ++variation) {
        const Numbers near = truth.nudged(arguments, variation, few_units);
        for (std::size_t i = 0; i < std::min(near.size(), right.size()); ++i) {
            const double one = another_way * std::fabs(near[i] - right[i]);
            if (one <= jump * size && (near[i] != std::floor(near[i]) || right[i] != std::floor(right[i])))
                roundoff[i] = std::max(roundoff[i], one);
        }
    }
    return roundoff;
}

// And where many answers are right, what lies between those that the course knows: it tells nothing either, nor does it
// hide that two answers err alike. A mistake turns it into other directions, so each number may be off by all of it.
Numbers untold_of(const std::string& exercise, const Truth& truth, const Numbers& arguments, const Numbers& right) {
    constexpr double turned = 2;
    Numbers untold = roundoff_of(truth, arguments, right);
    double most = 0;
    for (const Answer& answer : registered(exercise).slips) {
        const double gap = apart(slip::answered(answer, arguments, {}), right);
        if (gap < HUGE_VAL) most = std::max(most, turned * gap);
    }
    for (double& one : untold) one = std::max(one, most);
    return untold;
}

// An answer that is not called wrong counts as such where it differs by more than `least` of the right one: where
// many answers are right, the one that is not the course's says most.
// `many`: the exercise whose right answers are many, where what lies between them is to tell nothing.
Evidence sorted(const Truth& truth, const std::vector<Call>& calls, double least, const std::string& many) {
    Evidence evidence;
    for (const Call& call : calls) {
        Numbers right = truth.answer(call.arguments);
        const double size = std::max(least > 0 ? 1.0 : 0.0, size_of(right));
        const bool differs = !call.right || apart(call.result, right) > least * size;
        if (differs && evidence.wrong.size() < enough_calls) {
            Numbers roundoff = many.empty() ? roundoff_of(truth, call.arguments, right)
                                            : untold_of(many, truth, call.arguments, right);
            // By no more than roundoff, or than that of another number beside it: that tells nothing.
            if (errs_alike(right, call.result, right, roundoff)) continue;
            evidence.wrong.push_back(&call);
            evidence.truth.push_back(std::move(right));
            evidence.roundoff.push_back(std::move(roundoff));
        } else if (!differs && evidence.right.size() < enough_calls) {
            evidence.right.push_back(&call);
            if (!many.empty()) evidence.beside.push_back(largest(untold_of(many, truth, call.arguments, right)));
        }
    }
    return evidence;
}

// Is each number that is wrong in the call zero, not finite, or one of those that were given?
bool tells_little(const Call& call, const Numbers& right) {
    if (call.result.size() != right.size()) return false;
    for (std::size_t i = 0; i < right.size(); ++i) {
        const double found = call.result[i];
        const bool is_given = std::find(call.arguments.begin(), call.arguments.end(), found) != call.arguments.end();
        if (found != right[i] && found != 0 && std::isfinite(found) && !is_given) return false;
    }
    return true;
}

bool tells_little(const Evidence& evidence) {
    std::size_t little = 0;
    for (std::size_t i = 0; i < evidence.wrong.size(); ++i)
        little += tells_little(*evidence.wrong[i], evidence.truth[i]);
    return 2 * little > evidence.wrong.size();
}

// The share of calls in which the mistake does as the learner does.
struct Fit {
    double wrong_region = 0, where_right = 0;
    double excused = 0;  // of those in right calls: there the mistake makes no number, and the learner may have a guard
    bool is_denied = false;  // it would have evidence in right calls, too, and they are many beside the wrong ones
    // Of yes and no, or of two counts, many agree by chance.
    bool good(bool counted, bool little) const {
        return !is_denied && wrong_region >= (little ? 0.99 : 0.97) && where_right >= (counted || little ? 0.98 : 0.9);
    }
    // With a guard more or less, or in part of the calls another mistake beside it.
    bool fair() const { return !is_denied && wrong_region >= 0.85 && where_right >= 0.75; }
};

Fit fit_of(const Mistake& mistake, const Evidence& evidence) {
    Fit fit;
    for (std::size_t i = 0; i < evidence.wrong.size(); ++i) {
        const Call& call = *evidence.wrong[i];
        fit.wrong_region +=
            errs_alike(mistake.made.answer(call.arguments), call.result, evidence.truth[i], evidence.roundoff[i]);
        const double asked = double(i + 1), missed = asked - fit.wrong_region;
        if (6 * missed > double(evidence.wrong.size() + 6) || (asked > 50 && 4 * missed > 3 * asked))
            return {};  // too many
    }
    const bool has_numbers = std::all_of(evidence.wrong.begin(), evidence.wrong.end(),
                                         [](const Call* call) { return is_finite(call->result); });
    for (std::size_t i = 0; i < evidence.right.size(); ++i) {
        const Call* call = evidence.right[i];
        const double beside = evidence.beside.empty() ? 0 : evidence.beside[i];
        const Numbers answer = mistake.made.answer(call->arguments);
        const bool is_excused = has_numbers && !is_finite(answer);
        fit.where_right += is_excused || apart(call->result, answer) <= 1e-9 * size_of(call->result) + beside;
        fit.excused += is_excused;
    }
    fit.is_denied = 2 * (double(evidence.right.size()) - fit.where_right) > double(evidence.wrong.size());
    fit.wrong_region /= double(evidence.wrong.size());
    fit.excused /= std::max(1.0, double(evidence.right.size()));
    fit.where_right = evidence.right.empty() ? 1 : fit.where_right / double(evidence.right.size());
    return fit;
}

// Of many calls some, evenly: for what asks much of each.
Evidence some_of(Evidence evidence, std::size_t most) {
    const std::size_t step = 1 + evidence.wrong.size() / most, step_right = 1 + evidence.right.size() / most;
    Evidence some;
    some.tells_little = evidence.tells_little;
    for (std::size_t i = 0; i < evidence.wrong.size(); i += step) {
        some.wrong.push_back(evidence.wrong[i]);
        some.truth.push_back(std::move(evidence.truth[i]));
        some.roundoff.push_back(std::move(evidence.roundoff[i]));
    }
    for (std::size_t i = 0; i < evidence.right.size(); i += step_right) some.right.push_back(evidence.right[i]);
    return some;
}

// Are half of the wrong answers wrong by a small part of each number? Lost digits are; but not all of them need be.
bool has_right_digits(const Evidence& evidence) {
    std::size_t near = 0;
    for (std::size_t call = 0; call < evidence.wrong.size(); ++call) {
        const Numbers &found = evidence.wrong[call]->result, &right = evidence.truth[call],
                      &roundoff = evidence.roundoff[call];
        bool all = found.size() == right.size();
        for (std::size_t i = 0; all && i < right.size(); ++i)
            all = std::fabs(found[i] - right[i]) <= 1e-2 * std::fabs(right[i]) + roundoff[i];
        near += all;
    }
    return 2 * near >= evidence.wrong.size();
}

// Is the mistake one that loses digits, and does the learner lose about as many? Which, another order of operations
// decides: so the two are off by other amounts of one size.
bool loses_as_many_digits(const Mistake& mistake, const Truth& truth, const Evidence& evidence) {
    std::size_t fits = 0, many = 0;
    for (std::size_t i = 0; i < evidence.wrong.size(); ++i) {
        const Call& call = *evidence.wrong[i];
        double lost = 0, lost_nearer = 0, least = HUGE_VAL;
        for (unsigned variation = 1; variation <= 8; ++variation) {
            const double one = largest(lost_by(mistake.made, truth, call.arguments, variation));
            lost = std::max(lost, one);
            least = std::min(least, one);
            lost_nearer =
                std::max(lost_nearer, largest(lost_within(1e-4, mistake.made, truth, call.arguments, variation)));
        }
        const double gap = apart(call.result, evidence.truth[i]);
        // What is always off by as much is off by more than roundoff: there the two must agree. So is what is off by
        // less, the nearer one looks: that is a guard that lies on one side or the other.
        const bool is_roundoff = lost < HUGE_VAL && least < 0.7 * lost && lost <= 5 * lost_nearer;
        const bool agrees = gap < HUGE_VAL && errs_alike(mistake.made.answer(call.arguments), call.result,
                                                         evidence.truth[i], evidence.roundoff[i]);
        fits += agrees || (is_roundoff && gap <= 4 * lost);
        many += agrees || (is_roundoff && gap >= 0.05 * lost);
    }
    std::size_t alike = 0;
    for (const Call* call : evidence.right)
        alike += apart(call->result, mistake.made.answer(call->arguments)) <= 1e-8 * size_of(call->result);
    return double(fits) >= 0.9 * double(evidence.wrong.size()) && double(many) >= 0.6 * double(evidence.wrong.size()) &&
           double(alike) >= 0.75 * double(evidence.right.size()) &&
           2 * (evidence.right.size() - alike) <= evidence.wrong.size();
}

// Where hardly anything is wrong by much, a property has seen more: what differs by less, but not by roundoff alone.
Evidence differing(const Truth& truth, const std::vector<Call>& calls, bool are_many, const std::string& many = {}) {
    Evidence evidence;
    for (const double least : {1e-6, 1e-9, 1e-12}) {
        if (least < 1e-6 && !evidence.wrong.empty() && !are_many) break;
        Evidence differs = sorted(truth, calls, least, many);
        const bool is_many = differs.wrong.size() >= 10;
        if (evidence.wrong.empty() || is_many) evidence = std::move(differs);
        if (is_many) break;
    }
    evidence.tells_little = tells_little(evidence);
    return evidence;
}

// The mistake that does as the learner does, and the one that nearly does.
std::pair<std::string, std::string> mistake_of(const std::string& exercise, const Evidence& evidence, bool counted) {
    std::string best, fair;
    double most = 0, most_fair = 0;
    for (const Mistake& mistake : registered(exercise).mistakes) {
        const Fit fit = fit_of(mistake, evidence);
        const double all = fit.wrong_region + fit.where_right - fit.excused;
        if (fit.good(counted, evidence.tells_little) && all > most) most = all, best = mistake.name;
        if (fit.fair() && all > most_fair) most_fair = all, fair = mistake.name;
    }
    return {best, fair};
}

}  // namespace

Diagnosis diagnose(const std::string& exercise, const Truth& truth, const std::vector<Call>& calls) {
    const bool are_many = registered(exercise).within.relative == many_are_right;
    Evidence evidence = differing(truth, calls, are_many);
    if (evidence.wrong.empty()) return {};
    const bool counted = std::all_of(calls.begin(), calls.end(), [](const Call& call) {
        return call.result.size() == 1 && call.result[0] == std::floor(call.result[0]);
    });
    auto [best, fair] = mistake_of(exercise, evidence, counted);
    if (best.empty() && are_many) {
        const Evidence told = differing(truth, calls, are_many, exercise);
        if (!told.wrong.empty()) best = mistake_of(exercise, told, counted).first;
    }
    if (best.empty()) best = is_negated(calls, evidence) ? "negated" : generic_mistake_of(evidence);
    if (!best.empty()) return {.mistake = best};
    const auto slips = slips_of(exercise, evidence, counted);
    if (slips && !slips->empty()) return {.slips = *slips};
    if (!counted) best = changed(truth, evidence);
    const bool yes_or_no = std::all_of(calls.begin(), calls.end(),
                                       [](const Call& call) { return call.result[0] == 0 || call.result[0] == 1; });
    if (counted && !yes_or_no) best = off_by_one(evidence);
    if (!best.empty()) return {.mistake = best};
    const Diagnosis region = wrong_region(truth, calls, evidence);
    // Of whole numbers too many agree by chance with one of so many pairs.
    if (counted) return is_near_thing(truth, evidence) ? Diagnosis{.mistake = "near"} : region;
    const Evidence some = some_of(std::move(evidence), 150);
    if (has_right_digits(some))
        for (const Mistake& mistake : registered(exercise).mistakes)
            if (loses_as_many_digits(mistake, truth, some)) return {.mistake = mistake.name};
    const std::string how = inexact(truth, some);
    if (!how.empty() && how != "digits") return {.mistake = how};
    const Diagnosis told = region.empty() ? Diagnosis{.mistake = how} : region;
    if (some.tells_little || !slips) return told;
    if (!fair.empty()) return {.mistake = fair};
    const std::vector<std::string> two = two_slips_of(exercise, some);
    return two.empty() ? told : Diagnosis{.slips = two};
}

bool is_case_of(const std::string& exercise, const Truth& truth, const Diagnosis& diagnosis, const Call& call) {
    if (diagnosis.empty()) return true;
    const Registered& known = registered(exercise);
    const Numbers right = truth.answer(call.arguments), roundoff = roundoff_of(truth, call.arguments, right);
    const bool is_wrong = !errs_alike(right, call.result, right, roundoff);
    constexpr std::size_t as_all = 10;  // calls that are wrong were this one
    const Evidence one{{as_all, &call}, {}, {as_all, right}, {as_all, roundoff}};
    const Numbers untold =
        known.within.relative == many_are_right ? untold_of(exercise, truth, call.arguments, right) : roundoff;
    for (const Mistake& mistake : known.mistakes) {
        if (mistake.name != diagnosis.mistake) continue;
        const Numbers made = mistake.made.answer(call.arguments);
        const bool is_its_own =
            !call.right &&
            apart(made, call.result) <= 1e-6 * apart(call.result, right);  // a small number beside a large one
        return is_its_own || (is_wrong && (errs_alike(made, call.result, right, untold) ||
                                           loses_as_many_digits(mistake, truth, one)));
    }
    if (!is_wrong) return false;
    if (!diagnosis.slips.empty()) return is_case_of_slips(exercise, diagnosis.slips, one);
    if (diagnosis.mistake.empty()) return is_case_of_region(diagnosis, truth, call);
    return is_case_of_generic_mistake(diagnosis.mistake, truth, one);
}

}  // namespace checker
