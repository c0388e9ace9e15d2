// Where no mistake and no slip fits: where is the answer wrong, and what is it there? Nothing of this is a guess.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "evidence.hpp"

namespace checker {

namespace {

constexpr std::size_t few = 6;    // calls could be so by chance
constexpr std::size_t many = 20;  // tell where a limit is
constexpr std::size_t most_numbers = 12;

struct Region {
    const char* name;
    std::size_t argument;
    bool (*holds)(double);

    bool has(const Numbers& given) const { return holds(given[argument]); }
};

// Of each number of the arguments, counted from 0; the length of the first list is the last of them.
std::vector<Region> regions(std::size_t leading, bool has_list) {
    std::vector<Region> all;
    for (std::size_t i = 0; i < std::min(leading, most_numbers); ++i) {
        all.push_back({"zero", i, [](double x) { return x == 0; }});
        all.push_back({"negative", i, [](double x) { return x < 0; }});
        all.push_back({"positive", i, [](double x) { return x > 0; }});
    }
    if (has_list && leading <= most_numbers) all.push_back({"empty", leading, [](double size) { return size == 0; }});
    return all;
}

// As the learner reads it.
std::string short_number(double number) {
    char text[24];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

// Is one of the numbers above all those with which nearly all of the answers are right, or below? The limit is the
// least with which it is wrong. "nonzero" where all the others are zero, or next to nothing beside those with which it
// is wrong.
Diagnosis beyond(const Truth& truth, const Evidence& evidence) {
    if (evidence.wrong.size() < many || evidence.right.size() < many) return {};
    Diagnosis where;
    for (std::size_t i = 0; i < std::min(truth.leading, most_numbers); ++i)
        for (const bool above : {true, false}) {
            double limit = HUGE_VAL;
            for (const Call* call : evidence.wrong)
                limit = std::min(limit, above ? call->arguments[i] : -call->arguments[i]);
            const auto is_beyond = [&](const Call* call) {
                return (above ? call->arguments[i] : -call->arguments[i]) >= limit;
            };
            const auto right_beyond =
                std::size_t(std::count_if(evidence.right.begin(), evidence.right.end(), is_beyond));
            if (20 * right_beyond > evidence.wrong.size() || evidence.right.size() - right_beyond < many) continue;
            if (!where.empty()) return {};  // which of the two?
            Numbers sizes;
            for (const Call* call : evidence.wrong) sizes.push_back(std::fabs(call->arguments[i]));
            std::nth_element(sizes.begin(), sizes.begin() + long(sizes.size() / 2), sizes.end());
            const double nothing = std::min(limit, 1e-5 * sizes[sizes.size() / 2]);
            const auto is_zero = [&](const Call* call) {
                return is_beyond(call) || std::fabs(call->arguments[i]) <= nothing;
            };
            if (limit > 0 && std::all_of(evidence.right.begin(), evidence.right.end(), is_zero))
                where = {.region = "nonzero", .argument = i};
            else
                where = {
                    .region = above ? "above" : "below", .argument = i, .limit = short_number(above ? limit : -limit)};
        }
    return where;
}

// Is it in every wrong call one and the same of the numbers, or rows of numbers, that were given?
bool is_given(const Evidence& evidence) {
    const std::size_t size = evidence.wrong[0]->result.size(), most = evidence.wrong[0]->arguments.size();
    for (std::size_t at = 0; at + size <= most; ++at) {
        const auto is_there = [&](const Call* call) {
            const Numbers& given = call->arguments;
            return call->result.size() == size && at + size <= given.size() &&
                   is_same(Numbers(given.begin() + long(at), given.begin() + long(at + size)), call->result);
        };
        if (std::all_of(evidence.wrong.begin(), evidence.wrong.end(), is_there)) return true;
    }
    return false;
}

// What it is in every wrong call, where that is one thing: "given", or a whole number.
std::string always(const Evidence& evidence) {
    const Numbers& first = evidence.wrong[0]->result;
    const auto is_first = [&](const Call* call) { return call->result == first; };
    if (std::all_of(evidence.wrong.begin(), evidence.wrong.end(), is_first)) {
        const bool is_zero = std::all_of(first.begin(), first.end(), [](double x) { return x == 0; });
        if (is_zero || (first.size() == 1 && first[0] == std::floor(first[0]) && std::fabs(first[0]) < 1000)) {
            char text[16];
            std::snprintf(text, sizeof text, "%.0f", is_zero ? 0 : first[0]);
            return text;
        }
    }
    return is_given(evidence) ? "given" : "";
}

}  // namespace

Diagnosis wrong_region(const Truth& truth, const std::vector<Call>& calls, const Evidence& evidence) {
    if (evidence.wrong.size() < few || evidence.right.size() < few) return {};
    Diagnosis where;
    bool two = false;
    for (const Region& region : regions(truth.leading, truth.has_list)) {
        const auto inside = [&](const Call* call) { return region.has(call->arguments); };
        if (!std::all_of(evidence.wrong.begin(), evidence.wrong.end(), inside)) continue;
        const auto right_inside = std::size_t(std::count_if(evidence.right.begin(), evidence.right.end(), inside));
        // What holds nearly everywhere, or is mostly right there, says nothing.
        if (2 * right_inside > evidence.wrong.size() ||
            evidence.right.size() - right_inside < std::max(few, evidence.wrong.size() / 4))
            continue;
        two = !where.empty();
        if (two) break;
        where = {.region = region.name, .argument = region.argument};
    }
    if (two)
        where = {};
    else if (where.empty())
        where = beyond(truth, evidence);
    where.value = always(evidence);
    // An answer that is always so tells nothing of where it is wrong.
    const bool else_too = std::all_of(calls.begin(), calls.end(),
                                      [&](const Call& call) { return call.result == evidence.wrong[0]->result; });
    return else_too ? Diagnosis() : where;
}

bool is_case_of_region(const Diagnosis& diagnosis, const Truth& truth, const Call& call) {
    const Evidence one{{&call}, {}, {}, {}};
    const std::string& value = diagnosis.value;
    if (!value.empty() && !(value == "given" ? is_given(one) : always(one) == value)) return false;
    const double number = call.arguments[diagnosis.argument];
    for (const Region& region : regions(truth.leading, truth.has_list))
        if (region.name == diagnosis.region && region.argument == diagnosis.argument) return region.holds(number);
    if (diagnosis.region == "nonzero") return number != 0;
    if (diagnosis.region.empty()) return true;
    const double limit = std::strtod(diagnosis.limit.c_str(), nullptr),
                 read = std::strtod(short_number(number).c_str(), nullptr);  // as the limit is told
    return diagnosis.region == "above" ? read >= limit : read <= limit;
}

bool is_near_thing(const Truth& truth, const Evidence& evidence) {
    constexpr double near = 3e-3;
    constexpr unsigned tries = 24;
    const auto flips = [&](const Numbers& arguments) {
        const Numbers right = truth.answer(arguments);
        for (unsigned variation = 1; variation <= tries; ++variation)
            if (truth.nudged(arguments, variation, near) != right) return true;
        return false;
    };
    if (evidence.wrong.size() < few || evidence.right.size() < few) return false;
    std::size_t asked = 0, near_ones = 0;
    for (std::size_t i = 0; i < evidence.wrong.size(); i += 1 + evidence.wrong.size() / 100, ++asked)
        if (!flips(evidence.wrong[i]->arguments)) return false;
    asked = 0;
    for (std::size_t i = 0; i < evidence.right.size(); i += 1 + evidence.right.size() / 100, ++asked)
        near_ones += flips(evidence.right[i]->arguments);
    return 3 * near_ones < asked;
}

}  // namespace checker
