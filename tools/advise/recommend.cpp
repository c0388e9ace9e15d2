// What should I take? The course's answer for a spring, with the number of substeps that makes it hold.

#include <algorithm>
#include <cmath>
#include <limits>

#include <timestep/refuse.hpp>

#include "method_on_spring.hpp"
#include "words.hpp"

namespace timestep {

long pieces(double step, double longest) {
    const double n = std::ceil(step / longest * (1 - 1e-12));
    return n <= double(most_substeps) ? std::max(1L, static_cast<long>(n)) : 0;
}

Right right_steps(const std::vector<Advice>& all, std::size_t place, double h, long least) {
    const double step = best_step(all[place], h);
    const long n = step > 0 ? pieces(h, step) : 0;
    if (n == 0 || least == 0) return {place};
    return {place, std::max(n, least), all[place].cost * double(std::max(n, least))};
}

namespace {

// In frames of uneven length so many substeps of an explicit method are worth it where nothing but
// stability is asked.
constexpr long few_substeps = 8;

// The question, and what every method makes of it; both lists in the order of spring_methods.
struct Asked {
    const Choice& choice;  // the row of the list
    const SpringScene& scene;
    double h;
    const Goal& goal;
    const std::vector<Advice>& all;
    std::vector<MethodOnSpring> methods;

