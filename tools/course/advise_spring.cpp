// course advise, asked about a spring.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <timestep/advise.hpp>

#include "advise.hpp"
#include "advise_words.hpp"
#include "terminal.hpp"

namespace course {

namespace {

using timestep::Advice;

constexpr double pi = 3.141592653589793;

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
            {"right", advice.right},
            {"accurate_step", advice.accurate_step > 0 ? Json(advice.accurate_step) : Json(nullptr)},
            {"accurate_cost", advice.accurate_cost > 0 ? Json(advice.accurate_cost) : Json(nullptr)},
            {"ringing", advice.ringing < 0 ? Json(advice.ringing) : Json(nullptr)},
            {"reason", advice.reason}};
}

// Up to which step it is stable: nothing to say where that is every step, or where there is none to take.
std::string up_to(double longest_step) {
    if (longest_step == 0) return ": no step is short enough";
    return std::isfinite(longest_step) ? ", h < " + number(longest_step) + " s" : "";
}

// Stable is not right: one that keeps four times the energy, twice the amplitude, is seen to, while
// there is a hundredth of the start to be seen.
void print_slow_death(const std::vector<Advice>& all) {
    std::string slow;
    for (const auto& advice : all)
        if (advice.verdict == timestep::Verdict::stable && advice.energy_ratio > 4 &&
            advice.growth_per_second >= 0.01)
            slow += "  " + padded(advice.method, 34) + factor(advice.energy_ratio, "%.2g") + "\n";
    if (!slow.empty())
        std::printf("\nStable, and yet it may die too slowly. Energy that should be gone:\n%s", slow.c_str());
}

// Force evaluations and solves of systems a second at the asked step. New damping only divides.
double work(const Advice& advice) {
    return advice.method == timestep::semi_implicit_euler_new_damping.name ? advice.cost / 2 : advice.cost;
}

// The one that is stable at the asked step with the least work, and does not ring; of those alike the
// one that stands the longest step, then the nearest to the truth.
const Advice* survivor(const std::vector<Advice>& all) {
    const auto better = [](const Advice& a, const Advice& b) {
        if (std::abs(work(a) / work(b) - 1) > 1e-9) return work(a) < work(b);
        if (a.longest_step != b.longest_step) return a.longest_step > b.longest_step;
        return a.rate_error < b.rate_error;
    };
    const Advice* best = nullptr;
    for (const auto& advice : all) {
        const bool stands = advice.verdict == timestep::Verdict::stable && advice.ringing == 0;
        if (stands && (!best || better(advice, *best))) best = &advice;
    }
    return best;
}

// The step of the question, and whether it was given.
struct Step {
    double h;
    std::string name;  // for people
    bool given;
};

// What is cheaper still and not right, but stable: if there is such a one.
void print_survivor(const std::vector<Advice>& all, const timestep::DampedSpring<double>& spring,
                    const Step& asked, const Advice* right) {
    const Advice* cheap = survivor(all);
    if (!cheap || cheap->right) return;
    if (right) {
        const double step = best_step(*right, asked.h);
        if (work(*cheap) > 0.999 * work(*right) * asked.h / step) return;
    }
    // A swing that turns by half or more in a step is no swing on the screen.
    const bool too_fast = spring.zeta < 1 && spring.omega * asked.h > pi;
    const double longest = cheap->longest_step;
    const std::string limit =
        std::isfinite(longest) ? "stable up to steps of " + number(longest) + " s" : "stable for every step";
    const std::string words = std::string("If it only has to ") + (too_fast ? "survive" : "look alive") +
                              ": " + bold(cheap->method) + " at " + (asked.given ? "your step" : "1/60 s") +
                              ", " + limit + ", off by " + number(100 * cheap->rate_error, "%.2g") + " %.";
    std::printf("%s", wrapped(words, 0).c_str());
}

