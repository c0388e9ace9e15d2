// Which slip is it?

#include <algorithm>
#include <cmath>
#include <utility>

#include "evidence.hpp"
#include "slips.hpp"

namespace checker {

namespace {

using slip::Form;
using slip::Made;

constexpr long most_work =
    12'000'000;                  // places that may be passed while a slip, or two, are looked for: a tenth of a second
constexpr std::size_t few = 16;  // calls are enough to tell most slips from the learner's

// How many calls answer as the learner does, and whether enough.
struct Score {
    std::size_t alike = 0;
    bool good = false;
};

// A call, and how many places the answer passes in it as it is written.
struct Weighed {
    const Call* call;
    const Numbers* truth;  // where it is wrong
    const Numbers* roundoff;
    long places;
};

// An answer beside the calls of a check.
class Fitting {
public:
    Fitting(const Answer& answer, const Evidence& evidence, bool counted, bool is_solution = true)
        : answer_(answer),
          is_strict_(evidence.tells_little),
          share_right_(counted ? 100 : 20),
          least_(std::min(few, evidence.wrong.size())) {
        // Of a yes and a no many must be asked; but then they are short.
        const std::size_t most = counted && is_solution ? 2000 : 300;
        const std::size_t step = 1 + evidence.wrong.size() / most, step_right = 1 + evidence.right.size() / most;
        const auto is_long = [begin = slip::work()](long share) {
            return slip::work() - begin > most_work / 4 * share;
        };
        for (std::size_t i = 0; i < evidence.wrong.size() && !is_long(1); i += step)
            wrong_.push_back({evidence.wrong[i], &evidence.truth[i], &evidence.roundoff[i],
                              slip::note(answer, evidence.wrong[i]->arguments, slips_)});
        for (std::size_t i = 0; i < evidence.right.size() && !is_long(2); i += step_right)
            right_.push_back(
                {evidence.right[i], nullptr, nullptr, slip::note(answer, evidence.right[i]->arguments, slips_)});
        for (std::size_t i = 0; i < wrong_.size(); i += 1 + wrong_.size() / few) few_.push_back(wrong_[i]);
        // The shortest first: most slips show at once that they are not the learner's.
        for (auto* calls : {&few_, &wrong_, &right_})
            std::stable_sort(calls->begin(), calls->end(),
                             [](const Weighed& a, const Weighed& b) { return a.places < b.places; });
    }

    const std::vector<Made>& slips() const { return slips_; }

    Score of(const Made& first, const Made* second) const {
        if (wrong_.size() < least_) return {};
        std::size_t missed = 0, off = 0;
        // Two variables that are taken for others can do nearly anything.
        const bool is_strict = is_strict_ || (second && first.form == Form::variable);
        if (!fits(few_, first, second, is_strict ? 0 : few_.size() / 8, missed)) return {};
        missed = 0;
        if (!fits(wrong_, first, second, is_strict ? 0 : wrong_.size() / 33, missed)) return {};
        // Where it would show in right calls, too, these must be few beside the wrong ones.
        if (!fits(right_, first, second, std::min(right_.size() / (is_strict ? 200 : share_right_), wrong_.size() / 2),
                  off))
            return {};
        return {wrong_.size() + right_.size() - missed - off, true};
    }

private:
    bool fits(const std::vector<Weighed>& calls, const Made& first, const Made* second, std::size_t may_miss,
              std::size_t& missed) const {
        for (const Weighed& each : calls) {
            const Numbers made = slip::answered(answer_, each.call->arguments, first, second, 1000 + 30 * each.places);
            const Numbers& found = each.call->result;
            // Where all is right, there may be a guard against what is no number.
            missed += each.truth ? !errs_alike(made, found, *each.truth, *each.roundoff)
                                 : !is_same(made, found) && (made.empty() || is_finite(made));
            if (missed > may_miss) return false;
        }
        return true;
    }

    const Answer& answer_;
    bool is_strict_;
    std::size_t share_right_, least_;
    std::vector<Made> slips_;
    std::vector<Weighed> few_, wrong_, right_;
};

// Of what is not finite nothing can be told.
bool is_no_number(const Evidence& evidence) {
    std::size_t none = 0;
    for (const Call* call : evidence.wrong)
        none += std::any_of(call->result.begin(), call->result.end(), [](double x) { return !std::isfinite(x); });
    return 2 * none > evidence.wrong.size();
}

bool is_enough(const Evidence& evidence, bool counted) { return evidence.wrong.size() >= (counted ? 4u : 3u); }

}  // namespace

namespace slip {

const char* name_of(Form form) {
    static constexpr std::array names{"sign",        "twice",    "half",      "term",     "factor", "function",
                                      "upside_down", "power",    "exchanged", "reversed", "edge",   "guard",
                                      "absolute",    "limit",    "joined",    "brackets", "line",   "loop",
                                      "variable",    "constant", "degrees",   "single",   "none"};
    return names[static_cast<std::size_t>(form)];
}

}  // namespace slip

bool is_same(const Numbers& made, const Numbers& found) {
    if (made.size() != found.size()) return false;
    const double size = size_of(found);
    for (std::size_t i = 0; i < made.size(); ++i)
        if (made[i] != found[i] && (std::isfinite(made[i]) || std::isfinite(found[i])) &&
            !(std::isfinite(made[i] - found[i]) &&
              std::fabs(made[i] - found[i]) <= 1e-9 * std::max(std::fabs(found[i]), 1e-3 * size)))
            return false;
    return true;
}

bool errs_alike(const Numbers& made, const Numbers& found, const Numbers& right, const Numbers& roundoff) {
    if (made.size() != found.size()) return false;
    if (right.size() != found.size()) return is_same(made, found);
    const double size = size_of(right);
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (made[i] == found[i] || (!std::isfinite(made[i]) && !std::isfinite(found[i]))) continue;
        const double gap = std::fabs(found[i] - right[i]), miss = std::fabs(made[i] - found[i]);
        const double least = 1e-13 * std::max({size, std::fabs(found[i]), std::fabs(right[i])});
        if (!std::isfinite(miss) || !(miss <= 1e-3 * gap + std::max(least, roundoff[i]))) return false;
    }
    return true;
}