    double turn() const { return scene.fastest.omega * h; }
    Recommendation take(std::size_t place, long substeps, const std::string& words, const std::string& why) const {
        return {&choice, place, substeps, all[place].method, words, why};
    }
    template <class Method>
    Recommendation take(const Method&, long substeps, const std::string& words, const std::string& why) const {
        return take(place_of<Method>, substeps, words, why);
    }
    Advice in_substeps(std::size_t place, long n, double wanted) const {
        SpringScene shorter = scene;
        shorter.shortest_frame /= double(n), shorter.longest_frame /= double(n);
        return at_step(methods[place], shorter, h / double(n), wanted);
    }
};

// The fewest substeps with which a tether that the method may let gain was not seen to.
long for_a_tether(const Advice& advice, const SpringScene& scene, double h) {
    const bool may_gain = scene.only_pulls && advice.verdict != Verdict::stable;
    return may_gain ? pieces(scene.fastest.omega * h, tether_turn) : 1;
}

// As right_steps(), for frames of uneven length. A limit for one step after the other is only that of methods whose
// steps commute, and BDF2 would begin anew with every frame.
Right right_frames(const Asked& asked, std::size_t place) {
    const MethodOnSpring& method = asked.methods[place];
    const SpringScene& scene = asked.scene;
    if (asked.all[place].verdict == Verdict::refused || !method.steps_commute || method.two_steps) return {place};
    const auto right = [&](long n) {
        const Advice advice = asked.in_substeps(place, n, asked.goal.accuracy);
        const bool holds =
            !scene.only_pulls || (method.implicit_euler && !scene.turns) || asked.turn() / double(n) <= tether_turn;
        return advice.right && holds ? Right{place, n, advice.cost} : Right{place};
    };
    if (const Right once = right(1); once.substeps) return once;
    const StepRange range = first_right(method, scene.fastest.zeta, asked.goal.accuracy);
    long n = range.to > 0 ? pieces(asked.turn(), range.to) : 0;
    if (scene.only_pulls && !method.implicit_euler && n) n = std::max(n, pieces(asked.turn(), tether_turn));
    for (int tries = 0; n && n <= most_substeps && tries < 8; ++tries, n += 1 + n / 8)
        if (const Right found = right(n); found.substeps) return found;
    return {place};
}

// The method that is right at the least cost, in whole substeps of h.
Recommendation recommend_for_accuracy(const Asked& asked) {
    const SpringScene& scene = asked.scene;
    std::vector<Right> found;
    for (std::size_t place = 0; place < asked.all.size(); ++place)
        found.push_back(scene.varying()
                            ? right_frames(asked, place)
                            : right_steps(asked.all, place, asked.h, for_a_tether(asked.all[place], scene, asked.h)));
    // The cheapest where the last step need not be whole: of equally cheap ones it is the answer.
    const Advice* listed = scene.varying() || scene.only_pulls ? nullptr : cheapest(asked.all, asked.h);
    const std::size_t of_choice = place_of_choice(asked.choice);
    const Right *best = nullptr, *of_list = nullptr;
    for (const Right& each : found) {
        if (!each.substeps) continue;
        if (listed == &asked.all[each.place]) of_list = &each;
        if (!best || each.cost < best->cost || (each.cost == best->cost && each.place == of_choice)) best = &each;
    }
    if (!best) return asked.take(of_choice, 0, asked.choice.take, asked.choice.why);
    if (of_list && of_list->cost <= best->cost * (1 + 1e-9)) best = of_list;
    std::string words = "**" + asked.all[best->place].method + "**", why = phrase("recommend.accurate");
    if (of_list && of_list != best)
        why += phrase(of_list->substeps == 1 ? "recommend.other_one" : "recommend.other_many",
                      {{"method", listed->method}, {"count", std::to_string(of_list->substeps)}});
    if (scene.varying()) words = phrase("recommend.constant_or", {{"method", words}});
    if (scene.only_pulls && best->place != place_of<ImplicitEuler>) why = phrase("recommend.accurate_while_taut");
    return asked.take(best->place, best->substeps, words, why);
}

// Frames of uneven length, and no accuracy asked.
Recommendation recommend_for_frames(const Asked& asked) {
    const auto taken = [&](const auto& method, long n, const std::string& why) {
        const std::string name = std::string("**") + method.name + "**";
        return asked.take(method, n, phrase("recommend.constant_or", {{"method", name}}), why);
    };
    const auto holds = [](const Advice& each) { return each.verdict == Verdict::stable && each.ringing == 0; };
    const std::string falls = phrase("recommend.frames_fall");
    if (asked.goal.keeps_size && holds(advice_on(asked.all, implicit_midpoint)))
        return taken(implicit_midpoint, 1, phrase("recommend.frames_keep_size"));
    if (!asked.goal.keeps_size && advice_on(asked.all, implicit_euler).right) return taken(implicit_euler, 1, falls);
    const long least = pieces(asked.turn(), alive_turn);
    const auto substeps = [&](std::size_t place) {  // as few as hold; 0: too many
        for (long n = std::max(1L, least); least && n <= few_substeps; ++n)
            if (holds(asked.in_substeps(place, n, 0.01))) return n;
        return 0L;
    };
    const long euler = substeps(place_of<SemiImplicitEulerNewDamping>), kutta = substeps(place_of<RungeKutta4>);
    if (euler && (!kutta || euler <= 2 * kutta))  // a step costs half as much
        return taken(semi_implicit_euler_new_damping, euler, phrase("recommend.frames_ellipse"));
    if (kutta) return taken(runge_kutta_4, kutta, asked.choice.why);
    return taken(implicit_euler, 1, falls);
}

// A tether: what is proven, or what was seen.
Recommendation recommend_for_tether(const Asked& asked) {
    const bool keeps_size = asked.goal.keeps_size;
    const long n = pieces(asked.turn(), tether_turn);
    if (keeps_size && !asked.scene.varying() && n)
        return asked.take(semi_implicit_euler_new_damping, n, phrase("recommend.new_damping"),
                          phrase("recommend.tether_seen", {{"limit", number(tether_turn)}}));
    return asked.take(implicit_euler, 1, phrase("recommend.implicit"),
                      phrase(asked.scene.turns ? "recommend.tether_turns"
                             : keeps_size      ? "recommend.tether_falls_no_bounce"
                                               : "recommend.tether_falls"));
}

// A constant step, and no accuracy asked: as many substeps as make it stable and still.
Recommendation recommend_for_constant_step(const Asked& asked) {
    const std::size_t place = place_of_choice(asked.choice);
    long n = asked.choice.name == "swing" ? pieces(asked.turn(), alive_turn) : 1;
    if (const double longest = asked.all[place].longest_step; std::isfinite(longest)) {
        const long stable = pieces(asked.h, 0.998 * longest);
        n = stable && n ? std::max(n, stable) : 0;
    }
    const auto rings = [&] {
        const double s = asked.turn() / double(n);
        return ringing(asked.methods[place].multipliers(s), asked.scene.fastest.zeta, s) != 0;
    };
    while (n > 0 && rings())
        if ((n = n < 16 ? n + 1 : n + n / 8) > most_substeps) n = 0;
    return asked.take(place, n, asked.choice.take, asked.choice.why);
}

}  // namespace

std::size_t place_of_choice(const Choice& choice) {
    std::size_t place = 0, found = std::tuple_size_v<decltype(spring_methods)>;
    for_each_spring_method([&](const auto& method) {
        if (choice.method == method.name) found = place;
        ++place;
    });
    if (found == place) refuse("the answer \"" + choice.name + "\" names no method for springs: " + choice.method);
    return found;
}

Recommendation recommend(SpringScene scene, double h, const Goal& goal, const std::vector<Advice>& all) {
    scene.thrown = thrown_counts(scene.fastest.zeta, scene.fastest.omega * h);
    const double zeta = scene.fastest.zeta;
    const SpringQuestion question{
        scene.fastest.omega * h, zeta,         !scene.varying(), goal.precise, goal.keeps_size,
        scene.only_pulls,        scene.is_net, scene.is_joint};
    const Choice& choice = choose(question);
    const Asked asked{choice, scene, h,
                      goal,   all,   methods_on_spring(zeta, scene.least.zeta, scene.several, scene.thrown)};
    Recommendation made = goal.precise       ? recommend_for_accuracy(asked)
                          : scene.only_pulls ? recommend_for_tether(asked)
                          : scene.varying()  ? recommend_for_frames(asked)
                                             : recommend_for_constant_step(asked);
    const bool sweeps = scene.several && zeta > 0 && made.place == place_of<SemiImplicitEulerNewDamping>;
    if (choice.name == "net") made.take = phrase("recommend.semi_implicit");
    if (choice.name == "swing" && !scene.several && !goal.precise)
        made.why = phrase(zeta > 0 ? "recommend.damped_swing" : "recommend.undamped_swing");
    if (sweeps && goal.precise) made.take += phrase("recommend.at_once");
    if (sweeps && !goal.precise && !scene.varying()) {
        made.swept = true;
        made.take = phrase("recommend.swept"), made.why = phrase("recommend.swept_why");
    }
    if (choice.name == "net" && (made.substeps == 0 || made.substeps > net_substeps)) {
        const std::string many = made.substeps ? std::to_string(made.substeps) : phrase("recommend.a_million");
        made = asked.take(implicit_euler, 1, phrase("recommend.factorise"),
                          phrase("recommend.factorise_why", {{"count", many}}));
    }
    const auto at_its_substeps = [&] {
        return made.substeps == 0 ? Advice{} : asked.in_substeps(made.place, made.substeps, goal.accuracy);
    };
    Advice at = at_its_substeps();
    const Advice& safe = advice_on(all, implicit_euler);
    const bool sight = !goal.precise && !goal.keeps_size && !scene.only_pulls && !scene.varying();
    if (sight && !at.right && safe.right && !scene.is_net &&
        (made.substeps == 0 || safe.cost <= all[made.place].cost * double(made.substeps))) {
        made = asked.take(implicit_euler, 1, timestep::choice("pull").take, timestep::choice("pull").why);
        made.choice = &timestep::choice("pull");
        at = at_its_substeps();
    }
    if (made.substeps) made.position_error = at.position_error, made.rate_error = at.rate_error;
    return made;
}

}  // namespace timestep
