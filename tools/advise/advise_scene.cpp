// course advise: what was typed about springs, as a scene with a fastest oscillation.

#include <cmath>
#include <string>

#include "advise_springs.hpp"

#include "command.hpp"
#include "advise_scene.hpp"

namespace course {

namespace {

void belongs(const std::optional<double>& option, const char* name, bool here, const char* where) {
    if (option && !here) refuse(std::string(name) + " belongs to " + where);
}

// Which options go together is said here, and what numbers they take where they are used.
void check_words(const Question& question) {
    const std::string& kind = question.kind;
    const bool by_stiffness = question.stiffness || question.mass;
    if (kind != "spring" && kind != "chain" && kind != "cloth" && kind != "tether" && kind != "hinge")
        refuse("--kind = " + kind + ": must be spring, chain, cloth, tether or hinge");
    if (question.omega && by_stiffness) refuse("--omega and --stiffness with --mass say the same: give one of them");
    if (question.zeta && question.damping) refuse("--zeta and --damping say the same: give one of them");
    if (by_stiffness && !(question.stiffness && question.mass)) refuse("--stiffness and --mass belong together");
    if (question.damping && !by_stiffness) refuse("--damping needs --stiffness and --mass");
    const bool many = kind != "spring" && kind != "tether";
    if ((many || question.springs || question.arm || question.turning) && !by_stiffness)
        refuse(many ? "--kind " + kind + " needs --stiffness and --mass"
                    : "--springs, --arm and --turning need --stiffness and --mass");
    const bool turns = kind == "spring" || kind == "tether" || kind == "hinge";
    belongs(question.springs, "--springs", kind != "hinge", "a body, a chain or a cloth");
    belongs(question.arm, "--arm", turns, "a body that turns");
    belongs(question.turning, "--turning", turns, "a body that turns");
    belongs(question.other_mass, "--other-mass", kind == "hinge", "--kind hinge");
    belongs(question.other_arm, "--other-arm", kind == "hinge", "--kind hinge");
    belongs(question.other_turning, "--other-turning", kind == "hinge", "--kind hinge");
    if (question.arm.value_or(0) > 0 && !question.turning) refuse("--arm needs --turning");
    if (question.other_arm.value_or(0) > 0 && !question.other_turning && !question.turning)
        refuse("--other-arm needs --other-turning");
    if (question.turning && !question.arm) refuse("--turning needs --arm");
    if (!question.frames.empty() && (question.step || question.rate))
        refuse("--frames and --step or --rate say the same: give one of them");
}

timestep::Pull pull_of(const Question& question) {
    const double mass = *question.mass, arm = question.arm.value_or(0);
    if (question.turning) timestep::positive("turning", *question.turning);
    const double turning = question.turning.value_or(0);
    if (question.kind == "chain") return timestep::springs_between(mass, question.springs.value_or(2));
    if (question.kind == "cloth") {
        timestep::Pull cloth = timestep::springs_between(mass, question.springs.value_or(4));
        if (!question.springs) cloth.found += " (four springs hold a point; with diagonals give --springs 8)";
        return cloth;
    }
    if (question.kind != "hinge") return timestep::springs_on_body(mass, question.springs.value_or(1), arm, turning);
    if (question.other_turning) timestep::positive("other-turning", *question.other_turning);
    const double other = question.other_mass.value_or(mass);
    return timestep::hinge(
        mass, timestep::lightness(mass, arm, turning), other,
        timestep::lightness(other, question.other_arm.value_or(arm), question.other_turning.value_or(turning)));
}

timestep::SpringScene springs_of(const Question& question) {
    if (question.omega)
        return timestep::DampedSpring<double>(timestep::positive("omega", *question.omega), question.zeta.value_or(0));
    timestep::positive("stiffness", *question.stiffness);
    const timestep::Pull pull = pull_of(question);
    if (question.zeta) return scene_of_zeta(pull, *question.stiffness, *question.zeta);
    return scene_of(pull, *question.stiffness, question.damping.value_or(0));
}

}  // namespace

timestep::SpringScene scene_of(const Question& question) {
    check_words(question);
    timestep::SpringScene scene = springs_of(question);
    scene.only_pulls = question.kind == "tether";
    scene.is_net = question.kind == "chain" || question.kind == "cloth";
    scene.is_joint = question.kind == "hinge";
    scene.kicks = question.kicks;
    if (!question.frames.empty()) {
        scene.shortest_frame = timestep::positive("shortest frame", question.frames.front());
        scene.longest_frame = timestep::positive("longest frame", question.frames.back());
        if (!scene.varying()) timestep::refuse("longest frame", scene.longest_frame, "longer than the shortest");
    }
    return scene;
}

}  // namespace course
