// What every method makes of springs.

#include "advise.hpp"

#include <algorithm>
#include <cmath>

#include <timestep/checks.hpp>

#include "method_on_spring.hpp"
#include "words.hpp"

namespace timestep {

Advice advise(const MethodOnSpring& method, const SpringScene& scene, double h, double wanted) {
    const DampedSpring<double>& spring = scene.fastest;
    Advice advice = at_step(method, scene, h, wanted);
    if (scene.varying() || advice.verdict == Verdict::refused) return advice;
    if (const StepRange stretch = first_right(method, spring.zeta, wanted); stretch.to > 0) {
        advice.accurate_from = stretch.from / spring.omega;
        advice.accurate_step = stretch.to / spring.omega;
        advice.accurate_cost = method.work / advice.accurate_step;
    }
    return advice;
}

bool lingers(const Advice& advice) { return advice.energy_ratio > 4 && advice.growth_per_second >= 0.01; }

std::string told_verdict(const Advice& advice) {
    if (advice.verdict != Verdict::stable) return words(advice.verdict);
    if (advice.ringing < 0) return phrase("verdict.rings");
    if (advice.position_error > 0.5) return phrase("verdict.far_off");
    return lingers(advice) ? phrase("verdict.lingers") : words(advice.verdict);
}

std::vector<Advice> advise(SpringScene scene, double h, double wanted) {
    const double omega = scene.fastest.omega;
    positive("omega", omega);
    positive("step", h);
    if (!std::isfinite(omega * h)) refuse("step", h, "so short that omega times it is finite");
    const double shortest = scene.varying() ? scene.shortest_frame : h;
    if (omega * shortest < 1e-12) refuse("step", shortest, "so long that omega times it is 1e-12 or more");
    if (!(wanted >= 1e-8 && wanted <= 0.5)) refuse("accuracy", wanted, "from 1e-8 to 0.5");
    scene.thrown = thrown_counts(scene.fastest.zeta, omega * h);
    std::vector<Advice> all;
    for (const MethodOnSpring& method :
         methods_on_spring(scene.fastest.zeta, scene.least.zeta, scene.several, scene.thrown))
        all.push_back(advise(method, scene, h, wanted));
    return all;
}

double best_step(const Advice& advice, double longest) {
    const double best = advice.accurate_from <= longest ? std::min(advice.accurate_step, longest) : 0;
    return advice.right && advice.step <= longest ? std::max(best, advice.step) : best;
}

double best_cost(const Advice& advice, double longest) {
    const double step = best_step(advice, longest);
    return step > 0 ? advice.cost * (advice.step / step) : 0;
}

const Advice* cheapest(const std::vector<Advice>& all, double longest) {
    const Advice* best = nullptr;
    for (const Advice& advice : all) {
        if (!(best_step(advice, longest) > 0)) continue;
        const double ratio = best ? best_cost(advice, longest) / best_cost(*best, longest) : 0;
        const bool alike = std::abs(ratio - 1) < 1e-9;
        if (alike ? advice.position_error < best->position_error : ratio < 1) best = &advice;
    }
    return best;
}

}  // namespace timestep
