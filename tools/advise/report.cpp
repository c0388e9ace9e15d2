// ./course advise: which kind of question it is, and what is told alike of springs and of a damper alone.

#include "report.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <timestep/checks.hpp>

#include "words.hpp"

namespace timestep {

std::string rounded_to(double value, const char* format) {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return phrase("number.infinite");
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    const double rounded = std::strtod(text, nullptr);
    const bool large = std::abs(rounded) >= 10 && std::abs(rounded) < 1e6;
    if (large && std::strchr(text, 'e')) std::snprintf(text, sizeof text, "%.0f", rounded);
    return text;
}

std::string often(double value) { return rounded_to(value, value >= 99.95 && value < 999999.5 ? "%.0f" : "%.3g"); }

std::string more(double fraction) {
    if (fraction >= 9) return "× " + rounded_to(fraction + 1, fraction < 1e6 ? "%.0f" : "%.3g");
    return rounded_to(100 * fraction, std::abs(fraction) < 0.995 ? "%+.2g" : "%+.0f") + " %";
}

std::string factor(double value, const char* format) {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return phrase("number.over");
    return value < 1e-308 ? phrase("number.under") : "× " + rounded_to(value, format);
}

std::string off(double error) {
    if (std::isnan(error)) return "-";
    if (error > 1e6) return phrase("number.all_lost");
    return error >= 9.95 ? "× " + rounded_to(error, "%.2g") : rounded_to(100 * error, "%.2g") + " %";
}

std::string row(std::initializer_list<std::pair<std::string, std::size_t>> cells, const std::string& last) {
    std::string line;
    for (const auto& [text, width] : cells) {
        const auto characters = std::size_t(std::count_if(
            text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
        line += text + std::string(std::max(width, characters) - characters, ' ');
    }
    return line + last + "\n";
}

std::string without_marks(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text.compare(i, 2, "**") == 0)
            ++i;
        else if (text[i] != '`')
            plain += text[i];
    return plain;
}

std::string chapter(const Choice& choice) {
    return phrase("report.chapter", {{"number", choice.where.substr(choice.where.find('_') - 1, 1)}});
}

void refuse_two_steps(const Question& question) {
    if (!question.frames.empty() && (question.step || question.rate))
        refuse_use("--frames and --step or --rate say the same: give one of them");
    if (question.step && question.rate) refuse_use("--step and --rate say the same: give one of them");
}

Step step_of(const Question& question) {
    refuse_two_steps(question);
    if (!question.frames.empty()) {
        const double shortest = positive("shortest frame", question.frames.front());
        const double longest = positive("longest frame", question.frames.back());
        if (!(longest > shortest)) refuse("longest frame", longest, "longer than the shortest");
        return {longest, shortest, true, phrase("report.with_frames"), false};
    }
    if (question.step) return {positive("step", *question.step), 0, false, phrase("report.at_step"), true};
    const double h = 1 / positive("rate", question.rate.value_or(60));
    return {h, 0, false, phrase(question.rate ? "report.at_rate" : "report.at_60_hz"), question.rate.has_value()};
}

double accuracy_of(const Question& question) {
    const double accuracy = question.accuracy.value_or(1);
    if (!(accuracy >= 1e-6 && accuracy <= 50)) refuse("accuracy", accuracy, "from 1e-6 to 50 percent");
    return accuracy;
}

std::vector<Told> answer(const Question& q, bool json) {
    if (!q.inertia.empty() || !q.spin.empty()) {
        if (q.kind != "spring" || q.springs || q.arm || q.turning || q.other_mass || q.other_arm || q.other_turning ||
            q.kicks || q.keep_size)
            refuse_use(
                "a spring or a spinning body: --kind, --springs, --arm, --turning, --other-…, --kicks and --keep-size "
                "are a spring's");
        return answer_body(q, json);
    }
    if (q.contacts || q.callback || q.count) refuse_use("--contacts, --callback and --count belong to a spinning body");
    if (q.damping && !q.stiffness && !q.omega && !q.zeta) return answer_damper(q, json);
    if (q.omega || q.stiffness || q.mass || q.kind != "spring") return answer_spring(q, json);
    refuse_use(
        "a spring (--omega, or --stiffness with --mass), a damper alone (--damping with --mass) or a spinning body "
        "(--inertia with --spin) is needed");
}

namespace {

Json as_json(const Advice& advice) {
    return {{"method", advice.method},
            {"verdict", words(advice.verdict)},
            {"growth_per_second", finite(advice.growth_per_second)},
            {"growth_per_step", finite(advice.growth_per_step)},
            {"period_error_percent", finite(100 * advice.period_error)},
            {"energy_per_second", finite(advice.energy_ratio)},
            {"energy_drift_percent_per_second", finite(100 * advice.energy_drift)},
            {"position_error_percent", finite(100 * advice.position_error)},
            {"rate_error_percent", finite(100 * advice.rate_error)},
            {"longest_step", finite(advice.longest_step)},
            {"cost", finite(advice.cost)},
            {"right", advice.right},
            {"accurate_step", advice.accurate_step > 0 ? Json(advice.accurate_step) : Json(nullptr)},
            {"accurate_cost", advice.accurate_cost > 0 ? Json(advice.accurate_cost) : Json(nullptr)},
            {"ringing", advice.ringing < 0 ? Json(advice.ringing) : Json(nullptr)},
            {"reason", advice.reason}};
}

// Up to which step it is stable: nothing to say where that is every step, or where there is none to take.
std::string up_to(double longest_step) {
    if (longest_step == 0) return phrase("report.no_step");
    return std::isfinite(longest_step) ? phrase("report.up_to", {{"step", rounded_to(longest_step)}}) : "";
}

// The names of those that fit, one after the other.
template <class Fits>
std::string names(const std::vector<Advice>& all, const Fits& fits) {
    std::string text;
    for (const Advice& advice : all)
        if (fits(advice)) text += (text.empty() ? "" : "; ") + advice.method;
    return text;
}

}  // namespace

Json as_json(const Recommendation& answer, const std::vector<Advice>& all) {
    Json methods = Json::array();
    for (const auto& advice : all) methods.push_back(as_json(advice));
    return {{"methods", methods},
            {"recommended",
             {{"name", answer.choice->name},
              {"method", answer.method},
              {"substeps", answer.substeps},
              {"take", without_marks(answer.take)},
              {"why", answer.why},
              {"where", answer.choice->where},
              {"position_error_percent", answer.swept ? Json(nullptr) : finite(100 * answer.position_error)},
              {"rate_error_percent", answer.swept ? Json(nullptr) : finite(100 * answer.rate_error)}}}};
}

void print_table(Report& report, const std::vector<Advice>& all) {
    const auto line = [&](const std::string& method, const std::string& verdict, const std::string& error,
                          const std::string& amplitude, const std::string& energy, const std::string& cost) {
        report.print(row({{method, 33}, {verdict, 18}, {error, 11}, {amplitude, 15}, {energy, 15}}, cost));
    };
    line(phrase("table.method"), phrase("table.verdict"), phrase("table.off_by"), phrase("table.amplitude"),
         phrase("table.energy"), phrase("table.cost"));
    std::string slow;
    for (const auto& advice : all) {
        line(advice.method, told_verdict(advice), off(advice.position_error), factor(advice.growth_per_second),
             factor(advice.energy_ratio, "%.2g"), often(advice.cost));
        if (advice.verdict == Verdict::stable && lingers(advice))
            slow += "  " + row({{advice.method, 34}}, factor(advice.energy_ratio, "%.2g"));
    }
    if (!slow.empty()) report.print("\n" + phrase("report.slow") + "\n" + slow);
    report.print("\n" + phrase("report.why") + "\n");
    for (const auto& advice : all)
        report.print("  " + row({{advice.method, 34}}, advice.reason + up_to(advice.longest_step)));
    report.print("\n");
}

void print_right(Report& report, const std::vector<Advice>& all, const Step& asked, double accuracy, bool longer) {
    const std::string percent = rounded_to(accuracy) + " %";
    const std::string right = names(all, [](const Advice& each) { return each.right; });
    report.paragraph(phrase(
        "report.right",
        {{"at", asked.name}, {"accuracy", percent}, {"methods", right.empty() ? phrase("report.none") : right}}));
    if (!longer) return;
    const Advice* best = cheapest(all, asked.h);
    if (!best) {
        const bool never = cheapest(all) == nullptr;
        report.print(phrase(never         ? "report.never_right"
                            : asked.given ? "report.none_right"
                                          : "report.none_right_at_60_hz",
                            {{"accuracy", percent}}) +
                     "\n");
        return;
    }
    const double step = best_step(*best, asked.h), cost = best_cost(*best, asked.h);
    report.print(
        phrase(asked.given ? "report.cheapest" : "report.cheapest_at_60_hz",
               {{"accuracy", percent}, {"method", "**" + best->method + "**"}}) +
        "\n" +
        phrase("report.cheapest_step", {{"step", rounded_to(step)}, {"rate", often(1 / step)}, {"cost", often(cost)}}) +
        "\n");
    const std::string alike = names(
        all, [&](const Advice& each) { return &each != best && std::abs(best_cost(each, asked.h) / cost - 1) < 1e-9; });
    if (!alike.empty()) report.paragraph(phrase("report.alike", {{"methods", alike}}));
}

void print_recommended(Report& report, const Recommendation& answer, const Step& asked, const std::string& where,
                       const std::string& rate) {
    const std::string substeps = answer.substeps == 0 ? phrase("report.not_enough")
                                 : answer.substeps > 1
                                     ? phrase("report.in_substeps", {{"count", rounded_to(double(answer.substeps))}})
                                     : "";
    std::string text =
        phrase(asked.varying ? "report.recommended"
               : asked.given ? "report.recommended_at_step"
                             : "report.recommended_at_60_hz",
               {{"take", answer.take + substeps}, {"why", answer.why}, {"chapter", chapter(*answer.choice)}});
    if (!std::isnan(answer.position_error)) {
        text += " " + phrase(answer.swept ? "report.off_at_once" : "report.off",
                             {{"error", off(answer.position_error)}, {"where", where}});
        if (!asked.varying && !std::isnan(answer.rate_error)) text += phrase(rate, {{"error", off(answer.rate_error)}});
        text += ".";
    }
    report.paragraph(text);
}

}  // namespace timestep
