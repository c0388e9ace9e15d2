// ./course advise, asked about springs, or about a damper without one.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <timestep/checks.hpp>
#include <timestep/methods/implicit_euler.hpp>

#include "method_on_spring.hpp"
#include "report.hpp"
#include "words.hpp"

namespace timestep {

namespace {

void belongs(const std::optional<double>& option, const char* name, bool here, const char* where) {
    if (option && !here) refuse_use(std::string(name) + " belongs to " + where);
}

// Which options go together is said here, and what numbers they take where they are used.
void check_words(const Question& question) {
    const std::string& kind = question.kind;
    const bool by_stiffness = question.stiffness || question.mass;
    if (kind != "spring" && kind != "chain" && kind != "cloth" && kind != "tether" && kind != "hinge")
        refuse_use("--kind = " + kind + ": must be spring, chain, cloth, tether or hinge");
    if (question.omega && by_stiffness)
        refuse_use("--omega and --stiffness with --mass say the same: give one of them");
    if (question.zeta && question.damping) refuse_use("--zeta and --damping say the same: give one of them");
    if (by_stiffness && !(question.stiffness && question.mass)) refuse_use("--stiffness and --mass belong together");
    if (question.damping && !by_stiffness) refuse_use("--damping needs --stiffness and --mass");
    const bool many = kind != "spring" && kind != "tether";
    if ((many || question.springs || question.arm || question.turning) && !by_stiffness)
        refuse_use(many ? "--kind " + kind + " needs --stiffness and --mass"
                        : "--springs, --arm and --turning need --stiffness and --mass");
    const bool turns = kind == "spring" || kind == "tether" || kind == "hinge";
    belongs(question.springs, "--springs", kind != "hinge", "a body, a chain or a cloth");
    belongs(question.arm, "--arm", turns, "a body that turns");
    belongs(question.turning, "--turning", turns, "a body that turns");
    belongs(question.other_mass, "--other-mass", kind == "hinge", "--kind hinge");
    belongs(question.other_arm, "--other-arm", kind == "hinge", "--kind hinge");
    belongs(question.other_turning, "--other-turning", kind == "hinge", "--kind hinge");
    if (question.arm.value_or(0) > 0 && !question.turning) refuse_use("--arm needs --turning");
    if (question.other_arm.value_or(0) > 0 && !question.other_turning && !question.turning)
        refuse_use("--other-arm needs --other-turning");
    if (question.turning && !question.arm) refuse_use("--turning needs --arm");
    refuse_two_steps(question);
}

Pull pull_of(const Question& question) {
    const double mass = *question.mass, arm = question.arm.value_or(0);
    if (question.turning) positive("turning", *question.turning);
    const double turning = question.turning.value_or(0);
    if (question.kind == "chain") return springs_between(mass, question.springs.value_or(2));
    if (question.kind == "cloth") {
        Pull cloth = springs_between(mass, question.springs.value_or(4));
        if (!question.springs) cloth.found += phrase("found.cloth");
        return cloth;
    }
    if (question.kind != "hinge") return springs_on_body(mass, question.springs.value_or(1), arm, turning);
    if (question.other_turning) positive("other-turning", *question.other_turning);
    const double other = question.other_mass.value_or(mass);
    return hinge(mass, lightness(mass, arm, turning), other,
                 lightness(other, question.other_arm.value_or(arm), question.other_turning.value_or(turning)));
}

SpringScene springs_of(const Question& question) {
    if (question.omega) return DampedSpring<double>(positive("omega", *question.omega), question.zeta.value_or(0));
    positive("stiffness", *question.stiffness);
    const Pull pull = pull_of(question);
    if (question.zeta) return scene_of_zeta(pull, *question.stiffness, *question.zeta);
    return scene_of(pull, *question.stiffness, question.damping.value_or(0));
}

SpringScene scene_of(const Question& question, const Step& asked) {
    SpringScene scene = springs_of(question);
    scene.only_pulls = question.kind == "tether";
    scene.is_net = question.kind == "chain" || question.kind == "cloth";
    scene.is_joint = question.kind == "hinge";
    scene.kicks = question.kicks;
    if (asked.varying) scene.shortest_frame = asked.shortest, scene.longest_frame = asked.h;
    return scene;
}

constexpr double full_turn = 2 * std::numbers::pi;

// Where the error is looked at.
std::string span(const SpringScene& scene) {
    return phrase(scene.fastest.zeta < 1 ? "spring.first_period" : "spring.decay");
}

// Which error is meant.
void print_meaning(Report& report, const SpringScene& scene, const std::string& percent) {
    const auto& spring = scene.fastest;
    const double slow = static_cast<double>(std::abs(exact_rate(spring.zeta))) * spring.omega;
    report.paragraph(phrase(spring.zeta < 1 ? "spring.right" : "spring.right_decay",
                            {{"accuracy", percent}, {"time", rounded_to(full_turn / slow)}}));
    const double fast = detail::fast_decay(std::max(1.0, spring.zeta)) * spring.omega;
    if (scene.thrown)
        report.paragraph(phrase("spring.fast_decay", {{"time", rounded_to(full_turn / fast)}, {"accuracy", percent}}));
    else if (spring.zeta > hidden_decay)
        report.paragraph(phrase("spring.kick_is_over"));
    if (slow * 60 < 0.01) report.paragraph(phrase("spring.hardly_moves"));
}

// The scene in words: its fastest oscillation, how it was found, and the step.
void print_scene(Report& report, const SpringScene& scene, const Step& asked) {
    const auto& spring = scene.fastest;
    const double h = asked.h, omega = spring.omega;
    const double decay = spring.zeta < 1 ? spring.zeta : 1 / detail::fast_decay(spring.zeta);
    if (!scene.found.empty()) {
        const bool turns = scene.found.find("/I") != std::string::npos;
        report.paragraph(
            phrase(!scene.bounded() ? "spring.found"
                   : turns          ? "spring.found_bounds_near_rest"
                                    : "spring.found_bounds",
                   {{"formula", scene.found}, {"omega", rounded_to(omega)}, {"least", rounded_to(scene.least.omega)}}));
    }
    if (scene.is_net) report.paragraph(phrase("spring.net"));
    if (scene.several && spring.zeta > 0) report.paragraph(phrase("spring.several"));
    if (scene.only_pulls) report.paragraph(phrase("spring.tether"));
    if (scene.varying())
        report.paragraph(phrase("spring.frames", {{"shortest", rounded_to(scene.shortest_frame)},
                                                  {"longest", rounded_to(scene.longest_frame)}}));
    const std::string steps = rounded_to(full_turn / omega / h);
    report.print(phrase("spring.numbers", {{"omega", rounded_to(omega)},
                                           {"zeta", rounded_to(spring.zeta)},
                                           {"step", rounded_to(h)},
                                           {"turn", rounded_to(omega * h, "%.4g")},
                                           {"steps", spring.zeta < 1 ? phrase("spring.steps", {{"count", steps}})
                                                                     : phrase("spring.no_oscillation")}}) +
                 "\n" + phrase("spring.truth", {{"factor", factor(std::exp(-decay * omega))}}) + "\n\n");
}

void print(Report& report, const std::vector<Advice>& all, const SpringScene& scene, const Step& asked,
           double accuracy) {
    print_scene(report, scene, asked);
    print_table(report, all);
    report.paragraph(phrase("spring.columns", {{"span", span(scene)}}) + " " + phrase("report.columns"));
    report.print("\n");
    print_right(report, all, asked, accuracy, !asked.varying);  // else of a longest right step nothing can be said
    print_meaning(report, scene, rounded_to(accuracy) + " %");
    const bool any = std::any_of(all.begin(), all.end(), [](const Advice& each) { return each.ringing < 0; });
    if (scene.fastest.zeta >= 1 || any) report.paragraph(phrase("spring.rings"));
    const double quarter = full_turn / 4 / scene.fastest.omega;
    if (scene.fastest.zeta < 1)
        report.print(
            phrase(asked.h <= quarter ? "spring.within_rule" : "spring.beyond_rule", {{"step", rounded_to(quarter)}}) +
            "\n");
}

}  // namespace

std::vector<Told> answer_spring(const Question& question, bool json) {
    Report report;
    check_words(question);
    const Step asked = step_of(question);
    SpringScene scene = scene_of(question, asked);
    const double h = asked.h, accuracy = accuracy_of(question);
    scene.thrown = thrown_counts(scene.fastest.zeta, scene.fastest.omega * h);
    implicit_euler.check_step(scene.fastest, State<double>{0, 1, 0}, h);
    const auto all = advise(scene, h, accuracy / 100);
    const Goal goal{question.accuracy.has_value(), question.keep_size, accuracy / 100};
    const Recommendation answer = recommend(scene, h, goal, all);
    if (json) {
        Json told = as_json(answer, all);
        told["omega"] = scene.fastest.omega, told["zeta"] = scene.fastest.zeta, told["step"] = h;
        report.print(told.dump(2) + "\n");
        return report.told;
    }
    print(report, all, scene, asked, accuracy);
    const std::string when = scene.only_pulls ? phrase("spring.if_taut")
                             : scene.thrown   ? phrase("spring.or_thrown")
                                              : "";
    print_recommended(report, answer, asked, span(scene) + when, "spring.rate");
    return report.told;
}

std::vector<Told> answer_damper(const Question& question, bool json) {
    Report report;
    if (question.kind != "spring" || question.springs || question.arm || question.turning || question.keep_size)
        refuse_use("a damper alone has no --kind, --springs, --arm, --turning and --keep-size: give --stiffness, too");
    if (!question.mass || !question.damping) refuse_use("--damping and --mass belong together");
    const double rate = positive("damping", *question.damping) / positive("mass", *question.mass);
    Step asked = step_of(question);
    if (asked.varying) asked.name = phrase("damper.longest_frame");
    const double h = asked.h, accuracy = accuracy_of(question), left = std::exp(-rate * h);
    const auto all = advise_damper(rate, h, accuracy / 100);
    const Goal goal{question.accuracy.has_value(), false, accuracy / 100};
    const Recommendation answer = recommend_damper(rate, h, goal, all);
    if (json) {
        Json told = as_json(answer, all);
        told["decay_per_second"] = rate, told["step"] = h;
        report.print(told.dump(2) + "\n");
        return report.told;
    }
    report.print(
        phrase(asked.varying ? "damper.numbers_at_most" : "damper.numbers",
               {{"rate", rounded_to(rate)}, {"step", rounded_to(h)}, {"z", rounded_to(rate * h, "%.4g")}}) +
        "\n" +
        phrase("damper.truth", {{"step", rounded_to(left, "%.4g")}, {"second", rounded_to(std::exp(-rate), "%.3g")}}) +
        "\n\n");
    print_table(report, all);
    report.paragraph(phrase("damper.columns", {{"time", rounded_to(full_turn / rate)}}) + " " +
                     phrase("report.columns"));
    report.print("\n");
    print_right(report, all, asked, accuracy, true);
    report.paragraph(phrase("damper.exact", {{"factor", rounded_to(left, "%.4g")}}));
    print_recommended(report, answer, asked, phrase("damper.where"), "damper.rate");
    return report.told;
}

}  // namespace timestep
