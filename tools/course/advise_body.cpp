// course advise, asked about a body that turns.

#include <cmath>
#include <cstdio>

#include <timestep/advise_spin.hpp>

#include "advise.hpp"
#include "advise_words.hpp"
#include "terminal.hpp"

namespace course {

namespace {

using timestep::SpinAdvice;

Json as_json(const SpinAdvice& advice) {
    Json spin = nullptr;
    if (advice.worst_gain > 1)
        spin = Json::array({advice.worst_spin.x(), advice.worst_spin.y(), advice.worst_spin.z()});
    return {{"method", advice.method},
            {"verdict", words(advice.verdict)},
            {"growth_per_second", nullptr},  // the spin does not stay in the worst direction
            {"period_error_percent", nullptr},
            {"energy_gain_of_the_worst_step", finite(advice.worst_gain)},
            {"without_bound", std::isinf(advice.worst_gain)},
            {"worst_spin", spin},
            {"longest_step", finite(advice.longest_step)},
            {"cost", finite(advice.cost)},
            {"reason", advice.reason}};
}

std::string longest_in_words(double step) {
    if (step == 0) return "every step gains";
    return std::isfinite(step) ? number(step) + " s" : "no limit";
}

void print(const std::vector<SpinAdvice>& all, double spin, double h, bool torque) {
    std::printf("|ω| = %s rad/s, h = %s s: h|ω| = %s. Can one step raise the energy, in any direction?\n\n",
                number(spin).c_str(), number(h).c_str(), number(h * spin, "%.4g").c_str());
    std::printf("%s%s%s%s%s\n", padded("method", 26).c_str(), padded("verdict", 19).c_str(),
                padded("worst step", 16).c_str(), padded("longest step", 18).c_str(), "cost/s");
    for (const auto& advice : all) {
        const double added = advice.worst_gain - 1;
        const bool dropped = advice.method == timestep::no_gyroscopic.name;
        std::printf("%s%s%s%s%s\n", padded(advice.method, 26).c_str(),
                    padded(words(advice.verdict), 19).c_str(),
                    padded(std::isinf(added) ? "without bound" : added > 1e-12 ? more(added) : "no gain", 16).c_str(),
                    padded(longest_in_words(advice.longest_step), 18).c_str(),
                    (often(advice.cost) + (dropped && torque ? ", and does not tumble" : "")).c_str());
    }
    std::printf("\nWhy:\n");
    for (const auto& advice : all)
        std::printf("  %s%s\n", padded(advice.method, 26).c_str(), advice.reason.c_str());
    std::printf("\nWorst step: what it adds to the energy, or multiplies it by. Cost: torques and solves; the "
                "converged\none takes as many iterations as it needs.\n");
}

}  // namespace

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
        print(all, spin, h, !inertia.ratio.isZero());
    }
}

}  // namespace course
