// Which slip is it?

#include <cmath>
#include <map>

#include "shown.hpp"
#include "slips.hpp"

namespace checker {

namespace {

using slip::Form;
using slip::Made;

std::map<std::string, std::vector<Answer>>& known() {
    static std::map<std::string, std::vector<Answer>> answers;
    return answers;
}

constexpr long most_work = 100'000'000;  // places that may be passed while two slips are looked for: a second

// How many calls answer as the learner does, and whether enough.
struct Score {
    std::size_t alike = 0;
    bool good = false;
};

class Fitting {
public:
    Fitting(const Answer& answer, const Shown& shown, bool counted)
        : answer_(answer),
          shown_(shown),
          may_miss_wrong_(shown.wrong.size() / 33),
          may_miss_right_(shown.right.size() / (counted ? 100 : 20)) {}

    Score of(const Made& first, const Made* second) const {
        std::size_t missed = 0;
        for (std::size_t i = 0; i < shown_.wrong.size(); ++i) {
            const Call& call = *shown_.wrong[i];
            missed += !errs_alike(slip::answered(answer_, call.arguments, first, second), call.result, shown_.truth[i]);
            if (missed > may_miss_wrong_) return {};
        }
        std::size_t off = 0;
        for (const Call* call : shown_.right) {
            off += !is_same(slip::answered(answer_, call->arguments, first, second), call->result);
            if (off > may_miss_right_) return {};
        }
        return {shown_.wrong.size() + shown_.right.size() - missed - off, true};
    }

private:
    const Answer& answer_;
    const Shown& shown_;
    std::size_t may_miss_wrong_, may_miss_right_;
};

std::vector<Made> slips_in(const Answer& answer, const Shown& shown) {
    std::vector<Made> slips;
    for (const Call* call : shown.wrong) slip::note(answer, call->arguments, slips);
    std::size_t left = 50;
    for (const Call* call : shown.right)
        if (left-- > 0) slip::note(answer, call->arguments, slips);
        else break;
    return slips;
}

bool is_enough(const Shown& shown, bool counted) { return shown.wrong.size() >= (counted ? 4u : 3u); }

// Of many calls a few, evenly: what fails there need not be held beside all.
Shown some_of(const Shown& shown, std::size_t most) {
    Shown some;
    const std::size_t step = (shown.wrong.size() + most - 1) / most, step_right = (shown.right.size() + most - 1) / most;
    for (std::size_t i = 0; i < shown.wrong.size(); i += step) some.wrong.push_back(shown.wrong[i]), some.truth.push_back(shown.truth[i]);
    for (std::size_t i = 0; i < shown.right.size(); i += std::max<std::size_t>(1, step_right)) some.right.push_back(shown.right[i]);
    return some;
}

}  // namespace

bool know_slips(const std::string& exercise, std::vector<Answer> answers) {
    return known().emplace(exercise, std::move(answers)).second;
}

const std::vector<Answer>& slips_of(const std::string& exercise) { return known()[exercise]; }

namespace slip {

const char* name_of(Form form) {
    static constexpr std::array names{"sign", "twice", "half", "term", "factor", "function", "upside_down", "power", "exchanged", "reversed", "edge",
                                      "guard", "loop", "variable", "constant", "degrees", "single", "none"};
    return names[static_cast<std::size_t>(form)];
}

}  // namespace slip

bool is_same(const Numbers& made, const Numbers& found) {
    if (made.size() != found.size()) return false;
    double size = 0;
    for (const double number : found) size = std::max(size, std::isfinite(number) ? std::fabs(number) : 0);
    for (std::size_t i = 0; i < made.size(); ++i)
        if (made[i] != found[i] && (std::isfinite(made[i]) || std::isfinite(found[i])) &&
            !(std::fabs(made[i] - found[i]) <= 1e-9 * std::max(std::fabs(found[i]), 1e-3 * size)))
            return false;
    return true;
}

bool errs_alike(const Numbers& made, const Numbers& found, const Numbers& right) {
    if (made.size() != found.size()) return false;
    if (right.size() != found.size()) return is_same(made, found);
    double size = 0;
    for (std::size_t i = 0; i < made.size(); ++i) size = std::max(size, std::isfinite(right[i]) ? std::fabs(right[i]) : 0);
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (made[i] == found[i] || (!std::isfinite(made[i]) && !std::isfinite(found[i]))) continue;
        const double gap = std::fabs(found[i] - right[i]), miss = std::fabs(made[i] - found[i]);
        const double roundoff = 1e-13 * std::max({size, std::fabs(found[i]), std::fabs(right[i])});
        if (!std::isfinite(miss) || !(miss <= 1e-3 * gap + roundoff)) return false;
    }
    return true;
}

// The solution first: its slips are those that one thinks of. The conditions and variables of another way to write it
// are not the learner's.
std::string slip_of(const std::string& exercise, const Shown& shown, bool counted) {
    if (!is_enough(shown, counted)) return {};
    bool is_solution = true;
    for (const Answer& answer : slips_of(exercise)) {
        const Fitting fitting(answer, shown, counted);
        std::vector<Made> slips = slips_in(answer, shown);
        slips.push_back({slip::single_site, 1, Form::single});
        std::size_t most = 0;
        Form form = Form::none;
        for (const Made& made : slips) {
            if (!is_solution && made.form > slip::last_of_arithmetic && made.form != Form::single) continue;
            const Score score = fitting.of(made, nullptr);
            if (!score.good || score.alike < most) continue;
            form = score.alike > most ? made.form : std::min(form, made.form);
            most = score.alike;
        }
        if (form != Form::none) return std::string("slip_") + slip::name_of(form);
        is_solution = false;
    }
    return {};
}

std::string two_slips_of(const std::string& exercise, const Shown& shown) {
    if (shown.wrong.size() < 10) return {};
    const Shown some = some_of(shown, 12);
    const long begin = slip::work();
    bool is_solution = true;
    for (const Answer& answer : slips_of(exercise)) {
        const Fitting all(answer, shown, false), few(answer, some, false);
        std::vector<Made> slips = slips_in(answer, shown);
        // Two of any kinds could explain nearly everything: only those that are plainest.
        std::erase_if(slips, [&](const Made& made) { return made.form > Form::factor && !(is_solution && made.form == Form::variable); });
        std::pair best{Form::none, Form::none};
        for (std::size_t a = 0; a < slips.size(); ++a)
            for (std::size_t b = a + 1; b < slips.size(); ++b) {
                if (slip::work() - begin > most_work) break;
                // A variable taken for another is taken so everywhere; beside another slip it would explain too much.
                if (slips[a].site == slips[b].site || (slips[a].form == Form::variable) != (slips[b].form == Form::variable)) continue;
                if (!few.of(slips[a], &slips[b]).good || !all.of(slips[a], &slips[b]).good) continue;
                const std::pair<Form, Form> found = std::minmax(slips[a].form, slips[b].form);
                best = std::min(best, found);
            }
        if (best.first != Form::none) return std::string("slip_") + slip::name_of(best.first) + "_and_" + slip::name_of(best.second);
        is_solution = false;
    }
    return {};
}

}  // namespace checker