// Which methods are right at this step, which one reaches that most cheaply, and what right means.
void print_right(const std::vector<Advice>& all, const timestep::DampedSpring<double>& spring,
                 const Step& asked, double accuracy) {
    const std::string percent = number(accuracy) + " %";
    std::string right;
    for (const auto& advice : all)
        if (advice.right) right += (right.empty() ? "" : "; ") + advice.method;
    std::printf("%s", wrapped(asked.name + ", within " + percent + ": " + (right.empty() ? "none" : right) + ".", 0)
                          .c_str());
    const Advice* best = cheapest(all, asked.h);
    if (best) {
        const double step = best_step(*best, asked.h), cost = best_cost(*best, asked.h);
        std::printf("To be right to %s at steps no longer than %s, the cheapest is %s:\n"
                    "steps of %s s, %s a second, cost %s a second.\n",
                    percent.c_str(), asked.given ? "yours" : "1/60 s", bold(best->method).c_str(),
                    number(step).c_str(), often(1 / step).c_str(), often(cost).c_str());
        std::string alike;
        for (const auto& advice : all)
            if (&advice != best && std::abs(best_cost(advice, asked.h) / cost - 1) < 1e-9)
                alike += (alike.empty() ? "" : "; ") + advice.method;
        if (!alike.empty()) std::printf("%s", wrapped("Equally cheap: " + alike + ".", 0).c_str());
    } else {
        const bool never = cheapest(all) == nullptr;
        std::printf("No method is right to %s at %s.\n", percent.c_str(),
                    never ? "any step" : asked.given ? "steps no longer than yours" : "steps of 1/60 s or less");
    }
    print_survivor(all, spring, asked, best);
    // See timestep::advise() for what is measured.
    if (spring.zeta == 0)
        std::printf("Right to %s: the frequency, and the rate at which the swing grows or dies, are off by %s of ω "
                    "at\nmost. After many swings the amplitude may be farther off.\n",
                    percent.c_str(), percent.c_str());
    else if (spring.zeta < 1)
        std::printf("Right to %s: frequency and decay rate ζω are off by %s of ω at most (that is %s %% of the "
                    "decay\nrate itself). After many swings the amplitude may be farther off.\n",
                    percent.c_str(), percent.c_str(), number(accuracy / spring.zeta).c_str());
    else
        std::printf("Right to %s: the rate of the slow decay, or both ω and ζω, are within %s, and nothing rings. "
                    "After\nmuch decay the amplitude may be farther off.\n",
                    percent.c_str(), percent.c_str());
    const bool any =
        std::any_of(all.begin(), all.end(), [](const Advice& each) { return each.ringing < 0; });
    if (spring.zeta >= 1 || any)
        std::printf("It rings when a part that should decay turns its sign from step to step and keeps "
                    "more than\nhalf of its size.\n");
}

void print(const std::vector<Advice>& all, const timestep::DampedSpring<double>& spring, const Step& asked,
           double accuracy) {
    const double h = asked.h;
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
        // What grows has no period worth a number.
        const bool none = std::isnan(advice.period_error) || advice.verdict == timestep::Verdict::grows;
        const std::string off = none ? "-" : more(advice.period_error);
        std::printf("%s%s%s%s%s%s\n", padded(advice.method, 34).c_str(),
                    padded(advice.ringing < 0 ? "stable, rings" : words(advice.verdict), 19).c_str(),
                    padded(factor(advice.growth_per_second), 18).c_str(),
                    padded(factor(advice.energy_ratio, "%.2g"), 18).c_str(), padded(off, 13).c_str(),
                    often(advice.cost).c_str());
    }
    print_slow_death(all);
    std::printf("\nWhy, and up to which step:\n");
    for (const auto& advice : all)
        std::printf("  %s%s%s\n", padded(advice.method, 34).c_str(), advice.reason.c_str(),
                    up_to(advice.longest_step).c_str());
    std::printf("\nAmplitude: what a second multiplies it by in the long run. Energy: after a second, over what "
                "it\nshould be. Period: how much too long. Cost: force evaluations and solves. A\nsolve counts one, "
                "even if it is a mere division as with new damping.\n\n");
    print_right(all, spring, asked, accuracy);
    if (spring.zeta < 1)
        std::printf("The talk's rule of thumb, four steps a swing, allows %s s: your step is %s.\n",
                    number(swing / 4).c_str(), h <= swing / 4 ? "within it" : "longer");
}

}  // namespace

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
        const char* name = question.step ? "At your step" : question.rate ? "At your rate" : "At 60 steps a second";
        print(all, spring, {h, name, question.step || question.rate}, accuracy);
    }
}

}  // namespace course
