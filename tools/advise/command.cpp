// course advise

#include <stdexcept>

#include <timestep/checks.hpp>

#include "command.hpp"

namespace course {

double step_of(const Question& question) {
    if (question.step && question.rate) refuse("--step and --rate say the same: give one of them");
    if (question.step) return timestep::positive("step", *question.step);
    return 1 / timestep::positive("rate", question.rate.value_or(60));
}

double accuracy_of(const Question& question) {
    const double accuracy = question.accuracy.value_or(1);
    if (!(accuracy >= 1e-6 && accuracy <= 50)) timestep::refuse("accuracy", accuracy, "from 1e-6 to 50 percent");
    return accuracy;
}

namespace {

void refuse_what_a_body_has(const Question& question) {
    if (question.contacts || question.callback || question.count)
        refuse("--contacts, --callback and --count belong to a spinning body");
}

void refuse_what_springs_have(const Question& q) {
    if (q.kind != "spring" || q.springs || q.arm || q.turning || q.other_mass || q.other_arm || q.other_turning ||
        q.kicks || q.keep_size)
        refuse(
            "a spring or a spinning body: --kind, --springs, --arm, --turning, --other-…, --kicks and --keep-size are "
            "a spring's");
}

}  // namespace

void advise(const Question& question, bool json) {
    try {
        const bool body = !question.inertia.empty() || !question.spin.empty();
        if (body)
            refuse_what_springs_have(question);
        else
            refuse_what_a_body_has(question);
        if (body)
            advise_body(question, json);
        else if (question.damping && !question.stiffness && !question.omega && !question.zeta)
            advise_damper(question, json);
        else if (question.omega || question.stiffness || question.mass || question.kind != "spring")
            advise_spring(question, json);
        else
            refuse(
                "a spring (--omega, or --stiffness with --mass), a damper alone (--damping with --mass) or a spinning "
                "body (--inertia with --spin) is needed");
    } catch (const std::invalid_argument& error) {
        throw Stop(Status::bad_use, error.what());
    }
}

}  // namespace course
