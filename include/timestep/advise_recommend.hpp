#pragma once
/// \file
/// What should I take? The course's answer for a spring, with the number of substeps that makes it hold (I13).

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <timestep/advise.hpp>
#include <timestep/which_method.hpp>

namespace timestep {

/// Up to this ωh, when taut, we have seen no tether gain by semi-implicit Euler; none is proven not to.
inline constexpr double tether_turn = 0.5;

/// One method, and how many steps of it in the place of each step that was asked about.
struct Recommendation {
    const Choice* choice;  ///< the row of which_method.hpp
    long substeps;         ///< 1: the step as it is; 0: none of up to a million does
};

/// What of a spring in a game the numbers do not tell.
struct Wish {
    bool precise = false;     ///< has an accuracy been asked for?
    bool keeps_size = false;  ///< must a swing faster than the frame keep its size?
};

/// \cond
namespace detail {
inline long pieces(double step, double longest) {
    const double n = std::ceil(step / longest * (1 - 1e-12));
    return n <= 1e6 ? std::max(1L, static_cast<long>(n)) : 0;
}
// Does a step of the method of this name ring?
inline bool rings(const std::string& name, double zeta, double s) {
    bool found = false;
    const auto look = [&](const auto& method) {
        if (name == method.name && (takes_damping<std::remove_cvref_t<decltype(method)>> || zeta == 0))
            found = ringing(multipliers(method, zeta, s), zeta, s) < 0;
    };
    for_each_method(look);
    look(semi_implicit_euler_new_damping);
    return found;
}
}  // namespace detail
/// \endcond

/// The answer for steps of `h`, and the fewest substeps with which it is stable, does not ring, and is as near as
/// was asked for. `all` is what advise() says of the same.
inline Recommendation recommend(const SpringScene& scene, double h, const Wish& wish, const std::vector<Advice>& all) {
    const DampedSpring<double>& spring = scene.fastest;
    const double turn = spring.omega * h;
    const Choice& choice = choose(SpringQuestion{turn, spring.zeta, !scene.varying(), wish.precise, wish.keeps_size});
    const auto method = std::find_if(all.begin(), all.end(), [&](const Advice& each) { return each.method == choice.method; });
    if (method == all.end() || scene.varying()) return {&choice, 1};
    long least = 1;
    if (wish.precise) {
        const double step = best_step(*method, h);
        if (!(step > 0)) return {&choice, 0};
        least = detail::pieces(h, step);
    } else if (choice.name == "swing") {
        least = detail::pieces(turn, alive_turn);
    }
    if (scene.only_pulls && method->verdict == Verdict::not_proven)
        least = std::max(least, detail::pieces(turn, tether_turn));
    if (std::isfinite(method->longest_step)) least = std::max(least, detail::pieces(h, 0.998 * method->longest_step));
    if (wish.precise || least == 0) return {&choice, least};
    for (long n = least; n <= 1'000'000; n = n < 16 ? n + 1 : n + n / 8)
        if (!detail::rings(choice.method, spring.zeta, turn / static_cast<double>(n))) return {&choice, n};
    return {&choice, 0};
}

}  // namespace timestep
