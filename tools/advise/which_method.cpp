// Which method? The list of answers, and the way down to one.

#include "which_method.hpp"

#include <algorithm>
#include <cmath>

#include <timestep/body_throw.hpp>
#include <timestep/refuse.hpp>

#include "words.hpp"

namespace timestep {

namespace {
std::string plain(double value) {  // 0.25 and not 0.250000
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}
}  // namespace

const std::vector<Choice>& choices() {
    static const std::vector<Choice> all = [] {
        const Values limits{{"alive", plain(alive_turn)},
                            {"twice", plain(2 * alive_turn)},
                            {"fine", plain(fine_turn)},
                            {"pull", plain(fine_pull)},
                            {"fair", plain(fair_turn)},
                            {"calm", plain(calm_turn)},
                            {"stiff", plain(stiff_decay)},
                            {"pendulum", plain(pendulum_turn)},
                            {"tether", plain(tether_turn)},
                            {"ended", plain(ended_swing)},
                            {"uneven", "1/" + plain(1 / fair_uneven_turn)},
                            {"within", plain(100 * nearly_equal)},
                            {"guard", plain(std::round(1e4 * std::cbrt(bullet_guard)) / 1e4)}};
        std::vector<Choice> made;
        for (const Section& section : sections()) {
            if (section.texts.front().first != "have") continue;
            const auto text = [&](const char* key) { return section.text(key, limits); };
            made.push_back({section.name, text("have"), text("take"), text("why"), text("where"), section.head});
        }
        return made;
    }();
    return all;
}

const Choice& choice(std::string_view name) {
    for (const Choice& each : choices())
        if (each.name == name) return each;
    refuse("there is no answer \"" + std::string(name) + "\" to which method");
}

// The way down the tree for a spring. A step of an implicit method costs a force and a solve, as
// much as two of semi-implicit Euler: so up to twice the ωh at which that one looks alive, two
// substeps of it are the answer.
const Choice& choose(const SpringQuestion& spring) {
    if (spring.only_pulls && !spring.precise) return choice("tether");  // steps even or not
    if (!spring.even) return choice("uneven");
    if (spring.precise) return choice(spring.zeta < stiff_decay ? "smooth" : "smooth_pull");
    if (spring.turn <= 2 * alive_turn) return choice("swing");
    if (spring.is_net) return choice("net");
    if (spring.is_joint) return choice("joint");
    if (spring.zeta >= 1 || spring.zeta * spring.turn >= ended_swing) return choice("pull");
    return choice(spring.keeps_size ? "keeps_size" : "unseen");
}

// The way down the tree for a body that turns.
const Choice& choose(const BodyQuestion& body) {
    auto [least, middle, most] = body.moments;
    if (least > middle) std::swap(least, middle);
    if (middle > most) std::swap(middle, most);
    if (least > middle) std::swap(least, middle);
    if (least == most || body.is_ball) return choice("ball");
    const bool two_equal = least == middle || middle == most || body.is_symmetric;
    if (body.callback && !body.contacts) return choice("callback_free");
    if (body.callback && two_equal)
        return choice(least * middle * most <= bullet_guard ? "callback_light" : "callback_symmetric");
    if (body.callback) return choice("callback");
    if (body.contacts && two_equal) return choice("symmetric");
    if (body.contacts) return choice("contacts");
    if (two_equal) return choice("symmetric_free");
    if (body.count >= many_bodies) {
        const bool all_but_equal =
            std::max(least / middle, middle / most) >= 1 - nearly_equal;  // their spins would fade
        if (!body.even || (body.turn > calm_turn && all_but_equal)) return choice("many_uneven");
        return choice(body.turn <= calm_turn ? "many" : "many_fast");
    }
    if (!body.even) return choice("free_uneven");
    return choice(body.turn <= fair_turn ? "free" : "free_fast");
}

}  // namespace timestep
