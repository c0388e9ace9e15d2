// course advise

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include <timestep/advise_spin.hpp>

#include "commands.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace {

using timestep::Advice;
using timestep::SpinAdvice;
using Json = nlohmann::ordered_json;

constexpr double pi = 3.141592653589793;

[[noreturn]] void refuse(const std::string& line) {
    throw Stop(Status::bad_use, line + " (./course advise --help)");
}

std::string number(double value, const char* format = "%.3g") {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return "1e308 and more";
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// JSON knows neither NaN nor infinity.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double step_of(const Question& question) {
    if (question.step && question.rate) refuse("--step and --rate say the same: give one of them");
    if (question.step) return timestep::positive("step", *question.step);
    return 1 / timestep::positive("rate", question.rate.value_or(60));
}

timestep::DampedSpring<double> spring_of(const Question& question) {
    const bool by_stiffness = question.stiffness || question.mass;
    if (question.omega && by_stiffness)
        refuse("--omega and --stiffness with --mass say the same: give one of them");
    if (question.zeta && question.damping) refuse("--zeta and --damping say the same: give one of them");
    if (by_stiffness && !(question.stiffness && question.mass))
        refuse("--stiffness and --mass belong together");
    if (question.damping && !by_stiffness) refuse("--damping needs --stiffness and --mass");
    if (question.damping)
        return timestep::DampedSpring<double>::from_stiffness(*question.stiffness, *question.damping,
                                                              *question.mass);
    const double omega =
        question.omega ? timestep::positive("omega", *question.omega)
                       : std::sqrt(timestep::positive("stiffness", *question.stiffness)) /
                             std::sqrt(timestep::positive("mass", *question.mass));
    return {omega, question.zeta.value_or(0)};
}

// ---- A spring ------------------------------------------------------------------------------------

Json as_json(const Advice& advice) {
    return {{"method", advice.method},
            {"verdict", words(advice.verdict)},
            {"growth_per_second", finite(advice.growth_per_second)},
            {"growth_per_step", finite(advice.growth_per_step)},
            {"period_error_percent", finite(100 * advice.period_error)},
            {"energy_per_second", finite(advice.energy_ratio)},
            {"energy_drift_percent_per_second", finite(100 * advice.energy_drift)},
            {"error_percent", finite(100 * advice.rate_error)},
            {"longest_step", finite(advice.longest_step)},
            {"cost", finite(advice.cost)},
            {"accurate_step", advice.accurate_step > 0 ? Json(advice.accurate_step) : Json(nullptr)},
            {"accurate_cost", advice.accurate_cost > 0 ? Json(advice.accurate_cost) : Json(nullptr)},
            {"reason", advice.reason}};
}

// What something becomes in a second, over what it was. Zero is what no double can hold.
std::string factor(double value, const char* format = "%.3g") {
    if (std::isnan(value)) return "-";
    return "x " + (value < 1e-308 ? "1e-308 and less" : number(value, format));
}

void print(const std::vector<Advice>& all, const timestep::DampedSpring<double>& spring, double h,
           double accuracy) {
    const double omega = spring.omega, swing = 2 * pi / omega;
    const double decay = spring.zeta < 1 ? spring.zeta : 1 / timestep::detail::fast_decay(spring.zeta);
    const std::string steps = spring.zeta < 1 ? number(swing / h) + " steps a swing" : "no swing";
    std::printf("ω = %s rad/s, ζ = %s, h = %s s: ωh = %s, %s.\nThe true motion: in a second the "
                "amplitude %s.\n\n",
                number(omega).c_str(), number(spring.zeta).c_str(), number(h).c_str(),
                number(omega * h, "%.4g").c_str(), steps.c_str(),
                factor(std::exp(-decay * omega)).c_str());
    std::printf("%s%s%s%s%s%s\n", padded("method", 34).c_str(), padded("verdict", 19).c_str(),
                padded("amplitude/s", 18).c_str(), padded("energy/s", 18).c_str(),
                padded("period", 13).c_str(), "cost/s");
    for (const auto& advice : all) {
        const std::string off = std::isnan(advice.period_error)
                                    ? "-"
                                    : number(100 * advice.period_error, "%+.2g") + " %";
        std::printf("%s%s%s%s%s%s\n", padded(advice.method, 34).c_str(),
                    padded(words(advice.verdict), 19).c_str(),
                    padded(factor(advice.growth_per_second), 18).c_str(),
                    padded(factor(advice.energy_ratio, "%.2g"), 18).c_str(), padded(off, 13).c_str(),
                    number(advice.cost).c_str());
    }
    std::printf("\nWhy, and up to which step:\n");
    for (const auto& advice : all)
        std::printf("  %s%s%s\n", padded(advice.method, 34).c_str(), advice.reason.c_str(),
                    std::isfinite(advice.longest_step)
                        ? (", h < " + number(advice.longest_step) + " s").c_str()
                        : "");
    std::printf("\nAmplitude: what a second multiplies it by in the long run. Energy: after a second, over what "
                "it\nshould be. Period: how much too long. Cost: force evaluations and solves.\n\n");
    if (const Advice* best = cheapest(all))
        std::printf("To be right to %s %%, the cheapest is %s: steps of %s s, cost %s a second.\n",
                    number(accuracy).c_str(), bold(best->method).c_str(),
                    number(best->accurate_step).c_str(), number(best->accurate_cost).c_str());
    if (spring.zeta < 1)
        std::printf("The talk's rule of thumb, four steps a swing, allows %s s: your step is %s.\n",
                    number(swing / 4).c_str(), h <= swing / 4 ? "within it" : "longer");
}

