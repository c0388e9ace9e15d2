// course advise, asked about a spring.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "advise.hpp"
#include "advise_words.hpp"
#include "spring_answer.hpp"
#include "terminal.hpp"

namespace course {

namespace {

using timestep::Advice;

constexpr double pi = 3.141592653589793;

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

// How far from its place, as a share of the start.
std::string off(double error) {
    if (std::isnan(error)) return "-";
    if (error > 1e6) return "all lost";
    return error >= 9.95 ? "× " + number(error, "%.2g") : number(100 * error, "%.2g") + " %";
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

// The step of the question, and whether it was given.
struct Step {
    double h;
    std::string name;  // for people
    bool given;
};

void line(const std::string& words) { std::printf("%s", wrapped(words, 0).c_str()); }

// Where the error is looked at.
std::string span(const timestep::SpringScene& scene) { return scene.fastest.zeta < 1 ? "in the first period" : "while it decays"; }

// Which error is meant, in one sentence.
void print_meaning(const timestep::SpringScene& scene, const std::string& percent) {
    const double slow = static_cast<double>(std::abs(timestep::detail::exact_rate(scene.fastest.zeta)));
    const std::string end = number(2 * pi / (slow * scene.fastest.omega)) + " s, ";
    const bool swings = scene.fastest.zeta < 1;
    line("Right to " + percent + ": let go at rest, no position " + span(scene) + (swings ? ", " : ", for ") + end +
         "is off by more than " + percent + " of the start, and nothing rings." +
         (swings ? " After many periods it may be farther off." : ""));
}

// Which methods are right at this step, which one reaches that most cheaply, and what right means.
void print_right(const std::vector<Advice>& all, const timestep::SpringScene& scene, const Step& asked,
                 double accuracy) {
    const std::string percent = number(accuracy) + " %";
    std::string right;
    for (const auto& advice : all)
        if (advice.right) right += (right.empty() ? "" : "; ") + advice.method;
    line(asked.name + ", within " + percent + ": " + (right.empty() ? "none" : right) + ".");
    const Advice* best = cheapest(all, asked.h);
    if (scene.varying()) {
        // Of a longest right step nothing can be said while frames vary.
    } else if (best) {
        const double step = best_step(*best, asked.h), cost = best_cost(*best, asked.h);
        std::printf("To be right to %s at steps no longer than %s, the cheapest is %s:\n"
                    "steps of %s s, %s a second, cost %s a second.\n",
                    percent.c_str(), asked.given ? "yours" : "1/60 s", bold(best->method).c_str(),
                    number(step).c_str(), often(1 / step).c_str(), often(cost).c_str());
        std::string alike;
        for (const auto& advice : all)
            if (&advice != best && std::abs(best_cost(advice, asked.h) / cost - 1) < 1e-9)
                alike += (alike.empty() ? "" : "; ") + advice.method;
        if (!alike.empty()) line("Equally cheap: " + alike + ".");
    } else {
        const bool never = cheapest(all) == nullptr;
        std::printf("No method is right to %s at %s.\n", percent.c_str(),
                    never ? "any step" : asked.given ? "steps no longer than yours" : "steps of 1/60 s or less");
    }
    print_meaning(scene, percent);
    const bool any =
        std::any_of(all.begin(), all.end(), [](const Advice& each) { return each.ringing < 0; });
    if (scene.fastest.zeta >= 1 || any)
        line("It rings when a part that should decay turns its sign from step to step and keeps more than half of its "
             "size.");
}

// The answer of which_method.hpp, its bold words bold.
void print_recommended(const timestep::Recommendation& answer, const Step& asked, const timestep::SpringScene& scene) {
    std::string take = answer.take;
    for (std::size_t at = take.find("**"); at != std::string::npos; at = take.find("**")) {
        const std::size_t end = take.find("**", at + 2);
        take = take.substr(0, at) + bold(take.substr(at + 2, end - at - 2)) + take.substr(end + 2);
    }
    std::string words = "Recommended";
    if (!scene.varying()) words += " at " + (asked.given ? "your step" : std::string("1/60 s"));
    words += ": " + take;
    if (answer.substeps > 1) words += ", in " + number(double(answer.substeps)) + " substeps";
    if (answer.substeps == 0) words += ", though no million substeps would do";
    words += "; " + answer.why + " (chapter " +
             answer.choice->where.substr(answer.choice->where.find('_') - 1, 1) + ").";
    if (!std::isnan(answer.position_error)) {
        words += " Off by " + off(answer.position_error) + " " + span(scene);
        if (scene.only_pulls) words += " if it is taut";
        words += scene.varying() ? "." : ", in frequency and decay by " + off(answer.rate_error) + ".";
    }
    line(words);
}

// The scene in words: its fastest oscillation, how it was found, and the step.
void print_scene(const timestep::SpringScene& scene, const Step& asked) {
    const auto& spring = scene.fastest;
    const double h = asked.h, omega = spring.omega;
    const double decay = spring.zeta < 1 ? spring.zeta : 1 / timestep::detail::fast_decay(spring.zeta);
    if (!scene.found.empty())
        line("The fastest oscillation: ω² = " + scene.found + "; so ω = " + number(omega) + " rad/s" +
             (scene.bounded() ? std::string(" at most, ") +
                                    (scene.found.find("/I") == std::string::npos ? "" : "for springs near their rest length, ") +
                                    "and at least " + number(scene.least.omega) + " rad/s." : "."));
    if (scene.only_pulls)
        line("A tether only pulls: limit and numbers are those of a taut one. By all but implicit Euler it may still gain, "
             "each time it goes taut between two steps; short steps gain less.");
    if (scene.varying())
        line("Frames from " + number(scene.shortest_frame) + " to " + number(scene.longest_frame) +
             " s, all lengths alike, in any order: the limits of semi-implicit Euler, of Verlet's kind and of constant acceleration hold for a constant step, "
             "those of the others for the longest frame. Growth is what a thousand runs "
             "with frames at random do; stable is said only where it is proven for any order.");
    const std::string steps = spring.zeta < 1 ? number(2 * pi / omega / h) + " steps a period" : "no oscillation";
    std::printf("ω = %s rad/s, ζ = %s, h = %s s: ωh = %s, %s.\nThe true motion: in a second the "
                "amplitude %s.\n\n",
                number(omega).c_str(), number(spring.zeta).c_str(), number(h).c_str(),
                number(omega * h, "%.4g").c_str(), steps.c_str(), factor(std::exp(-decay * omega)).c_str());
}

void print(const std::vector<Advice>& all, const timestep::SpringScene& scene, const Step& asked, double accuracy) {
    print_scene(scene, asked);
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
    line("Off by: how far, let go at rest, its positions get from the true ones " + span(scene) + ", over the start; "
         "where fewer than three steps fit into it, eight are looked at, for this and for what is right. "
         "Amplitude: what a second multiplies it by in the long run. Energy: after a second, over what it should be. "
         "Cost: force evaluations and solves. A solve counts one, even if it is a mere division as with new damping.");
    std::printf("\n");
    print_right(all, scene, asked, accuracy);
    const auto& spring = scene.fastest;
    const double quarter = pi / 2 / spring.omega;
    if (spring.zeta < 1)
        std::printf("The talk's rule of thumb, four steps a period, allows %s s: your step is %s.\n",
                    number(quarter).c_str(), asked.h <= quarter ? "within it" : "longer");
}

}  // namespace

void advise_spring(const Question& question, bool json) {
    const auto [scene, h, accuracy, all, answer] = answer_spring(question);
    if (json) {
        Json list = Json::array();
        for (const auto& advice : all) {
            list.push_back(as_json(advice));
            if (advice.method == answer.method) list.back()["recommended_substeps"] = answer.substeps;
        }
        std::printf("%s\n", list.dump(2).c_str());
    } else {
        const char* name = scene.varying()  ? "With your frames"
                           : question.step ? "At your step"
                           : question.rate ? "At your rate"
                                           : "At 60 steps a second";
        const Step asked{h, name, question.step || question.rate};
        print(all, scene, asked, accuracy);
        print_recommended(answer, asked, scene);
    }
}

}  // namespace course
