#pragma once
/// \file
/// What should I take? The course's answer for a spring, with the number of substeps that makes it
/// hold (I13).

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "advise.hpp"
#include "which_method.hpp"

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

/// One method, and how many steps of it in the place of each step that was asked about.
struct Recommendation {
    const Choice* choice;  ///< the row of which_method.hpp
    long substeps;         ///< 1: the step as it is; 0: none of up to a million does
    std::string method{};  ///< its name in the library: that of the row, or another where the row's
                           ///< costs too much
    std::string take{};    ///< the row's words, or what of them is meant here
    std::string why{};     ///< the same of the reason
    double position_error = std::numeric_limits<double>::quiet_NaN();  ///< at those substeps: see Advice
    double rate_error = std::numeric_limits<double>::quiet_NaN();      ///< at those substeps
    bool swept = false;  ///< are dampers swept there and back? Then both errors are those of all
                         ///< dampers at once
};

/// What of a spring in a game the numbers do not tell.
struct Wish {
    bool precise = false;     ///< has an accuracy been asked for?
    bool keeps_size = false;  ///< must an oscillation faster than the frame keep its size?
    double accuracy = 0.01;   ///< the one that advise() was asked about
};

/// \cond
namespace detail {

inline constexpr long most_substeps = 1'000'000;
// In frames of uneven length so many substeps of an explicit method are worth it where nothing but
// stability is asked.
inline constexpr long few_substeps = 8;

inline long pieces(double step, double longest) {
    const double n = std::ceil(step / longest * (1 - 1e-12));
    return n <= double(most_substeps) ? std::max(1L, static_cast<long>(n)) : 0;
}

// Every method that is advised on, judged on the fastest oscillation.
TIMESTEP_WHERE_CALLED
void for_each_judged(const SpringScene& scene, const std::function<void(const Judged&)>& visit) {
    const auto look = [&](const auto& method) {
        visit(judged(method, scene.fastest.zeta, scene.least.zeta, scene.several, scene.thrown));
    };
    for_each_method(look);
    look(semi_implicit_euler_new_damping);
    for_each_verlet_method(look);
}

inline const Advice* find(const std::vector<Advice>& all, std::string_view name) {
    const auto at = std::find_if(all.begin(), all.end(), [&](const Advice& each) { return each.method == name; });
    return at == all.end() ? nullptr : &*at;
}

// The advice at substeps.
inline Advice in_substeps(const Judged& method, SpringScene scene, double h, long n, double wanted) {
    scene.shortest_frame /= double(n), scene.longest_frame /= double(n);
    return at_step(method, scene, h / double(n), wanted);
}
TIMESTEP_WHERE_CALLED
Advice in_substeps(std::string_view name, const SpringScene& scene, double h, long n, double wanted) {
    Advice advice;
    for_each_judged(scene, [&](const Judged& method) {
        if (name == method.name) advice = in_substeps(method, scene, h, n, wanted);
    });
    return advice;
}

// The fewest substeps with which a tether that the method may let gain was not seen to.
inline long for_a_tether(const Advice& advice, const SpringScene& scene, double h) {
    const bool may_gain = scene.only_pulls && advice.verdict != Verdict::stable;
    return may_gain ? pieces(scene.fastest.omega * h, tether_turn) : 1;
}

// The fewest substeps with which a method is right, and what they cost a second; 0 where none is.
struct Right {
    std::string method;
    long substeps = 0;
    double cost = std::numeric_limits<double>::infinity();
};
inline Right right_steps(const Advice& advice, const SpringScene& scene, double h) {
    const double step = best_step(advice, h);
    const long n = step > 0 ? pieces(h, step) : 0, tether = for_a_tether(advice, scene, h);
    if (n == 0 || tether == 0) return {advice.method};
    return {advice.method, std::max(n, tether), advice.cost * double(std::max(n, tether))};
}
// The same for frames of uneven length. A limit for one step after the other is only that of
// methods whose steps are functions of one matrix, and BDF2 would begin anew with every frame.
inline Right right_frames(const Judged& method, const SpringScene& scene, double h, double wanted) {
    if (!method.one_pattern || method.two_steps) return {method.name};
    const auto right = [&](long n) {
        const Advice advice = in_substeps(method, scene, h, n, wanted);
        const bool holds = !scene.only_pulls || (method.implicit_euler && !scene.turns) ||
                           scene.fastest.omega * h / double(n) <= tether_turn;
        return advice.right && holds ? Right{method.name, n, advice.cost} : Right{method.name};
    };
    if (const Right once = right(1); once.substeps) return once;
    const Stretch stretch = first_right(method, scene.fastest.zeta, wanted);
    long n = stretch.to > 0 ? pieces(scene.fastest.omega * h, stretch.to) : 0;
    if (scene.only_pulls && !method.implicit_euler && n) n = std::max(n, pieces(scene.fastest.omega * h, tether_turn));
    for (int tries = 0; n && n <= most_substeps && tries < 8; ++tries, n += 1 + n / 8)
        if (const Right found = right(n); found.substeps) return found;
    return {method.name};
}

// Asked for an accuracy: the method that is right at the least cost, in whole substeps of h.
TIMESTEP_WHERE_CALLED
Recommendation precisely(const Choice& choice, const SpringScene& scene, double h, double wanted,
                         const std::vector<Advice>& all) {
    std::vector<Right> found;
    if (scene.varying())
        for_each_judged(scene, [&](const Judged& method) {
            if (find(all, method.name)->verdict != Verdict::refused)
                found.push_back(right_frames(method, scene, h, wanted));
        });
    else
        for (const Advice& each : all) found.push_back(right_steps(each, scene, h));
    // The cheapest where the last step need not be whole: of equally cheap ones it is the answer.
    const Advice* listed = scene.varying() || scene.only_pulls ? nullptr : cheapest(all, h);
    const Right *best = nullptr, *of_list = nullptr;
    for (const Right& each : found) {
        if (!each.substeps) continue;
        if (listed && each.method == listed->method) of_list = &each;
        if (!best || each.cost < best->cost || (each.cost == best->cost && each.method == choice.method)) best = &each;
    }
    Recommendation made{&choice, 0, choice.method, choice.take, choice.why};
    if (!best) return made;
    if (of_list && of_list->cost <= best->cost * (1 + 1e-9)) best = of_list;
    made.substeps = best->substeps, made.method = best->method;
    made.take = "**" + best->method + "**";
    made.why = "as accurate as you asked, at the least cost in whole substeps";
    if (of_list && of_list != best)
        made.why += "; " + listed->method + " would need " + std::to_string(of_list->substeps) +
                    (of_list->substeps == 1 ? " substep" : " substeps");
    if (scene.varying())
        made.take = "a constant step, by chapter 2's game loop; where that cannot be, **" + made.method + "**";
    if (scene.only_pulls && made.method != implicit_euler.name)
        made.why =
            "as accurate as you asked while it is taut; nothing proves that it never gains when it "
            "goes taut";
    return made;
}

// Frames of uneven length, and no accuracy asked.
TIMESTEP_WHERE_CALLED
Recommendation in_frames(const Choice& choice, const SpringScene& scene, double h, bool keeps_size,
                         const std::vector<Advice>& all) {
    const auto taken = [&](const char* method, long n, const std::string& why) {
        const std::string take =
            "a constant step, by chapter 2's game loop; where that cannot be, **" + std::string(method) + "**";
        return Recommendation{&choice, n, method, take, why};
    };
    const auto holds = [](const Advice& each) { return each.verdict == Verdict::stable && each.ringing == 0; };
    const std::string falls = "in no step does the energy rise, however frames follow each other";
    if (keeps_size && holds(*find(all, implicit_midpoint.name)))
        return taken(implicit_midpoint.name, 1,
                     "however frames follow each other, an oscillation keeps its size but for what "
                     "the damper takes");
    if (!keeps_size && find(all, implicit_euler.name)->right) return taken(implicit_euler.name, 1, falls);
    const double turn = scene.fastest.omega * h;
    const long least = pieces(turn, alive_turn);
    const auto substeps = [&](const char* method) {  // as few as hold; 0: too many
        for (long n = std::max(1L, least); least && n <= few_substeps; ++n)
            if (holds(in_substeps(method, scene, h, n, 0.01))) return n;
        return 0L;
    };
    const long euler = substeps(semi_implicit_euler_new_damping.name), kutta = substeps(runge_kutta_4.name);
    if (euler && (!kutta || euler <= 2 * kutta))  // a step costs half as much
        return taken(semi_implicit_euler_new_damping.name, euler,
                     "with this much damping, taken at the new velocity, the motion stays inside "
                     "one ellipse, however frames follow each other");
    if (kutta) return taken(runge_kutta_4.name, kutta, choice.why);
    return taken(implicit_euler.name, 1, falls);
}

// A tether: what is proven, or what was seen.
inline Recommendation of_tether(const Choice& choice, const SpringScene& scene, double h, bool keeps_size) {
    const long n = pieces(scene.fastest.omega * h, tether_turn);
    if (keeps_size && !scene.varying() && n)
        return {&choice, n, semi_implicit_euler_new_damping.name,
                "**semi-implicit Euler**, with the damping at the new velocity",
                "with ωh at most " + number(tether_turn) +
                    " none of 400 undamped throws got above 1.25 times its energy in 100,000 steps, "
                    "though nothing proves that none does"};
    if (scene.turns)
        return {&choice, 1, implicit_euler.name, "**implicit Euler**",
                "a step may raise the energy where the tether turns a body, and nothing proves how "
                "far"};
    return {&choice, 1, implicit_euler.name, "**implicit Euler**",
            "in no step does its energy rise, slack or taut" +
                std::string(keeps_size ? "; nothing that bounces on is known to be safe here" : "")};
}

// A constant step, and no accuracy asked: as many substeps as make it stable and still.
TIMESTEP_WHERE_CALLED
Recommendation at_sight(const Choice& choice, const SpringScene& scene, double h, const std::vector<Advice>& all) {
    const DampedSpring<double>& spring = scene.fastest;
    const double turn = spring.omega * h;
    Recommendation made{&choice, 1, choice.method, choice.take, choice.why};
    const Advice* method = find(all, choice.method);
    if (!method) return made;
    long least = choice.name == "swing" ? pieces(turn, alive_turn) : 1;
    if (std::isfinite(method->longest_step)) {
        const long stable = pieces(h, 0.998 * method->longest_step);
        least = stable && least ? std::max(least, stable) : 0;
    }
    made.substeps = 0;
    if (least == 0) return made;
    for_each_judged(scene, [&](const Judged& each) {
        if (choice.method != each.name) return;
        for (long n = least; n <= most_substeps && made.substeps == 0; n = n < 16 ? n + 1 : n + n / 8) {
            const double s = turn / static_cast<double>(n);
            if (ringing(each.multipliers(s), spring.zeta, s) == 0) made.substeps = n;
        }
    });
    return made;
}

}  // namespace detail
/// \endcond

