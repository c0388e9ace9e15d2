// Which method? The list of answers, and the way down to one.

#include "which_method.hpp"

#include <algorithm>
#include <cmath>

#include <timestep/body_throw.hpp>
#include <timestep/refuse.hpp>

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
    static const std::string alive = plain(alive_turn), fine = plain(fine_turn), twice = plain(2 * alive_turn),
                             fair = plain(fair_turn), calm = plain(calm_turn), stiff = plain(stiff_decay),
                             pendulum = plain(pendulum_turn), tether = plain(tether_turn), ended = plain(ended_swing),
                             uneven = "1/" + plain(1 / fair_uneven_turn), within = plain(100 * nearly_equal),
                             guard = plain(std::round(1e4 * std::cbrt(bullet_guard)) / 1e4);
    static const std::vector<Choice> all{
        {"positions",
         "many points whose links only have to keep their length and are corrected after each step "
         "(a rope, a cloth), with forces that depend on the position alone",
         "**Verlet**", "move a point, and its velocity follows; to set a velocity, move the position before",
         "ch4_rope", "Verlet"},
        {"bumps", "things that do little else than bump into each other",
         "**semi-implicit Euler**, with shorter steps where it shows",
         "a bounce takes the order of every other method away", "ch7_bounces", "semi-implicit Euler, new damping"},
        {"tether", "a tether: one leash between two points, a spring that only pulls",
         "**implicit Euler**; where it must bounce on, semi-implicit Euler in substeps of ωh at "
         "most " +
             tether,
         "with implicit Euler the energy never rises, slack or taut, unless the tether is tied off "
         "a centre of mass and turns a body; of the substeps nothing proves that. The library's "
         "`Tether` is a different thing: it pushes when it is short, and there implicit Euler may "
         "gain",
         "more6_tether", "implicit Euler"},
        {"uneven", "steps of uneven length, where chapter 2's game loop cannot be used",
         "**Runge–Kutta 4**, in substeps of ωh and ζωh at most " + alive +
             ". For anything faster or more damped, implicit Euler; where an oscillation must keep "
             "its size, implicit midpoint",
         "with ωh and ζωh at most " + alive +
             " no mixture of step lengths blows it up on a spring. Without a damper semi-implicit "
             "Euler and Verlet "
             "may blow up in a mixture: chapter 2's panel shows it for the first. With enough "
             "damping, taken at the new velocity, semi-implicit "
             "Euler does not: the command advise says whether yours is enough",
         "ch6_kicks", "Runge-Kutta 4"},
        {"smooth", "a smooth motion, right to one percent or better, ζ below " + stiff,
         "**Runge–Kutta 4**, with ωh and ζωh up to " + fine,
         "a percent over four periods for four forces per step, and an error that falls with the "
         "fourth power of the step",
         "ch7_spring", "Runge-Kutta 4"},
        {"smooth_pull", "the same, ζ " + stiff + " or more",
         "**BDF2**, restarted after each kick (an impulse), in substeps of ωh at most " + plain(fine_pull) + " ζ",
         "its steps follow the slow part, the fast one dies; the first step after a kick may be "
         "off by nearly all that the kick does",
         "ch6_stiff", "BDF2"},
        {"swing",
         "most of a game: ωh at most " + twice + " per frame, cut into equal steps with ωh at most " + alive + " (" +
             pendulum + " for a pendulum that swings far)",
         "**semi-implicit Euler**, with the damping at the new velocity",
         "one force and one division per step. Below ωh = 2 one damper does not make it blow up, "
         "nor do several that keep their directions, if you sweep over them there and back "
         "(chapter 3). "
         "The energy of a linear spring does not drift; under other forces it may (chapter 6)",
         "ch3_energy", "semi-implicit Euler, new damping"},
        {"net", "many stiff springs between many masses, a net, a cloth, ωh above " + twice,
         "**semi-implicit Euler**, in substeps of ωh below 2, with the dampers swept there and "
         "back as in the line above. If that takes too many substeps, use **implicit Euler** and "
         "solve the step's equations by factorisation (elimination)",
         "a substep costs one force per spring and two divisions per damper. A factorisation costs "
         "as much as many substeps; the section on cloth says how many",
         "ch6_cloth", "semi-implicit Euler, new damping"},
        {"joint", "two bodies held together by a stiff spring, a hinge or a drive, ωh above " + twice,
         "**implicit Euler**: the joint as a soft constraint, all its directions in one small "
         "system of equations",
         "while its directions stay, the joint's energy falls at every step. When they turn, each "
         "step stretches it, and a stiff joint makes that energy. An oscillation faster than the "
         "frame is not shown: it is damped out. "
         "Several stiff joints at one body, solved one after another, may blow up: solve them at "
         "once, or use substeps",
         "ch3_soft", "implicit Euler"},
        {"pull",
         "a stiff pull to a target: ωh above " + twice + ", ζωh at least " + ended +
             ". Or a decay, whose rate times h is above " + ended + " (a damper alone decays at the rate c/m)",
         "**implicit Euler**", "the decay dies, as it should", "ch6_stiff", "implicit Euler"},
        {"keeps_size", "an oscillation too fast for the frame, ωh above " + twice + ", that must keep its size",
         "**implicit midpoint**, with a constant step",
         "the energy of an undamped oscillation stays; of a decay it makes ringing", "ch6_stiff", "implicit midpoint"},
        {"unseen", "an oscillation too fast for the frame, ωh above " + twice + ", that need not keep its size",
         "**BDF2**, an implicit method that remembers two states, restarted after each impulse",
         "it lets the fast part die and keeps the slow one. With kicks in every frame it rings: "
         "then implicit Euler. "
         "Where the fast part must be seen, semi-implicit Euler in substeps of ωh at most " +
             alive,
         "ch6_two_scales", "BDF2"},
        {"jumps", "a slow motion with sudden jumps", "an **adaptive step**", "one length does not fit both",
         "ch6_jumps", ""},
        {"typed", "numbers that others type", "checks where models and runs are made", "no method survives everything",
         "ch6_extremes", ""},
        {"ball", "a body with three equal moments, or so nearly that nobody sees it: a ball, a cube",
         "**nothing**: leave the gyroscopic torque out",
         "it is zero, or next to it; `rotation_by` turns the body by h|ω| about ω, to roundoff", "ch5_orientation",
         "dropped"},
        {"callback_light",
         "a light body with two equal moments (or within " + within +
             " %), a coin, a bottle: the cube root of the product of its moments is at most " + guard +
             " kg m². It touches others, and all you can do is change ω before the engine's step",
         "in Box3D the engine's own one Newton step: leave it on. In Bullet and elsewhere "
         "**passive**, by its formula for three moments (`PrincipalInertia`)",
         "in `float` Bullet's own step is silently off for so light a body, unless it spins fast. "
         "Losing energy helps here: it hides the energy that the engine's contacts add",
         "ch8_contacts", "passive"},
        {"callback_symmetric",
         "a body with two equal moments, a capsule, a wheel, that touches others, and all you can "
         "do is change ω before the engine's step (nearly equal moments: ask `./course advise`)",
         "in Bullet and Box3D the engine's own **one Newton step**: leave it on. Elsewhere "
         "**passive**, by its formula for three moments (`PrincipalInertia`)",
         "here losing energy is wanted: it hides what the engine's contacts add. The price: spins "
         "fade too soon, and with passive a spin about the length tips over",
         "ch8_contacts", "one Newton step"},
        {"callback", "a body that touches others, and all you can do is change ω before the engine's step",
         "the **passive step** (linearly implicit, as in the engine ODE), the engine's own "
         "gyroscopic step off",
         "passive adds no energy. Contacts may; for three moments passive lost more than they "
         "added in our throws. "
         "Spins fade; a spin about the length tips over. Capsules and wheels have their own answer",
         "ch8_contacts", "passive"},
        {"callback_free", "a body that touches nothing, and all you can do is change ω before the engine's step",
         "the **calm half-step**, whole",
         "there is nothing to hide, and it keeps energy and |L|, at any spin, with any steps; the "
         "engine's turn makes the orientation rough",
         "ch8_fails", "calm half-step"},
        {"symmetric", "a body with two equal moments, a capsule, a wheel, that touches others",
         "the step for **two equal moments** (`SymmetricInertia`: passive and the "
         "calm half-step are one there), called twice with h/2: before contacts and joints, and "
         "after them, before the engine turns the body",
         "it only turns ω about the axis of the moment that differs, which keeps "
         "energy, |L| and the spin about that axis. Contacts may still add energy to fast throws "
         "(in Box3D and Jolt they do): the page In your engine has a test of that for your engine, "
         "and the cure",
         "ch5_passive", "passive"},
        {"contacts", "a body that touches others",
         "the **calm half-step**, called twice with h/2: before contacts and joints, and after "
         "them, before the engine turns the body",
         "energy and |L| stay from one impulse to the next, at any spin, with any steps. Contacts "
         "may still add energy to fast throws (in Box3D and Jolt they do): "
         "the page In your engine has a test of that for your engine, and the cure",
         "ch8_contacts", "calm half-step"},
        {"symmetric_free",
         "two equal moments, flying freely; or two within " + within +
             " %, for a throw that `./course advise` finds right",
         "**ball and remainder 2**, a splitting of order 2 into a spherical top and a remainder",
         "with two equal moments it is the exact motion but for rounding, at any spin and step", "ch8_splitting",
         "ball and remainder 2"},
        {"many_uneven",
         "thousands of flying bodies, in frames of uneven length; or thousands of flying bodies "
         "with two moments within " +
             within + " % of each other and h|ω| above " + calm,
         "the **calm half-step**, one body at a time",
         "energy and |L| stay, also when steps vary, and no spin fades; the orientation is rough. "
         "Its price is in the table at the end of chapter 8. (With a constant step inside the "
         "frames, chapter 2's, slow bodies can take the half-step Jacobian in lanes, for less)",
         "ch8_fails", "calm half-step"},
        {"many", "bodies by the thousand that fly, h|ω| at most " + calm + ", a constant step",
         "the **half-step Jacobian** (Kahan's discretisation) in SIMD lanes",
         "several bodies in the time of one; the energy is good, but fast ones soon turn at the "
         "wrong time",
         "ch8_many", "half-step Jacobian"},
        {"many_fast", "bodies by the thousand that fly faster, three different moments, a constant step",
         "**passive** in SIMD lanes; must their energy stay, the **calm half-step**, one by one",
         "spins fade under passive; a SIMD vector takes one step for all its bodies, so keep the "
         "fast ones in vectors of their own",
         "ch8_many", "passive"},
        {"energy",
         "a body that flies, and energy and |L| (L is the angular momentum) must stay before all "
         "else",
         "the **calm half-step**", "to roundoff, at any spin and when steps vary; the orientation is rough",
         "ch8_fails", "calm half-step"},
        {"free_uneven", "a body that flies freely, in frames of uneven length",
         "a constant step, and ball and remainder 4; where that cannot be, **Runge–Kutta 4**, in "
         "substeps that turn "
         "by " +
             uneven + " of a radian at most",
         "when steps vary a splitting adds up its errors, and a body thrown about its intermediate "
         "axis may be lost",
         "ch8_cost", "Runge-Kutta 4"},
        {"free", "a body that flies freely, h|ω| at most " + fair + ", a constant step",
         "**ball and remainder 4**, a splitting of order 4 into a spherical top and a remainder",
         "|L| stays, the energy is bounded, and the body points where it should, also when it "
         "turns over. (A body that comes back to its intermediate axis may turn over at the wrong "
         "time: a touch decides)",
         "ch8_work", "ball and remainder 4"},
        {"free_fast", "a body that flies freely, h|ω| above " + fair + ", a constant step",
         "**ball and remainder 4**, in substeps that turn by " + fair + " at most",
         "what is safe at long steps is not accurate there", "ch8_safe", "ball and remainder 4"},
    };
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
