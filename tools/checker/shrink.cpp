// Of what has failed, the case with the least to read. As property-based testers find it: not by other arguments, for
// which of them a task allows only its tests know, but by other draws of these tests.

#include <algorithm>
#include <cmath>

#include "evidence.hpp"
#include "last_comparison.hpp"

namespace checker {

namespace {

constexpr unsigned streams = 40;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Is it seen at a glance that the result is not the right one?
bool is_off_by_much(const Numbers& result, const Numbers& right) {
    if (result.size() != right.size()) return true;
    for (std::size_t i = 0; i < right.size(); ++i)
        if (std::fabs(result[i] - right[i]) > 1e-6 * std::fabs(right[i])) return true;
    return false;
}

// As Catch2 asks for one test.
std::string by_name(const std::string& property) {
    std::string name;
    for (const char c : property)
        name += (c == ',' || c == '[' || c == '"' || c == '\\' || c == '*' || c == '~' ? "\\" : "") + std::string(1, c);
    return name;
}

}  // namespace

std::size_t long_numbers(const std::string& text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_digit(text[i])) continue;
        std::size_t digits = 0, zeros = 0;  // those at the end: of 1200 two digits count
        for (; i < text.size() && (is_digit(text[i]) || text[i] == '.'); ++i) {
            if (text[i] == '.' || (text[i] == '0' && digits == 0)) continue;
            zeros = text[i] == '0' ? zeros + 1 : 0;
            ++digits;
        }
        count += digits - zeros > 4;
        if (i < text.size() && text[i] == 'e')
            for (i += 2; i < text.size() && is_digit(text[i]);) ++i;
    }
    return count;
}

// What a call costs to read: its characters, what is long to work out by hand, and a wrong result that looks right.
double Session::effort_of(const Call& call) const {
    const std::string text = spoken_->arguments(call.arguments, digits_for(call));
    const bool looks_right =
        !call.right && verdict_.kind == Kind::wrong && !is_off_by_much(call.result, truth_.answer(call.arguments));
    return double(text.size() + call.arguments.size() + 10 * long_numbers(text) + (looks_right ? 40 : 0));
}

Numbers Session::call_in_search(const Numbers& arguments, const Spoken& spoken) {
    Search& search = *search_;
    if (search.is_over || search.calls.size() == search.most) {
        search.is_over = true;
        throw NoAnswer(Kind::too_slow, "");
    }
    Numbers result;
    try {
        result = search.answer(arguments);
    } catch (...) {
        search.is_over = true;
        throw;
    }
    search.is_over = !spoken.is_result(result);
    if (search.is_over) throw NoAnswer(Kind::left_early, "");
    const bool finite = is_finite(result);
    search.calls.push_back({arguments, result, finite && is_right(truth_, arguments, result, within_, spoken)});
    if (!finite) throw NoAnswer(Kind::not_finite, "");
    return result;
}

Session::Search Session::searched(const std::string& property, const Answer& answer, unsigned stream,
                                  std::size_t most) {
    search_ = Search{answer, stream, most, {}, {}, true, false};
    begin_comparisons();
    run(by_name(property) + "[" + exercise_ + "]");
    Search found = std::move(*search_);
    search_.reset();
    return found;
}

// The answer is asked at most as often again as in the check. What the course's own answer fails in, too, is no case.
// A case of the mistake that is named goes before all others.
void Session::shrink(const std::string& property) {
    struct Found {
        Call call;
        std::string said;
        double effort = HUGE_VAL;
    };
    const bool is_finite_asked = verdict_.kind == Kind::not_finite, by_call = shown_ || is_finite_asked;
    const bool all_hold = property != verdict_.property;
    Call& best = shown_ && !is_finite_asked ? *shown_ : doubted_ && !is_finite_asked ? *doubted_ : last_;
    const Diagnosis diagnosis = verdict_.diagnosis;
    Found any, of_name;
    const auto take = [&](const Call& call, const std::string& said) {
        const double effort = effort_of(call);
        if (effort < of_name.effort && is_case_of(exercise_, truth_, diagnosis, call)) of_name = {call, said, effort};
        if (effort < any.effort) any = {call, said, effort};
    };
    const auto take_wrong = [&](const std::vector<Call>& calls) {
        for (const Call& call : calls)
            if (!call.right && is_finite(call.result) != is_finite_asked) take(call, verdict_.detail);
    };
    take(best, verdict_.detail);
    if (all_hold) take_wrong(calls_);
    std::size_t left = std::max<std::size_t>(calls_.size(), 200);
    for (unsigned stream = of_name.effort < HUGE_VAL ? 1 : 0; stream <= streams; ++stream) {
        const Search found = searched(property, answer_, stream, left);
        if (found.is_over) break;
        left -= found.calls.size();
        if (all_hold || (by_call && !found.holds)) take_wrong(found.calls);
        if (by_call || found.holds || found.calls.empty()) continue;
        const Call seen = found.doubted ? *found.doubted : found.calls.back();
        if (!is_finite(seen.result) || effort_of(seen) >= of_name.effort) continue;
        const std::string said = kept_comparison();
        const Search right = searched(property, truth_.answer, stream, 100'000);
        if (right.holds && !right.doubted) take(seen, said);
    }
    const bool is_named = of_name.effort < HUGE_VAL;
    best = is_named ? of_name.call : any.call;
    verdict_.detail = is_named ? of_name.said : any.said;
}

}  // namespace checker
