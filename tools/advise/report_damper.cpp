// ./course advise, asked about a damper without a spring.

#include <cmath>

#include <timestep/checks.hpp>

#include "report.hpp"

namespace timestep {

namespace {

void check_damper_words(const Question& question) {
    if (question.kind != "spring" || question.springs || question.arm || question.turning || question.keep_size)
        refuse_use("a damper alone has no --kind, --springs, --arm, --turning and --keep-size: give --stiffness, too");
    if (!question.mass || !question.damping) refuse_use("--damping and --mass belong together");
    if (!question.frames.empty() && (question.step || question.rate))
        refuse_use("--frames and --step or --rate say the same: give one of them");
}

}  // namespace

std::vector<Told> answer_damper(const Question& question, bool json) {
    Report report;
    check_damper_words(question);
    const double rate = positive("damping", *question.damping) / positive("mass", *question.mass);
    const bool varying = !question.frames.empty();
    if (varying) {
        positive("shortest frame", question.frames.front());
        if (!(positive("longest frame", question.frames.back()) > question.frames.front()))
            refuse("longest frame", question.frames.back(), "longer than the shortest");
    }
    const double h = varying ? question.frames.back() : step_of(question), accuracy = accuracy_of(question);
    const auto all = advise_damper(rate, h, accuracy / 100);
    const Goal goal{question.accuracy.has_value(), false, accuracy / 100};
    const Recommendation answer = recommend_damper(rate, h, goal, all);
    if (json) {
        Json told = as_json(answer, all);
        told["decay_per_second"] = rate, told["step"] = h;
        report.print("%s\n", told.dump(2).c_str());
        return report.told;
    }
    const Step asked{h,
                     varying         ? "At your longest frame"
                     : question.step ? "At your step"
                     : question.rate ? "At your rate"
                                     : "At 60 steps per second",
                     question.step || question.rate};
    const double left = std::exp(-rate * h);
    report.print(
        "c/m = %s per second, h = %s s%s: hc/m = %s. A damper alone.\nThe true motion: a step multiplies the velocity "
        "by "
        "e^(−hc/m) = %s, a second by %s.\n\n",
        rounded_to(rate).c_str(), rounded_to(h).c_str(), varying ? " at most" : "",
        rounded_to(rate * h, "%.4g").c_str(), rounded_to(left, "%.4g").c_str(),
        rounded_to(std::exp(-rate), "%.3g").c_str());
    print_table(report, all);
    report.paragraph(
        "Off by: the largest error of the velocity, relative to the velocity at the start, up to 2π m/c = " +
        rounded_to(2 * 3.141592653589793 / rate) +
        " s (over eight steps if fewer than three fit). Amplitude: the factor on the velocity per second. "
        "Energy: after a second, over what it should be. "
        "Cost: force evaluations and solves. A solve counts one, even if it is a mere division as with new damping.");
    report.print("\n");
    print_right(report, all, asked, accuracy, false);
    report.paragraph("The exact step needs no method: multiply the velocity by e^(−hc/m), here " +
                     rounded_to(left, "%.4g") + ".");
    print_recommended(report, answer, asked, varying, "in the velocity");
    return report.told;
}

}  // namespace timestep
