// ./course advise: which kind of question it is, and what is told alike of springs and of a damper alone.

#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include <timestep/checks.hpp>

namespace timestep {

double step_of(const Question& question) {
    if (question.step && question.rate) refuse_use("--step and --rate say the same: give one of them");
    if (question.step) return positive("step", *question.step);
    return 1 / positive("rate", question.rate.value_or(60));
}

double accuracy_of(const Question& question) {
    const double accuracy = question.accuracy.value_or(1);
    if (!(accuracy >= 1e-6 && accuracy <= 50)) refuse("accuracy", accuracy, "from 1e-6 to 50 percent");
    return accuracy;
}

namespace {

void refuse_what_a_body_has(const Question& question) {
    if (question.contacts || question.callback || question.count)
        refuse_use("--contacts, --callback and --count belong to a spinning body");
}

void refuse_what_springs_have(const Question& q) {
    if (q.kind != "spring" || q.springs || q.arm || q.turning || q.other_mass || q.other_arm || q.other_turning ||
        q.kicks || q.keep_size)
        refuse_use(
            "a spring or a spinning body: --kind, --springs, --arm, --turning, --other-…, --kicks and --keep-size are "
            "a spring's");
}

}  // namespace

std::vector<Told> answer(const Question& question, bool json) {
    const bool body = !question.inertia.empty() || !question.spin.empty();
    if (body)
        refuse_what_springs_have(question);
    else
        refuse_what_a_body_has(question);
    if (body) return answer_body(question, json);
    if (question.damping && !question.stiffness && !question.omega && !question.zeta)
        return answer_damper(question, json);
    if (question.omega || question.stiffness || question.mass || question.kind != "spring")
        return answer_spring(question, json);
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
    if (longest_step == 0) return ": no step is short enough";
    return std::isfinite(longest_step) ? ", h < " + rounded_to(longest_step) + " s" : "";
}

void print_slow_death(Report& report, const std::vector<Advice>& all) {
    std::string slow;
    for (const auto& advice : all)
        if (advice.verdict == Verdict::stable && lingers(advice))
            slow += "  " + padded(advice.method, 34) + factor(advice.energy_ratio, "%.2g") + "\n";
    if (!slow.empty())
        report.print("\nStable, and yet it may die too slowly. Energy that should be gone:\n%s", slow.c_str());
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

void Report::print(const char* format, ...) {
    std::va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
    va_end(values);
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    told.push_back({text, false});
}

std::string padded(const std::string& text, std::size_t width) {
    const auto taken = std::size_t(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
    return taken < width ? text + std::string(width - taken, ' ') : text;
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

std::string chapter(const Choice& choice) { return "chapter " + choice.where.substr(choice.where.find('_') - 1, 1); }

std::string off(double error) {
    if (std::isnan(error)) return "-";
    if (error > 1e6) return "all lost";
    return error >= 9.95 ? "× " + rounded_to(error, "%.2g") : rounded_to(100 * error, "%.2g") + " %";
}

void print_table(Report& report, const std::vector<Advice>& all) {
    report.print("%s%s%s%s%s%s\n", padded("method", 33).c_str(), padded("verdict", 18).c_str(),
                 padded("off by", 11).c_str(), padded("amplitude/s", 15).c_str(), padded("energy/s", 15).c_str(),
                 "cost/s");
    for (const auto& advice : all)
        report.print("%s%s%s%s%s%s\n", padded(advice.method, 33).c_str(), padded(told_verdict(advice), 18).c_str(),
                     padded(off(advice.position_error), 11).c_str(),
                     padded(factor(advice.growth_per_second), 15).c_str(),
                     padded(factor(advice.energy_ratio, "%.2g"), 15).c_str(), often(advice.cost).c_str());
    print_slow_death(report, all);
    report.print("\nWhy, and up to which step:\n");
    for (const auto& advice : all)
        report.print("  %s%s%s\n", padded(advice.method, 34).c_str(), advice.reason.c_str(),
                     up_to(advice.longest_step).c_str());
    report.print("\n");
}

void print_right(Report& report, const std::vector<Advice>& all, const Step& asked, double accuracy, bool varying) {
    const std::string percent = rounded_to(accuracy) + " %";
    std::string right;
    for (const auto& advice : all)
        if (advice.right) right += (right.empty() ? "" : "; ") + advice.method;
    report.paragraph(asked.name + ", within " + percent + ": " + (right.empty() ? "none" : right) + ".");
    if (varying) return;  // of a longest right step nothing can be said
    const Advice* best = cheapest(all, asked.h);
    if (!best) {
        const bool never = cheapest(all) == nullptr;
        report.print("No method is right to %s at %s.\n", percent.c_str(),
                     never         ? "any step"
                     : asked.given ? "steps no longer than yours"
                                   : "steps of 1/60 s or less");
        return;
    }
    const double step = best_step(*best, asked.h), cost = best_cost(*best, asked.h);
    report.print(
        "To be right to %s at steps no longer than %s, the cheapest is %s:\n"
        "steps of %s s, %s per second, cost %s per second.\n",
        percent.c_str(), asked.given ? "yours" : "1/60 s", ("**" + best->method + "**").c_str(),
        rounded_to(step).c_str(), often(1 / step).c_str(), often(cost).c_str());
    std::string alike;
    for (const auto& advice : all)
        if (&advice != best && std::abs(best_cost(advice, asked.h) / cost - 1) < 1e-9)
            alike += (alike.empty() ? "" : "; ") + advice.method;
    if (!alike.empty()) report.paragraph("Equally cheap: " + alike + ".");
}

void print_recommended(Report& report, const Recommendation& answer, const Step& asked, bool varying,
                       const std::string& where) {
    std::string words = "Recommended";
    if (!varying) words += " at " + (asked.given ? "your step" : std::string("1/60 s"));
    words += ": " + answer.take;
    if (answer.substeps > 1) words += ", in " + rounded_to(double(answer.substeps)) + " substeps";
    if (answer.substeps == 0) words += ", though even a million substeps are not enough";
    words += "; " + answer.why + " (" + chapter(*answer.choice) + ").";
    if (!std::isnan(answer.position_error)) {
        words += (answer.swept ? " With all dampers solved for at once: off by " : " Off by ") +
                 off(answer.position_error) + " " + where;
        words += varying || std::isnan(answer.rate_error)
                     ? "."
                     : std::string(where == "in the velocity" ? ", in the rate of decay by "
                                                              : ", in frequency and decay by ") +
                           off(answer.rate_error) + ".";
    }
    report.paragraph(words);
}

}  // namespace timestep