/// The answer for steps of `h`, and the fewest substeps with which it is stable, does not ring, and
/// is as near as was asked for. `all` is what advise() says of the same, to the accuracy of `wish`.
/// Asked for an accuracy, it is the method that reaches it at the least cost, in whole substeps of
/// `h`.
TIMESTEP_WHERE_CALLED
Recommendation recommend(SpringScene scene, double h, const Wish& wish, const std::vector<Advice>& all) {
    scene.thrown = detail::thrown_counts(scene.fastest.zeta, scene.fastest.omega * h);
    const DampedSpring<double>& spring = scene.fastest;
    const SpringQuestion question{spring.omega * h, spring.zeta,      !scene.varying(), wish.precise,
                                  wish.keeps_size,  scene.only_pulls, scene.is_net,     scene.is_joint};
    const Choice& choice = choose(question);
    Recommendation made = wish.precise       ? detail::precisely(choice, scene, h, wish.accuracy, all)
                          : scene.only_pulls ? detail::of_tether(choice, scene, h, wish.keeps_size)
                          : scene.varying()  ? detail::in_frames(choice, scene, h, wish.keeps_size, all)
                                             : detail::at_sight(choice, scene, h, all);
    const auto off = [&] {
        if (made.substeps == 0 || made.method.empty()) return Advice{};
        return detail::in_substeps(made.method, scene, h, made.substeps, wish.accuracy);
    };
    const bool sweeps = scene.several && spring.zeta > 0 && made.method == semi_implicit_euler_new_damping.name;
    if (made.choice->name == "net") made.take = "**semi-implicit Euler**";
    if (made.choice->name == "swing" && !scene.several && !wish.precise)
        made.why = std::string("one force and one division per step; ") +
                   (spring.zeta > 0 ? "with ωh below 2 its damper does not make it blow up while "
                                      "it keeps its direction"
                                    : "the energy of a linear spring oscillates, but does not "
                                      "drift. With other forces it may drift: see chapter 6");
    if (sweeps && wish.precise) made.take += ", all dampers solved for at once";
    if (sweeps && !wish.precise && !scene.varying()) {
        made.swept = true, made.take =
                               "**semi-implicit Euler**, the dampers swept there and back, "
                               "dividing by a square root each way";
        made.why =
            "with ωh below 2 that does not blow up while the springs keep their directions; where "
            "they turn, hard dampers add energy: "
            "shorten the step until hc/m, added up over the dampers at a mass, is at most 1. A "
            "step costs one force per spring and two divisions per damper";
    }
    if (made.choice->name == "net" && (made.substeps == 0 || made.substeps > net_substeps)) {
        const std::string many = made.substeps ? std::to_string(made.substeps) : "more than a million";
        made = {made.choice, 1, implicit_euler.name, "**implicit Euler**, and factorise",
                "semi-implicit Euler would want " + many + " substeps"};
    }
    Advice at = off();
    const Advice* safe = detail::find(all, implicit_euler.name);
    const Advice* method = detail::find(all, made.method);
    const bool sight = !wish.precise && !wish.keeps_size && !scene.only_pulls && !scene.varying();
    if (sight && method && !at.right && safe->right && !scene.is_net &&
        (made.substeps == 0 || safe->cost <= method->cost * double(made.substeps))) {
        const Choice& pull = timestep::choice("pull");
        made = {&pull, 1, pull.method, pull.take, pull.why};
        at = off();
    }
    if (made.substeps) made.position_error = at.position_error, made.rate_error = at.rate_error;
    return made;
}

}  // namespace timestep

#if defined(__clang__)
#pragma clang diagnostic pop
#endif
