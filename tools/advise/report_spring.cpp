// ./course advise, asked about springs.

#include <algorithm>
#include <cmath>

#include <timestep/checks.hpp>
#include <timestep/methods/implicit_euler.hpp>

#include "method_on_spring.hpp"
#include "report.hpp"

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
    if (!question.frames.empty() && (question.step || question.rate))
        refuse_use("--frames and --step or --rate say the same: give one of them");
}

Pull pull_of(const Question& question) {
    const double mass = *question.mass, arm = question.arm.value_or(0);
    if (question.turning) positive("turning", *question.turning);
    const double turning = question.turning.value_or(0);
    if (question.kind == "chain") return springs_between(mass, question.springs.value_or(2));
    if (question.kind == "cloth") {
        Pull cloth = springs_between(mass, question.springs.value_or(4));
        if (!question.springs) cloth.found += " (four springs hold a point; with diagonals give --springs 8)";
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

SpringScene scene_of(const Question& question) {
    check_words(question);
    SpringScene scene = springs_of(question);
    scene.only_pulls = question.kind == "tether";
    scene.is_net = question.kind == "chain" || question.kind == "cloth";
    scene.is_joint = question.kind == "hinge";
    scene.kicks = question.kicks;
    if (!question.frames.empty()) {
        scene.shortest_frame = positive("shortest frame", question.frames.front());
        scene.longest_frame = positive("longest frame", question.frames.back());
        if (!scene.varying()) refuse("longest frame", scene.longest_frame, "longer than the shortest");
    }
    return scene;
}
constexpr double pi = 3.141592653589793;

// Where the error is looked at.
std::string span(const SpringScene& scene) {
    return scene.fastest.zeta < 1 ? "in the first period" : "while it decays";
}

// Which error is meant, in one sentence.
void print_meaning(Report& report, const SpringScene& scene, const std::string& percent) {
    const double slow = static_cast<double>(std::abs(exact_rate(scene.fastest.zeta)));
    const std::string end = rounded_to(2 * pi / (slow * scene.fastest.omega)) + " s, ";
    const bool swings = scene.fastest.zeta < 1;
    report.paragraph("Right to " + percent + ": let go at rest, no position " + span(scene) +
                     (swings ? ", " : ", for ") + end + "is off by more than " + percent +
                     " of the start, and nothing rings." +
                     (swings ? " After many periods it may be farther off." : ""));
    const double fast = detail::fast_decay(std::max(1.0, scene.fastest.zeta)) * scene.fastest.omega;
    if (scene.thrown)
        report.paragraph(
            "The fast decay takes " + rounded_to(2 * pi / fast) +
            " s, several of your steps. It does not show when the body is let go at rest, so a second start "
            "counts as well: the body is thrown from its rest position, and its velocity must not be off by more "
            "than " +
            percent + " of the throw's.");
    else if (scene.fastest.zeta > hidden_decay)
        report.paragraph("A kick is over within three of your steps; how it dies is not looked at.");
    if (slow * scene.fastest.omega * 60 < 0.01)
        report.paragraph(
            "In a minute the spring moves the body by less than 1 % of the way. For the damper alone give --mass and "
            "--damping without --stiffness.");
}

// The scene in words: its fastest oscillation, how it was found, and the step.
void print_scene(Report& report, const SpringScene& scene, const Step& asked) {
    const auto& spring = scene.fastest;
    const double h = asked.h, omega = spring.omega;
    const double decay = spring.zeta < 1 ? spring.zeta : 1 / detail::fast_decay(spring.zeta);
    if (!scene.found.empty())
        report.paragraph(
            "The fastest oscillation: ω² = " + scene.found + "; so ω = " + rounded_to(omega) + " rad/s" +
            (scene.bounded()
                 ? std::string(" at most, ") +
                       (scene.found.find("/I") == std::string::npos ? "" : "for springs near their rest length, ") +
                       "and at least " + rounded_to(scene.least.omega) + " rad/s."
                 : "."));
    if (scene.is_net)
        report.paragraph(
            "(A chain is taken to have two springs at each point and a cloth four; change that with --springs. If the "
            "links only have to keep "
            "their length and you choose no stiffness, use Verlet and correct the links after each step: see the first "
            "line of \"Which method?\".)");
    if (scene.several && spring.zeta > 0)
        report.paragraph(
            "With several dampers, the verdict for new damping holds if they are swept there and back, dividing by a "
            "square root each way, "
            "or solved all at once. The numbers are for solving them all at once.");
    if (scene.only_pulls)
        report.paragraph(
            "A tether only pulls: the limit and the numbers are for a taut tether. Except under implicit Euler, its "
            "energy may still rise "
            "each time it goes taut between two steps; short steps gain less.");
    if (scene.varying())
        report.paragraph(
            "Frames from " + rounded_to(scene.shortest_frame) + " to " + rounded_to(scene.longest_frame) +
            " s, all lengths alike, in any order: the limits of semi-implicit Euler, of Verlet's kind and of constant "
            "acceleration hold for a constant step, "
            "those of the others for the longest frame. Growth is what a thousand runs "
            "with frames at random do; stable is said only where it is proven for any order.");
    const std::string steps = spring.zeta < 1 ? rounded_to(2 * pi / omega / h) + " steps a period" : "no oscillation";
    report.print(
        "ω = %s rad/s, ζ = %s, h = %s s: ωh = %s, %s.\nThe true motion: in a second the "
        "amplitude %s.\n\n",
        rounded_to(omega).c_str(), rounded_to(spring.zeta).c_str(), rounded_to(h).c_str(),
        rounded_to(omega * h, "%.4g").c_str(), steps.c_str(), factor(std::exp(-decay * omega)).c_str());
}

void print(Report& report, const std::vector<Advice>& all, const SpringScene& scene, const Step& asked,
           double accuracy) {
    print_scene(report, scene, asked);
    print_table(report, all);
    report.paragraph(
        "Off by: how far, let go at rest, its positions get from the true ones " + span(scene) +
        ", over the start; "
        "where fewer than three steps fit into it, eight are looked at, for this and for what is right. "
        "Amplitude: what a second multiplies it by in the long run. Energy: after a second, over what it should be. "
        "Cost: force evaluations and solves. A solve counts one, even if it is a mere division as with new damping.");
    report.print("\n");
    print_right(report, all, asked, accuracy, scene.varying());
    print_meaning(report, scene, rounded_to(accuracy) + " %");
    const bool any = std::any_of(all.begin(), all.end(), [](const Advice& each) { return each.ringing < 0; });
    if (scene.fastest.zeta >= 1 || any)
        report.paragraph(
            "It rings when a part that should decay turns its sign from step to step and keeps more than half of its "
            "size.");
    const auto& spring = scene.fastest;
    const double quarter = pi / 2 / spring.omega;
    if (spring.zeta < 1)
        report.print("The talk's rule of thumb, four steps a period, allows %s s: your step is %s.\n",
                     rounded_to(quarter).c_str(), asked.h <= quarter ? "within it" : "longer");
}

}  // namespace

std::vector<Told> answer_spring(const Question& question, bool json) {
    Report report;
    SpringScene scene = scene_of(question);
    const double h = scene.varying() ? scene.longest_frame : step_of(question);
    const double accuracy = accuracy_of(question);
    scene.thrown = thrown_counts(scene.fastest.zeta, scene.fastest.omega * h);
    implicit_euler.check_step(scene.fastest, State<double>{0, 1, 0}, h);
    const auto all = advise(scene, h, accuracy / 100);
    const Goal goal{question.accuracy.has_value(), question.keep_size, accuracy / 100};
    const Recommendation answer = recommend(scene, h, goal, all);
    if (json) {
        Json told = as_json(answer, all);
        told["omega"] = scene.fastest.omega, told["zeta"] = scene.fastest.zeta, told["step"] = h;
        report.print("%s\n", told.dump(2).c_str());
    } else {
        const char* name = scene.varying() ? "With your frames"
                           : question.step ? "At your step"
                           : question.rate ? "At your rate"
                                           : "At 60 steps per second";
        const Step asked{h, name, question.step || question.rate};
        print(report, all, scene, asked, accuracy);
        print_recommended(report, answer, asked, scene.varying(),
                          span(scene) + (scene.only_pulls ? " if it is taut"
                                         : scene.thrown   ? ", let go or thrown"
                                                          : ""));
    }
    return report.told;
}

}  // namespace timestep
