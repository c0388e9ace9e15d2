// course advise, asked about a damper without a spring.

#include <cmath>
#include <cstdio>
#include <numbers>

#include "advise_damper.hpp"

#include "command.hpp"
#include "advise_table.hpp"

namespace course {

namespace {

void check_damper_words(const Question& question) {
    if (question.kind != "spring" || question.springs || question.arm || question.turning || question.keep_size)
        refuse("a damper alone has no --kind, --springs, --arm, --turning and --keep-size: give --stiffness, too");
    if (!question.mass || !question.damping) refuse("--damping and --mass belong together");
    if (!question.frames.empty() && (question.step || question.rate))
        refuse("--frames and --step or --rate say the same: give one of them");
}

}  // namespace

void advise_damper(const Question& question, bool json) {
    check_damper_words(question);
    const double rate = timestep::positive("damping", *question.damping) / timestep::positive("mass", *question.mass);
    const bool varying = !question.frames.empty();
    if (varying) {
        timestep::positive("shortest frame", question.frames.front());
        if (!(timestep::positive("longest frame", question.frames.back()) > question.frames.front()))
            timestep::refuse("longest frame", question.frames.back(), "longer than the shortest");
    }
    const double h = varying ? question.frames.back() : step_of(question), accuracy = accuracy_of(question);
    const auto all = timestep::advise_damper(rate, h, accuracy / 100);
    const timestep::Wish wish{question.accuracy.has_value(), false, accuracy / 100};
    const timestep::Recommendation answer = timestep::recommend_damper(rate, h, wish, all);
    if (json) {
        Json told = as_json(answer, all);
        told["decay_per_second"] = rate, told["step"] = h;
        std::printf("%s\n", told.dump(2).c_str());
        return;
    }
    const Step asked{h,
                     varying         ? "At your longest frame"
                     : question.step ? "At your step"
                     : question.rate ? "At your rate"
                                     : "At 60 steps per second",
                     question.step || question.rate};
    const double left = std::exp(-rate * h);
    std::printf(
        "c/m = %s per second, h = %s s%s: hc/m = %s. A damper alone.\nThe true motion: a step multiplies the velocity "
        "by "
        "e^(−hc/m) = %s, a second by %s.\n\n",
        number(rate).c_str(), number(h).c_str(), varying ? " at most" : "", number(rate * h, "%.4g").c_str(),
        number(left, "%.4g").c_str(), number(std::exp(-rate), "%.3g").c_str());
    print_table(all);
    line("Off by: the largest error of the velocity, relative to the velocity at the start, up to 2π m/c = " +
         number(2 * std::numbers::pi / rate) +
         " s (over eight steps if fewer than three fit). Amplitude: the factor on the velocity per second. "
         "Energy: after a second, over what it should be. "
         "Cost: force evaluations and solves. A solve counts one, even if it is a mere division as with new damping.");
    std::printf("\n");
    print_right(all, asked, accuracy, false);
    line("The exact step needs no method: multiply the velocity by e^(−hc/m), here " + number(left, "%.4g") + ".");
    print_recommended(answer, asked, varying, "in the velocity");
}

}  // namespace course
