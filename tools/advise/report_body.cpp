// ./course advise, asked about a body that turns.

#include <algorithm>
#include <cmath>

#include <timestep/nearly_symmetric.hpp>

#include "advise_body.hpp"
#include "report.hpp"
#include "words.hpp"

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
        const double h = step_of(question).h;
        return {h, h};
    }
    refuse_two_steps(question);
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
    if (advice.adds == AddsEnergy::bounded) return phrase("throw.bounded", {{"factor", factor(advice.bound)}});
    if (advice.adds != AddsEnergy::one_step_can) return words(advice.adds);
    return phrase("throw.one_step_can",
                  {{"gain", std::isinf(advice.worst_gain) ? phrase("throw.no_bound") : more(advice.worst_gain - 1)}});
}

std::string longest_in_words(double step) {
    if (step == 0) return phrase("throw.every_step");
    return std::isfinite(step) ? rounded_to(step) + " s" : phrase("throw.no_limit");
}

std::string price_in_words(const BodyPrice& price) {
    if (!price.told) return phrase("throw.price_varies");
    std::string all;
    const auto add = [&](int count, const char* one, const char* many) {
        if (count == 0) return;
        all += (all.empty() ? "" : ", ") + phrase(count > 1 ? many : one, {{"count", std::to_string(count)}});
    };
    add(price.torques, "throw.torque", "throw.torques"), add(price.solves, "throw.solve", "throw.solves");
    add(price.turns, "throw.turn", "throw.turns");
    return all.empty() ? phrase("throw.price_nothing") : all;
}

std::string off_in_words(double off) {
    if (std::isnan(off)) return "-";
    if (off > lost_orientation) return phrase("throw.lost");
    return off < 1e-6 ? phrase("throw.tiny") : rounded_to(100 * off, "%.2g") + " %";
}

std::string spin_left(const Thrown& thrown) {
    return std::isfinite(thrown.energy) && !std::isnan(thrown.spin_left)
               ? rounded_to(100 * thrown.spin_left, "%.3g") + " %"
               : "-";
}

// A line of the table of the throw. How far the axis is off comes first where there is one.
void print_throw(Report& report, const Answer& answer, const std::string& method, const std::string& energy,
                 const std::string& most, const std::string& spin, const std::string& axis, const std::string& whole) {
    report.print(row(
        {{method, 34}, {energy, 14}, {most, 14}, {spin, 12}, {answer.axis < 0 ? "" : axis, answer.axis < 0 ? 0u : 20u}},
        whole));
}
void print_throw(Report& report, const Answer& answer, const std::string& method, const Thrown& thrown) {
    const bool blew_up = std::isinf(thrown.energy);
    const auto energy = [&](double value) { return blew_up ? phrase("throw.blew_up") : factor(value); };
    print_throw(report, answer, method, energy(thrown.energy), energy(thrown.most_energy), spin_left(thrown),
                off_in_words(thrown.axis_off), off_in_words(thrown.off));
}

void print_recommendation(Report& report, const Answer& answer) {
    const auto& choice = answer.take.choice;
    std::string take = without_marks(choice.take);
    if (answer.take.substeps > 1)
        take += phrase("throw.substeps_of", {{"count", std::to_string(answer.take.substeps)},
                                             {"step", rounded_to(answer.step / double(answer.take.substeps))}});
    if (answer.all_but_equal) {
        const std::string apart = rounded_to(100 * answer.closest.apart, "%.2g"), moments = equal_moments(answer);
        report.print("\n");
        report.paragraph(phrase("throw.nearly_equal", {{"apart", apart}}) +
                         (std::isfinite(answer.half_gone)
                              ? phrase("throw.half_gone", {{"time", rounded_to(answer.half_gone)}})
                              : "") +
                         phrase("throw.declare", {{"moments", moments}}));
        if (choice.name == "symmetric_free") report.paragraph(phrase("throw.order_2"));
    }
    report.print("\n" +
                 phrase("throw.recommended",
                        {{"take", take}, {"why", without_marks(choice.why)}, {"chapter", chapter(choice)}}) +
                 "\n");
}

// The library's passive takes a body with two equal moments for what it is; that of any three moments does not.
bool is_symmetric(const Answer& answer) { return answer.closest.apart == 0 && answer.take.choice.name != "ball"; }
std::string name_of(const BodyAdvice& advice, const Answer& answer) {
    const bool passive = advice.method == passive_gyroscopic.name;
    return passive && is_symmetric(answer) ? phrase("throw.three_moments", {{"method", advice.method}}) : advice.method;
}

void print(Report& report, const Answer& answer) {
    const double h = answer.step;
    report.print(phrase(answer.even ? "throw.numbers" : "throw.numbers_at_most",
                        {{"spin", rounded_to(answer.spin)},
                         {"step", rounded_to(h)},
                         {"turn", rounded_to(h * answer.spin, "%.4g")}}) +
                 "\n\n");
    const auto line = [&](const std::string& method, const std::string& verdict, const std::string& longest,
                          const std::string& price, const std::string& cost) {
        report.print(row({{method, 26}, {verdict, 26}, {longest, 17}, {price, 19}}, cost));
    };
    line(phrase("table.method"), phrase("throw.adds"), phrase("throw.longest"), phrase("throw.costs"),
         phrase("table.cost"));
    for (const auto& advice : answer.all)
        line(name_of(advice, answer), verdict_in_words(advice), longest_in_words(advice.longest_step),
             price_in_words(advice.price), often(advice.price.all() / h));
    report.print("\n" +
                 phrase(answer.tilted ? "throw.watched_tilted" : "throw.watched",
                        {{"time", rounded_to(answer.seconds, "%.4g")}}) +
                 "\n\n");
    print_throw(report, answer, phrase("table.method"), phrase("throw.energy_left"), phrase("throw.at_most"),
                phrase("throw.spin_left"), phrase("throw.axis_off"),
                phrase(answer.axis < 0 ? "throw.off" : "throw.roll_off"));
    print_throw(report, answer, phrase("throw.truth"), "× 1", "× 1", spin_left(answer.truth), "0", "0");
    for (const auto& advice : answer.all) print_throw(report, answer, name_of(advice, answer), advice.thrown);
    const auto& take = answer.take;
    if (take.choice.name == "ball") print_throw(report, answer, phrase("throw.dropped"), answer.taken);
    if (answer.all_but_equal) print_throw(report, answer, phrase("throw.declared_equal"), answer.declared);
    if (is_symmetric(answer)) print_throw(report, answer, phrase("throw.two_moments"), answer.declared);
    if (take.substeps > 1 && answer.taken.seconds > answer.seconds / 2)  // more steps than that nobody waits for
        print_throw(
            report, answer,
            phrase("throw.substeps", {{"method", take.choice.method}, {"count", std::to_string(take.substeps)}}),
            answer.taken);
    report.print("\n" + phrase("throw.why") + "\n");
    for (const auto& advice : answer.all) report.print("  " + row({{name_of(advice, answer), 26}}, advice.reason));
    report.print("\n");
    report.paragraph(phrase("throw.columns"));
    if (answer.axis >= 0) report.paragraph(phrase("throw.roll"));
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
        report.print(as_json(answer).dump(2) + "\n");
    else
        print(report, answer);
    return report.told;
}

}  // namespace timestep