void advise_spring(const Question& question, bool json) {
    const auto spring = spring_of(question);
    const double h = step_of(question);
    const double accuracy = question.accuracy.value_or(1);
    if (!(accuracy >= 1e-6 && accuracy <= 50))
        timestep::refuse("accuracy", accuracy, "from 1e-6 to 50 percent");
    const auto all = timestep::advise(spring, h, accuracy / 100);
    if (json) {
        Json answer = Json::array();
        for (const auto& advice : all) answer.push_back(as_json(advice));
        std::printf("%s\n", answer.dump(2).c_str());
    } else {
        print(all, spring, h, accuracy);
    }
}

// ---- A spinning body -----------------------------------------------------------------------------

Json as_json(const SpinAdvice& advice) {
    Json spin = nullptr;
    if (advice.worst_gain > 1)
        spin = Json::array({advice.worst_spin.x(), advice.worst_spin.y(), advice.worst_spin.z()});
    return {{"method", advice.method},
            {"verdict", words(advice.verdict)},
            {"growth_per_second", nullptr},  // the spin does not stay in the worst direction
            {"period_error_percent", nullptr},
            {"energy_gain_of_the_worst_step", finite(advice.worst_gain)},
            {"worst_spin", spin},
            {"longest_step", finite(advice.longest_step)},
            {"cost", finite(advice.cost)},
            {"reason", advice.reason}};
}

void print(const std::vector<SpinAdvice>& all, double spin, double h) {
    std::printf("|ω| = %s rad/s, h = %s s: h|ω| = %s. Can one step raise the energy, in any direction?\n\n",
                number(spin).c_str(), number(h).c_str(), number(h * spin, "%.4g").c_str());
    std::printf("%s%s%s%s%s\n", padded("method", 26).c_str(), padded("verdict", 19).c_str(),
                padded("worst step", 14).c_str(), padded("longest step", 14).c_str(), "cost/s");
    for (const auto& advice : all) {
        const double added = advice.worst_gain - 1;
        const bool limited = std::isfinite(advice.longest_step);
        std::printf("%s%s%s%s%s\n", padded(advice.method, 26).c_str(),
                    padded(words(advice.verdict), 19).c_str(),
                    padded(added > 1e-12 ? number(100 * added, "%+.2g") + " %" : "none", 14).c_str(),
                    padded(limited ? number(advice.longest_step) + " s" : "no limit", 14).c_str(),
                    number(advice.cost).c_str());
    }
    std::printf("\nWhy:\n");
    for (const auto& advice : all)
        std::printf("  %s%s\n", padded(advice.method, 26).c_str(), advice.reason.c_str());
    std::printf("\nWorst step: what it adds to the energy. Cost: torques and solves; the converged one takes as "
                "many\niterations as it needs.\n");
}

void advise_body(const Question& question, bool json) {
    if (question.inertia.empty() || question.spin.empty()) refuse("--inertia and --spin belong together");
    if (question.omega || question.stiffness || question.mass || question.zeta || question.damping)
        refuse("a spring or a spinning body: ask for one of them");
    if (question.accuracy) refuse("--accuracy belongs to a spring: of a body only gains are told");
    const auto& I = question.inertia;
    const timestep::PrincipalInertia<double> inertia(I[0], I[1], I[2]);
    double spin = 0;
    for (const double part : question.spin) spin = std::hypot(spin, timestep::finite("spin", part));
    const double h = step_of(question);
    const auto all = timestep::advise_spin(inertia, spin, h);
    if (json) {
        Json answer = Json::array();
        for (const auto& advice : all) answer.push_back(as_json(advice));
        std::printf("%s\n", answer.dump(2).c_str());
    } else {
        print(all, spin, h);
    }
}

}  // namespace

void advise(const Question& question, bool json) {
    try {
        if (!question.inertia.empty() || !question.spin.empty())
            advise_body(question, json);
        else if (question.omega || question.stiffness || question.mass)
            advise_spring(question, json);
        else
            refuse("a spring (--omega) or a spinning body (--inertia and --spin) is needed");
    } catch (const std::invalid_argument& error) {
        throw Stop(Status::bad_use, error.what());
    }
}

}  // namespace course
