// What ./course advise answers about a body, computed.

#include "body_answer.hpp"

#include <algorithm>
#include <cmath>

#include "command.hpp"

namespace course {

using timestep::Frames;

namespace {

Frames frames_of(const Question& question) {
    if (question.frames.empty()) {
        const double h = step_of(question);
        return {h, h};
    }
    if (question.step || question.rate) refuse("--frames and --step or --rate say the same: give one of them");
    return {question.frames[0], question.frames[1]};
}

// What "leave the torque out" means: a turn by h|ω|, where Tumble's falls short of it.
struct BallTurn {
    template <class Inertia>
    timestep::SpinState<double> step(const Inertia&, const timestep::SpinState<double>& s, double h) const {
        return {s.t + h, timestep::over_its_length(s.q * timestep::rotation_by(timestep::Vector3<double>(h * s.omega))),
                s.omega};
    }
};

}  // namespace

BodyAnswer answer_body(const Question& question) {
    const auto& I = question.inertia;
    const timestep::PrincipalInertia<double> inertia(I[0], I[1], I[2]);
    for (const double part : question.spin) timestep::finite("spin", part);
    const timestep::Vector3<double> omega(question.spin[0], question.spin[1], question.spin[2]);
    const Frames frames = frames_of(question);
    const double count = question.count.value_or(1);
    if (!(count >= 1 && count <= 1e9 && count == std::floor(count)))
        timestep::refuse("count", count, "a whole number from 1 to 1e9");

    BodyAnswer answer{};
    answer.spin = omega.stableNorm(), answer.step = frames.longest(), answer.even = frames.even();
    answer.take =
        timestep::recommend(inertia, omega, frames, question.contacts, static_cast<long>(count), question.callback);
    answer.all = timestep::advise_body(inertia, omega, frames);
    const auto thrown = timestep::as_thrown(omega);
    answer.tilted = thrown != omega;
    for (const auto& advice : answer.all) answer.seconds = std::max(answer.seconds, advice.thrown.seconds);
    answer.truth = timestep::throw_exactly(inertia, thrown, answer.seconds);
    answer.closest = timestep::closest_moments(inertia);
    const bool is_ball = answer.take.choice.name == "ball";
    answer.all_but_equal = answer.closest.apart > 0 && answer.closest.all_but_equal() && !is_ball;
    answer.axis = timestep::axis_of_revolution(inertia);
    if (answer.all_but_equal) answer.half_gone = timestep::half_gone_by_passive(inertia, answer.spin, frames);

    const double n = double(answer.take.substeps);
    const Frames shorter(frames.shortest() / n, frames.longest() / n);
    const auto run = [&](const auto& rule) { answer.taken = timestep::throw_body(rule, inertia, thrown, shorter); };
    // Without substeps, that is the throw we have.
    timestep::for_each_body_solver([&](const auto& rule, const auto&) {
        if (rule.name == answer.take.choice.method && n > 1) run(rule);
    });
    for (const auto& advice : answer.all)
        if (advice.method == answer.take.choice.method && n <= 1) answer.taken = advice.thrown;
    if (is_ball) run(BallTurn{});
    if (answer.closest.all_but_equal())
        answer.declared = timestep::throw_body(timestep::DeclaredEqual(inertia), inertia, thrown, frames);
    if (answer.take.choice.name == "symmetric") answer.taken = answer.declared;
    return answer;
}

}  // namespace course
