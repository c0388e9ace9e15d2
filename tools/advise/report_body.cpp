// ./course advise, asked about a body that turns.

#include <algorithm>
#include <cmath>

#include <timestep/nearly_symmetric.hpp>

#include "advise_body.hpp"
#include "report.hpp"

namespace timestep {

namespace {

struct Answer {
    double spin, step;  // |ω|, and the longest frame
    bool even;          // are all frames as long?
    std::vector<BodyAdvice> all;
    bool tilted;     // was the throw off its axis by less than a hundredth?
    double seconds;  // how long it was watched
    Thrown truth;
    ClosestMoments closest;
    bool all_but_equal;  // two different moments so close that the difference is a nuisance; not all three
    int axis;            // see axis_of_revolution()
    Thrown declared;     // the throw if they were declared equal, or are
    double half_gone;    // see half_gone_by_passive()
    BodyRecommendation take;
    Thrown taken;  // the throw by what is recommended
};

Frames frames_of(const Question& question) {
    if (question.frames.empty()) {
        const double h = step_of(question);
        return {h, h};
    }
    if (question.step || question.rate) refuse_use("--frames and --step or --rate say the same: give one of them");
    return {question.frames[0], question.frames[1]};
}

// What "leave the torque out" means: a turn by h|ω|, where Tumble's falls short of it.
struct BallTurn {
    template <class Inertia>
    SpinState<double> step(const Inertia&, const SpinState<double>& s, double h) const {
        return {s.t + h, over_its_length(s.q * rotation_by(Vector3<double>(h * s.omega))), s.omega};
    }
};

Answer computed(const Question& question) {
    const auto& I = question.inertia;
    const PrincipalInertia<double> inertia(I[0], I[1], I[2]);
    for (const double part : question.spin) finite("spin", part);
    const Vector3<double> omega(question.spin[0], question.spin[1], question.spin[2]);
    const Frames frames = frames_of(question);
    const double count = question.count.value_or(1);
    if (!(count >= 1 && count <= 1e9 && count == std::floor(count)))
        refuse("count", count, "a whole number from 1 to 1e9");

    Answer answer{};
    answer.spin = omega.stableNorm(), answer.step = frames.longest(), answer.even = frames.even();
    answer.take = recommend(inertia, omega, frames, question.contacts, static_cast<long>(count), question.callback);
    answer.all = advise_body(inertia, omega, frames);
    const auto thrown = as_thrown(omega);
    answer.tilted = thrown != omega;
    for (const auto& advice : answer.all) answer.seconds = std::max(answer.seconds, advice.thrown.seconds);
    answer.truth = throw_exactly(inertia, thrown, answer.seconds);
    answer.closest = closest_moments(inertia);
    const bool is_ball = answer.take.choice.name == "ball";
    answer.all_but_equal = answer.closest.apart > 0 && answer.closest.all_but_equal() && !is_ball;
    answer.axis = axis_of_revolution(inertia);
    if (answer.all_but_equal) answer.half_gone = half_gone_by_passive(inertia, answer.spin, frames);

    const double n = double(answer.take.substeps);
    const Frames shorter(frames.shortest() / n, frames.longest() / n);
    for (const auto& advice : answer.all)  // without substeps it is the throw that we have
        if (advice.method == answer.take.choice.method)
            answer.taken = n <= 1
                               ? advice.thrown
                               : body_solver(advice.method).throw_body(inertia, thrown, shorter, 10, most_thrown_steps);
    if (is_ball) answer.taken = throw_body(BallTurn{}, inertia, thrown, shorter);
    if (answer.closest.all_but_equal()) answer.declared = throw_body(DeclaredEqual(inertia), inertia, thrown, frames);
    if (answer.take.choice.name == "symmetric") answer.taken = answer.declared;
    return answer;
}

std::string equal_moments(const Answer& answer) {
    std::string words;
    for (const double I : answer.closest.equal) words += (words.empty() ? "" : ",") + rounded_to(I, "%.6g");
    return words;
}

Json as_json(const Thrown& thrown) {
    return {{"seconds", finite(thrown.seconds)},
            {"energy", finite(thrown.energy)},
            {"most_energy", finite(thrown.most_energy)},
            {"spin_left", finite(thrown.spin_left)},
            {"orientation_off", finite(thrown.off)},
            {"axis_off", finite(thrown.axis_off)},
            {"lost", thrown.lost}};
}

Json as_json(const BodyAdvice& advice) {
    Json spin = nullptr;
    if (!advice.worst_spin.isZero())
        spin = Json::array({advice.worst_spin.x(), advice.worst_spin.y(), advice.worst_spin.z()});
    return {{"method", advice.method},
            {"verdict", words(advice.adds)},
            {"energy_at_most", finite(advice.bound)},
            {"energy_gain_of_the_worst_step", finite(advice.worst_gain)},
            {"without_bound", std::isinf(advice.worst_gain)},
            {"worst_spin", spin},
            {"longest_step", finite(advice.longest_step)},
            {"torques", advice.price.told ? Json(advice.price.torques) : Json(nullptr)},
            {"solves", advice.price.told ? Json(advice.price.solves) : Json(nullptr)},
            {"turns", advice.price.told ? Json(advice.price.turns) : Json(nullptr)},
            {"throw", as_json(advice.thrown)},
            {"reason", advice.reason}};
}

Json as_json(const Answer& answer) {
    Json methods = Json::array(), near = nullptr;
    for (const auto& advice : answer.all) {
        methods.push_back(as_json(advice));
        methods.back()["cost"] = finite(advice.price.all() / answer.step);
    }
    if (answer.all_but_equal)
        near = {{"apart", answer.closest.apart},
                {"declare", answer.closest.equal},
                {"half_gone_by_passive", finite(answer.half_gone)}};
    const auto& choice = answer.take.choice;
    return {{"spin", answer.spin},
            {"step", answer.step},
            {"methods", methods},
            {"true_motion", {{"spin_left", finite(answer.truth.spin_left)}}},
            {"nearly_equal", near},
            {"recommended",
             {{"name", choice.name},
              {"method", choice.method},
              {"substeps", answer.take.substeps},
              {"why", choice.why},
              {"where", choice.where},
              {"throw", as_json(answer.taken)}}}};
}

std::string verdict_in_words(const BodyAdvice& advice) {
    if (advice.adds == AddsEnergy::bounded) return "at most " + factor(advice.bound);
    if (advice.adds != AddsEnergy::one_step_can) return words(advice.adds);
    return std::string("one step can: ") + (std::isinf(advice.worst_gain) ? "no bound" : more(advice.worst_gain - 1));
}

std::string longest_in_words(double step) {
    if (step == 0) return "every step can";
    return std::isfinite(step) ? rounded_to(step) + " s" : "no limit";
}

std::string price_in_words(const BodyPrice& price) {
    if (!price.told) return "as it takes";
    std::string words;
    const auto add = [&](int count, const char* what) {
        if (count == 0) return;
        words += (words.empty() ? "" : ", ") + std::to_string(count) + " " + what + (count > 1 ? "s" : "");
    };
    add(price.torques, "torque"), add(price.solves, "solve"), add(price.turns, "turn");
    return words.empty() ? "nothing" : words;
}

std::string off_in_words(double off) {
    if (std::isnan(off)) return "-";
    if (off > lost_orientation) return "lost";
    return off < 1e-6 ? "below 0.0001 %" : rounded_to(100 * off, "%.2g") + " %";
}
std::string off_in_words(const Thrown& thrown, const Answer& answer) {
    const std::string whole = off_in_words(thrown.off);
    return answer.axis < 0 ? whole : padded(off_in_words(thrown.axis_off), 20) + whole;
}

std::string spin_left(const Thrown& thrown) {
    return std::isfinite(thrown.energy) && !std::isnan(thrown.spin_left)
               ? rounded_to(100 * thrown.spin_left, "%.3g") + " %"
               : "-";
}

void print(Report& report, const std::string& method, const Thrown& thrown, const Answer& answer) {
    const bool blew_up = std::isinf(thrown.energy);
    report.print("%s%s%s%s%s\n", padded(method, 34).c_str(),
                 padded(blew_up ? "blew up" : factor(thrown.energy), 14).c_str(),
                 padded(blew_up ? "blew up" : factor(thrown.most_energy), 14).c_str(),
                 padded(spin_left(thrown), 12).c_str(), off_in_words(thrown, answer).c_str());
}

void print_recommendation(Report& report, const Answer& answer) {
    const auto& choice = answer.take.choice;
    std::string take = without_marks(choice.take);
    const std::string why = without_marks(choice.why);
    if (answer.take.substeps > 1)
        take += " (here " + std::to_string(answer.take.substeps) + " substeps of " +
                rounded_to(answer.step / double(answer.take.substeps)) + " s)";
    if (answer.all_but_equal) {
        report.print("\nTwo moments are within %s %% of each other. ",
                     rounded_to(100 * answer.closest.apart, "%.2g").c_str());
        if (std::isfinite(answer.half_gone))
            report.print(
                "By passive half of the spin about the axis of the third is gone after\n%s s; by "
                "SymmetricInertia it stays. ",
                rounded_to(answer.half_gone).c_str());
        report.print("(--inertia %s)\nBut then it no longer tumbles when it spins across.\n",
                     equal_moments(answer).c_str());
        if (choice.name == "symmetric_free")
            report.print(
                "Ball and remainder 2 is accurate for this throw, with the true moments.\n"
                "Other throws may need order 4: run advise for them, too.\n");
    }
    report.print("\nRecommended: %s because %s, %s.\n", take.c_str(), why.c_str(), chapter(choice).c_str());
}

// The library's passive takes a body with two equal moments for what it is; that of any three moments does not.
bool is_symmetric(const Answer& answer) { return answer.closest.apart == 0 && answer.take.choice.name != "ball"; }
std::string name_of(const BodyAdvice& advice, const Answer& answer) {
    const bool passive = advice.method == passive_gyroscopic.name;
    return advice.method + (passive && is_symmetric(answer) ? ", three moments" : "");
}

void print(Report& report, const Answer& answer) {
    const double h = answer.step;
    report.print("|ω| = %s rad/s, h = %s s%s: h|ω| = %s. Can a solver add energy, in any direction of the spin?\n\n",
                 rounded_to(answer.spin).c_str(), rounded_to(h).c_str(), answer.even ? "" : " at most",
                 rounded_to(h * answer.spin, "%.4g").c_str());
    report.print("%s%s%s%s%s\n", padded("method", 26).c_str(), padded("adds energy?", 26).c_str(),
                 padded("longest step", 17).c_str(), padded("a step costs", 19).c_str(), "cost/s");
    for (const auto& advice : answer.all)
        report.print("%s%s%s%s%s\n", padded(name_of(advice, answer), 26).c_str(),
                     padded(verdict_in_words(advice), 26).c_str(),
                     padded(longest_in_words(advice.longest_step), 17).c_str(),
                     padded(price_in_words(advice.price), 19).c_str(), often(advice.price.all() / h).c_str());
    report.print("\nYour throw%s, left alone for %s s:\n\n",
                 answer.tilted ? ", tilted by a hundredth as no hand is exact" : "",
                 rounded_to(answer.seconds, "%.4g").c_str());
    report.print("%s%s%s%s%s\n", padded("method", 34).c_str(), padded("energy left", 14).c_str(),
                 padded("at most", 14).c_str(), padded("spin left", 12).c_str(),
                 answer.axis < 0 ? "orientation off in 2 s" : "axis off in 2 s     with the roll about it");
    report.print("%s%s%s%s%s\n", padded("the true motion", 34).c_str(), padded("× 1", 14).c_str(),
                 padded("× 1", 14).c_str(), padded(spin_left(answer.truth), 12).c_str(),
                 answer.axis < 0 ? "0" : "0                   0");
    for (const auto& advice : answer.all) print(report, name_of(advice, answer), advice.thrown, answer);
    const auto& take = answer.take;
    if (take.choice.name == "ball") print(report, "dropped, turned by h|ω|", answer.taken, answer);
    if (answer.all_but_equal) print(report, "declared equal", answer.declared, answer);
    if (is_symmetric(answer)) print(report, "passive, two equal moments", answer.declared, answer);
    if (take.substeps > 1 && answer.taken.seconds > answer.seconds / 2)  // more steps than that nobody waits for
        print(report, take.choice.method + ", " + std::to_string(take.substeps) + " substeps", answer.taken, answer);
    report.print("\nWhy:\n");
    for (const auto& advice : answer.all)
        report.print("  %s%s\n", padded(name_of(advice, answer), 26).c_str(), advice.reason.c_str());
    report.print(
        "\nOne step can: so much the worst one found adds. Longest step: up to it the verdict is no worse.\n"
        "Spin left: about the axis of the body it was thrown about. Off: 1 %% is 0.01 rad; lost: more than 0.5.\n");
    if (answer.axis >= 0)
        report.print(
            "If the body is round about the axis of its third moment, a roll about that axis is invisible:\n"
            "use the first of the two columns.\n");
    print_recommendation(report, answer);
}

}  // namespace

std::vector<Told> answer_body(const Question& question, bool json) {
    Report report;
    if (question.inertia.empty() || question.spin.empty()) refuse_use("--inertia and --spin belong together");
    if (question.omega || question.stiffness || question.mass || question.zeta || question.damping)
        refuse_use("a spring or a spinning body: ask for one of them");
    if (question.accuracy) refuse_use("--accuracy belongs to a spring: of a body its throw is told");
    const Answer answer = computed(question);
    if (json)
        report.print("%s\n", as_json(answer).dump(2).c_str());
    else
        print(report, answer);
    return report.told;
}

}  // namespace timestep
