// course advise, asked about a body that turns.

#include <cmath>
#include <cstdio>

#include "command.hpp"
#include "advise_words.hpp"
#include "body_answer.hpp"
#include "terminal.hpp"

namespace course {

namespace {

using timestep::AddsEnergy;
using timestep::BodyAdvice;
using timestep::Thrown;
using Answer = BodyAnswer;

// The way the section is named: ch8_work and more8_work are of chapter 8.
std::string chapter(const timestep::Choice& choice) {
    return "chapter " + choice.where.substr(choice.where.find('_') - 1, 1);
}

std::string equal_moments(const Answer& answer) {
    std::string words;
    for (const double I : answer.closest.equal) words += (words.empty() ? "" : ",") + number(I, "%.6g");
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
    return std::isfinite(step) ? number(step) + " s" : "no limit";
}

std::string price_in_words(const timestep::BodyPrice& price) {
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
    if (off > timestep::lost_orientation) return "lost";
    return off < 1e-6 ? "below 0.0001 %" : number(100 * off, "%.2g") + " %";
}
std::string off_in_words(const Thrown& thrown, const Answer& answer) {
    const std::string whole = off_in_words(thrown.off);
    return answer.axis < 0 ? whole : padded(off_in_words(thrown.axis_off), 20) + whole;
}

std::string spin_left(const Thrown& thrown) {
    return std::isfinite(thrown.energy) && !std::isnan(thrown.spin_left) ? number(100 * thrown.spin_left, "%.3g") + " %"
                                                                         : "-";
}

void print(const std::string& method, const Thrown& thrown, const Answer& answer) {
    const bool blew_up = std::isinf(thrown.energy);
    std::printf("%s%s%s%s%s\n", padded(method, 34).c_str(),
                padded(blew_up ? "blew up" : factor(thrown.energy), 14).c_str(),
                padded(blew_up ? "blew up" : factor(thrown.most_energy), 14).c_str(),
                padded(spin_left(thrown), 12).c_str(), off_in_words(thrown, answer).c_str());
}

void print_recommendation(const Answer& answer) {
    const auto& choice = answer.take.choice;
    std::string take = choice.take, why = choice.why;
    replace_all(take, "**", "");
    for (std::string* words : {&take, &why}) replace_all(*words, "`", "");
    if (answer.take.substeps > 1)
        take += " (here " + std::to_string(answer.take.substeps) + " substeps of " +
                number(answer.step / double(answer.take.substeps)) + " s)";
    if (answer.all_but_equal) {
        std::printf("\nTwo moments are within %s %% of each other. ",
                    number(100 * answer.closest.apart, "%.2g").c_str());
        if (std::isfinite(answer.half_gone))
            std::printf(
                "By passive half of the spin about the axis of the third is gone after\n%s s; by "
                "SymmetricInertia it stays. ",
                number(answer.half_gone).c_str());
        std::printf("(--inertia %s)\nBut then it no longer tumbles when it spins across.\n",
                    equal_moments(answer).c_str());
        if (choice.name == "symmetric_free")
            std::printf(
                "Ball and remainder 2 is accurate for this throw, with the true moments.\n"
                "Other throws may need order 4: run advise for them, too.\n");
    }
    std::printf("\nRecommended: %s because %s, %s.\n", take.c_str(), why.c_str(), chapter(choice).c_str());
}

// The library's passive takes a body with two equal moments for what it is; that of any three moments does not.
bool is_symmetric(const Answer& answer) { return answer.closest.apart == 0 && answer.take.choice.name != "ball"; }
std::string name_of(const BodyAdvice& advice, const Answer& answer) {
    const bool passive = advice.method == timestep::passive_gyroscopic.name;
    return advice.method + (passive && is_symmetric(answer) ? ", three moments" : "");
}

void print(const Answer& answer) {
    const double h = answer.step;
    std::printf("|ω| = %s rad/s, h = %s s%s: h|ω| = %s. Can a solver add energy, in any direction of the spin?\n\n",
                number(answer.spin).c_str(), number(h).c_str(), answer.even ? "" : " at most",
                number(h * answer.spin, "%.4g").c_str());
    std::printf("%s%s%s%s%s\n", padded("method", 26).c_str(), padded("adds energy?", 26).c_str(),
                padded("longest step", 17).c_str(), padded("a step costs", 19).c_str(), "cost/s");
    for (const auto& advice : answer.all)
        std::printf("%s%s%s%s%s\n", padded(name_of(advice, answer), 26).c_str(),
                    padded(verdict_in_words(advice), 26).c_str(),
                    padded(longest_in_words(advice.longest_step), 17).c_str(),
                    padded(price_in_words(advice.price), 19).c_str(), often(advice.price.all() / h).c_str());
    std::printf("\nYour throw%s, left alone for %s s:\n\n",
                answer.tilted ? ", tilted by a hundredth as no hand is exact" : "",
                number(answer.seconds, "%.4g").c_str());
    std::printf("%s%s%s%s%s\n", padded("method", 34).c_str(), padded("energy left", 14).c_str(),
                padded("at most", 14).c_str(), padded("spin left", 12).c_str(),
                answer.axis < 0 ? "orientation off in 2 s" : "axis off in 2 s     with the roll about it");
    std::printf("%s%s%s%s%s\n", padded("the true motion", 34).c_str(), padded("× 1", 14).c_str(),
                padded("× 1", 14).c_str(), padded(spin_left(answer.truth), 12).c_str(),
                answer.axis < 0 ? "0" : "0                   0");
    for (const auto& advice : answer.all) print(name_of(advice, answer), advice.thrown, answer);
    const auto& take = answer.take;
    if (take.choice.name == "ball") print("dropped, turned by h|ω|", answer.taken, answer);
    if (answer.all_but_equal) print("declared equal", answer.declared, answer);
    if (is_symmetric(answer)) print("passive, two equal moments", answer.declared, answer);
    if (take.substeps > 1 && answer.taken.seconds > answer.seconds / 2)  // more steps than that nobody waits for
        print(take.choice.method + ", " + std::to_string(take.substeps) + " substeps", answer.taken, answer);
    std::printf("\nWhy:\n");
    for (const auto& advice : answer.all)
        std::printf("  %s%s\n", padded(name_of(advice, answer), 26).c_str(), advice.reason.c_str());
    std::printf(
        "\nOne step can: so much the worst one found adds. Longest step: up to it the verdict is no worse.\n"
        "Spin left: about the axis of the body it was thrown about. Off: 1 %% is 0.01 rad; lost: more than 0.5.\n");
    if (answer.axis >= 0)
        std::printf(
            "If the body is round about the axis of its third moment, a roll about that axis is invisible:\n"
            "use the first of the two columns.\n");
    print_recommendation(answer);
}

}  // namespace

void advise_body(const Question& question, bool json) {
    if (question.inertia.empty() || question.spin.empty()) refuse("--inertia and --spin belong together");
    if (question.omega || question.stiffness || question.mass || question.zeta || question.damping)
        refuse("a spring or a spinning body: ask for one of them");
    if (question.accuracy) refuse("--accuracy belongs to a spring: of a body its throw is told");
    const Answer answer = answer_body(question);
    if (json)
        std::printf("%s\n", as_json(answer).dump(2).c_str());
    else
        print(answer);
}

}  // namespace course