// The solution first: its slips are those that one thinks of. The conditions and variables of another way to write it
// are not the learner's. Where one part twice as large, and another half as large, do the same, neither is told; nor
// where two ways to write it disagree.
std::optional<std::vector<std::string>> slips_of(const std::string& exercise, const Evidence& evidence, bool counted) {
    const std::vector<std::string> none;
    if (!is_enough(evidence, counted) || is_no_number(evidence)) return none;
    const long begin = slip::work();
    bool is_solution = true;
    Form told = Form::none;
    for (const Answer& answer : registered(exercise).slips) {
        if (slip::work() - begin > most_work) break;
        const Fitting fitting(answer, evidence, counted, is_solution);
        std::vector<Made> slips = fitting.slips();
        slips.push_back({slip::single_site, 1, Form::single});
        std::size_t most = 0;
        Made best{0, 0, Form::none};
        bool are_two = false;
        for (const Made& made : slips) {
            // Whole numbers agree by chance with what an answer of another kind does.
            if (!is_solution && (counted || made.form > slip::last_of_arithmetic) && made.form != Form::single)
                continue;
            if (slip::work() - begin > most_work) break;
            const Score score = fitting.of(made, nullptr);
            if (!score.good || score.alike < most) continue;
            if (score.alike > most)
                best = made, are_two = false;
            else if (made.form != best.form && made.site != best.site)
                are_two |= std::minmax(made.form, best.form) == std::minmax(Form::twice, Form::half);
            if (made.form < best.form) best = made;
            most = score.alike;
        }
        if (are_two || (told != Form::none && best.form != Form::none && best.form != told)) return {};
        if (best.form != Form::none) told = best.form;
        if (is_solution && told != Form::none) break;
        is_solution = false;
    }
    return told == Form::none ? none : std::vector<std::string>{slip::name_of(told)};
}

// Of the solution alone: two slips in another way to write it could explain nearly everything.
std::vector<std::string> two_slips_of(const std::string& exercise, const Evidence& evidence) {
    if (evidence.wrong.size() < 10 || registered(exercise).slips.empty()) return {};
    const long begin = slip::work();
    const Fitting fitting(registered(exercise).slips.front(), evidence, false);
    std::vector<Made> slips = fitting.slips();
    std::erase_if(slips, [](const Made& made) { return made.form > Form::factor && made.form != Form::variable; });
    std::pair best{Form::none, Form::none};
    for (std::size_t a = 0; a < slips.size(); ++a)
        for (std::size_t b = a + 1; b < slips.size(); ++b) {
            if (slip::work() - begin > most_work) break;
            // A variable taken for another is taken so everywhere; beside another slip it would explain too much.
            if (slips[a].site == slips[b].site ||
                (slips[a].form == Form::variable) != (slips[b].form == Form::variable))
                continue;
            if (!fitting.of(slips[a], &slips[b]).good) continue;
            best = std::min(best, std::pair<Form, Form>(std::minmax(slips[a].form, slips[b].form)));
        }
    if (best.first == Form::none) return {};
    return {slip::name_of(best.first), slip::name_of(best.second)};
}

bool is_case_of_slips(const std::string& exercise, const std::vector<std::string>& forms, const Evidence& one) {
    const Call& call = *one.wrong[0];
    for (const Answer& answer : registered(exercise).slips) {
        std::vector<Made> slips;
        const long places = slip::note(answer, call.arguments, slips);
        slips.push_back({slip::single_site, 1, Form::single});
        const auto answers_so = [&](const Made& first, const Made* second) {
            const Numbers made = slip::answered(answer, call.arguments, first, second, 1000 + 30 * places);
            return errs_alike(made, call.result, one.truth[0], one.roundoff[0]);
        };
        for (const Made& a : slips) {
            if (forms[0] != slip::name_of(a.form)) continue;
            if (forms.size() == 1 && answers_so(a, nullptr)) return true;
            for (const Made& b : slips)
                if (forms.size() == 2 && a.site != b.site && forms[1] == slip::name_of(b.form) && answers_so(a, &b))
                    return true;
        }
        if (forms.size() == 2) return false;  // two at once are looked for in the solution alone
    }
    return false;
}

}  // namespace checker
