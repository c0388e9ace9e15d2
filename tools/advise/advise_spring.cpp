// course advise, asked about a spring.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "command.hpp"
#include "advise_table.hpp"
#include "spring_answer.hpp"

namespace course {

namespace {

using timestep::Advice;

constexpr double pi = std::numbers::pi;

// Where the error is looked at.
std::string span(const timestep::SpringScene& scene) {
    return scene.fastest.zeta < 1 ? "in the first period" : "while it decays";
}

// Which error is meant, in one sentence.
void print_meaning(const timestep::SpringScene& scene, const std::string& percent) {
    const double slow = static_cast<double>(std::abs(timestep::detail::exact_rate(scene.fastest.zeta)));
    const std::string end = number(2 * pi / (slow * scene.fastest.omega)) + " s, ";
    const bool swings = scene.fastest.zeta < 1;
    line("Right to " + percent + ": let go at rest, no position " + span(scene) + (swings ? ", " : ", for ") + end +
         "is off by more than " + percent + " of the start, and nothing rings." +
         (swings ? " After many periods it may be farther off." : ""));
    const double fast = timestep::detail::fast_decay(std::max(1.0, scene.fastest.zeta)) * scene.fastest.omega;
    if (scene.thrown)
        line("The fast decay takes " + number(2 * pi / fast) +
             " s, several of your steps. It does not show when the body is let go at rest, so a second start "
             "counts as well: the body is thrown from its rest position, and its velocity must not be off by more "
             "than " +
             percent + " of the throw's.");
    else if (scene.fastest.zeta > timestep::detail::hidden_decay)
        line("A kick is over within three of your steps; how it dies is not looked at.");
    if (slow * scene.fastest.omega * 60 < 0.01)
        line(
            "In a minute the spring moves the body by less than 1 % of the way. For the damper alone give --mass and "
            "--damping without --stiffness.");
}

// The scene in words: its fastest oscillation, how it was found, and the step.
void print_scene(const timestep::SpringScene& scene, const Step& asked) {
    const auto& spring = scene.fastest;
    const double h = asked.h, omega = spring.omega;
    const double decay = spring.zeta < 1 ? spring.zeta : 1 / timestep::detail::fast_decay(spring.zeta);
    if (!scene.found.empty())
        line("The fastest oscillation: ω² = " + scene.found + "; so ω = " + number(omega) + " rad/s" +
             (scene.bounded()
                  ? std::string(" at most, ") +
                        (scene.found.find("/I") == std::string::npos ? "" : "for springs near their rest length, ") +
                        "and at least " + number(scene.least.omega) + " rad/s."
                  : "."));
    if (scene.is_net)
        line(
            "(A chain is taken to have two springs at each point and a cloth four; change that with --springs. If the "
            "links only have to keep "
            "their length and you choose no stiffness, use Verlet and correct the links after each step: see the first "
            "line of \"Which method?\".)");
    if (scene.several && spring.zeta > 0)
        line(
            "With several dampers, the verdict for new damping holds if they are swept there and back, dividing by a "
            "square root each way, "
            "or solved all at once. The numbers are for solving them all at once.");
    if (scene.only_pulls)
        line(
            "A tether only pulls: the limit and the numbers are for a taut tether. Except under implicit Euler, its "
            "energy may still rise "
            "each time it goes taut between two steps; short steps gain less.");
    if (scene.varying())
        line("Frames from " + number(scene.shortest_frame) + " to " + number(scene.longest_frame) +
             " s, all lengths alike, in any order: the limits of semi-implicit Euler, of Verlet's kind and of constant "
             "acceleration hold for a constant step, "
             "those of the others for the longest frame. Growth is what a thousand runs "
             "with frames at random do; stable is said only where it is proven for any order.");
    const std::string steps = spring.zeta < 1 ? number(2 * pi / omega / h) + " steps a period" : "no oscillation";
    std::printf(
        "ω = %s rad/s, ζ = %s, h = %s s: ωh = %s, %s.\nThe true motion: in a second the "
        "amplitude %s.\n\n",
        number(omega).c_str(), number(spring.zeta).c_str(), number(h).c_str(), number(omega * h, "%.4g").c_str(),
        steps.c_str(), factor(std::exp(-decay * omega)).c_str());
}

void print(const std::vector<Advice>& all, const timestep::SpringScene& scene, const Step& asked, double accuracy) {
    print_scene(scene, asked);
    print_table(all);
    line("Off by: how far, let go at rest, its positions get from the true ones " + span(scene) +
         ", over the start; "
         "where fewer than three steps fit into it, eight are looked at, for this and for what is right. "
         "Amplitude: what a second multiplies it by in the long run. Energy: after a second, over what it should be. "
         "Cost: force evaluations and solves. A solve counts one, even if it is a mere division as with new damping.");
    std::printf("\n");
    print_right(all, asked, accuracy, scene.varying());
    print_meaning(scene, number(accuracy) + " %");
    const bool any = std::any_of(all.begin(), all.end(), [](const Advice& each) { return each.ringing < 0; });
    if (scene.fastest.zeta >= 1 || any)
        line(
            "It rings when a part that should decay turns its sign from step to step and keeps more than half of its "
            "size.");
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
        Json told = as_json(answer, all);
        told["omega"] = scene.fastest.omega, told["zeta"] = scene.fastest.zeta, told["step"] = h;
        std::printf("%s\n", told.dump(2).c_str());
    } else {
        const char* name = scene.varying() ? "With your frames"
                           : question.step ? "At your step"
                           : question.rate ? "At your rate"
                                           : "At 60 steps per second";
        const Step asked{h, name, question.step || question.rate};
        print(all, scene, asked, accuracy);
        print_recommended(answer, asked, scene.varying(),
                          span(scene) + (scene.only_pulls ? " if it is taut"
                                         : scene.thrown   ? ", let go or thrown"
                                                          : ""));
    }
}

}  // namespace course
