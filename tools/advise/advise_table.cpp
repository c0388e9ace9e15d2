// course advise: what is told alike of springs and of a damper alone.

#include "advise_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "terminal.hpp"

namespace course {

using timestep::Advice;

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

std::string without_stars(std::string words) {
    for (std::size_t at = words.find("**"); at != std::string::npos; at = words.find("**")) words.erase(at, 2);
    return words;
}

// Up to which step it is stable: nothing to say where that is every step, or where there is none to take.
std::string up_to(double longest_step) {
    if (longest_step == 0) return ": no step is short enough";
    return std::isfinite(longest_step) ? ", h < " + number(longest_step) + " s" : "";
}

void print_slow_death(const std::vector<Advice>& all) {
    std::string slow;
    for (const auto& advice : all)
        if (advice.verdict == timestep::Verdict::stable && lingers(advice))
            slow += "  " + padded(advice.method, 34) + factor(advice.energy_ratio, "%.2g") + "\n";
    if (!slow.empty())
        std::printf("\nStable, and yet it may die too slowly. Energy that should be gone:\n%s", slow.c_str());
}

}  // namespace

Json as_json(const timestep::Recommendation& answer, const std::vector<Advice>& all) {
    Json methods = Json::array();
    for (const auto& advice : all) methods.push_back(as_json(advice));
    return {{"methods", methods},
            {"recommended",
             {{"name", answer.choice->name},
              {"method", answer.method},
              {"substeps", answer.substeps},
              {"take", without_stars(answer.take)},
              {"why", answer.why},
              {"where", answer.choice->where},
              {"position_error_percent", answer.swept ? Json(nullptr) : finite(100 * answer.position_error)},
              {"rate_error_percent", answer.swept ? Json(nullptr) : finite(100 * answer.rate_error)}}}};
}

std::string off(double error) {
    if (std::isnan(error)) return "-";
    if (error > 1e6) return "all lost";
    return error >= 9.95 ? "× " + number(error, "%.2g") : number(100 * error, "%.2g") + " %";
}

void line(const std::string& words) { std::printf("%s", wrapped(words, 0).c_str()); }

void print_table(const std::vector<Advice>& all) {
    std::printf("%s%s%s%s%s%s\n", padded("method", 33).c_str(), padded("verdict", 18).c_str(),
                padded("off by", 11).c_str(), padded("amplitude/s", 15).c_str(), padded("energy/s", 15).c_str(),
                "cost/s");
    for (const auto& advice : all)
        std::printf("%s%s%s%s%s%s\n", padded(advice.method, 33).c_str(), padded(told_verdict(advice), 18).c_str(),
                    padded(off(advice.position_error), 11).c_str(),
                    padded(factor(advice.growth_per_second), 15).c_str(),
                    padded(factor(advice.energy_ratio, "%.2g"), 15).c_str(), often(advice.cost).c_str());
    print_slow_death(all);
    std::printf("\nWhy, and up to which step:\n");
    for (const auto& advice : all)
        std::printf("  %s%s%s\n", padded(advice.method, 34).c_str(), advice.reason.c_str(),
                    up_to(advice.longest_step).c_str());
    std::printf("\n");
}

void print_right(const std::vector<Advice>& all, const Step& asked, double accuracy, bool varying) {
    const std::string percent = number(accuracy) + " %";
    std::string right;
    for (const auto& advice : all)
        if (advice.right) right += (right.empty() ? "" : "; ") + advice.method;
    line(asked.name + ", within " + percent + ": " + (right.empty() ? "none" : right) + ".");
    if (varying) return;  // of a longest right step nothing can be said
    const Advice* best = cheapest(all, asked.h);
    if (!best) {
        const bool never = cheapest(all) == nullptr;
        std::printf("No method is right to %s at %s.\n", percent.c_str(),
                    never         ? "any step"
                    : asked.given ? "steps no longer than yours"
                                  : "steps of 1/60 s or less");
        return;
    }
    const double step = best_step(*best, asked.h), cost = best_cost(*best, asked.h);
    std::printf(
        "To be right to %s at steps no longer than %s, the cheapest is %s:\n"
        "steps of %s s, %s per second, cost %s per second.\n",
        percent.c_str(), asked.given ? "yours" : "1/60 s", bold(best->method).c_str(), number(step).c_str(),
        often(1 / step).c_str(), often(cost).c_str());
    std::string alike;
    for (const auto& advice : all)
        if (&advice != best && std::abs(best_cost(advice, asked.h) / cost - 1) < 1e-9)
            alike += (alike.empty() ? "" : "; ") + advice.method;
    if (!alike.empty()) line("Equally cheap: " + alike + ".");
}

void print_recommended(const timestep::Recommendation& answer, const Step& asked, bool varying,
                       const std::string& where) {
    std::string take = answer.take;
    for (std::size_t at = take.find("**"); at != std::string::npos; at = take.find("**")) {
        const std::size_t end = take.find("**", at + 2);
        take = take.substr(0, at) + bold(take.substr(at + 2, end - at - 2)) + take.substr(end + 2);
    }
    std::string words = "Recommended";
    if (!varying) words += " at " + (asked.given ? "your step" : std::string("1/60 s"));
    words += ": " + take;
    if (answer.substeps > 1) words += ", in " + number(double(answer.substeps)) + " substeps";
    if (answer.substeps == 0) words += ", though even a million substeps are not enough";
    words +=
        "; " + answer.why + " (chapter " + answer.choice->where.substr(answer.choice->where.find('_') - 1, 1) + ").";
    if (!std::isnan(answer.position_error)) {
        words += (answer.swept ? " With all dampers solved for at once: off by " : " Off by ") +
                 off(answer.position_error) + " " + where;
        words += varying || std::isnan(answer.rate_error)
                     ? "."
                     : std::string(where == "in the velocity" ? ", in the rate of decay by "
                                                              : ", in frequency and decay by ") +
                           off(answer.rate_error) + ".";
    }
    line(words);
}

}  // namespace course
