// course advise

#include <stdexcept>

#include <timestep/checks.hpp>

#include "advise.hpp"

namespace course {

double step_of(const Question& question) {
    if (question.step && question.rate) refuse("--step and --rate say the same: give one of them");
    if (question.step) return timestep::positive("step", *question.step);
    return 1 / timestep::positive("rate", question.rate.value_or(60));
}

namespace {

void refuse_what_a_body_has(const Question& question) {
    if (question.contacts || question.count) refuse("--contacts and --count belong to a spinning body");
    if (!question.frames.empty()) refuse("--frames belongs to a spinning body");
}

}  // namespace

void advise(const Question& question, bool json) {
    try {
        if (question.inertia.empty() && question.spin.empty()) refuse_what_a_body_has(question);
        if (!question.inertia.empty() || !question.spin.empty())
            advise_body(question, json);
        else if (question.omega || question.stiffness || question.mass)
            advise_spring(question, json);
        else
            refuse("a spring (--omega, or --stiffness with --mass) or a spinning body (--inertia with --spin) is needed");
    } catch (const std::invalid_argument& error) {
        throw Stop(Status::bad_use, error.what());
    }
}

}  // namespace course
