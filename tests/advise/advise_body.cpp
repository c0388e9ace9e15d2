// N51, I13: the advice on which solver to take for a spinning body, against the solvers' own steps.
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include "advise_body.hpp"
#include <timestep/nearly_symmetric.hpp>

#include "chapters/06_stability/study/body_questions.hpp"

using namespace timestep;
using questions::Body;
using questions::Vector;

namespace {

const Frames at_60_hz(1.0 / 60, 1.0 / 60);
const Body box(13, 10, 5), ruler(0.0104, 1.0004, 1.01), plank(0.758, 0.787, 0.0313);

}  // namespace

// E/Δ stays, and Δ comes to 1 where the spin about the middle axis passes zero.
TEST_CASE("the half-step Jacobian's bound is reached, and 2/sqrt(c) is where it ends", "[library][I13]") {
    for (const Body& body : {box, ruler, plank}) {
        int least, most;
        body.moments.minCoeff(&least), body.moments.maxCoeff(&most);
        Vector way = Vector::Constant(1e-3);
        way[3 - least - most] = 1;
        const auto said = [&](double turn) { return body_solver(HalfStepJacobian::name).judge(body, turn, 1, true); };
        const double end = said(1).longest_step;
        for (const double part : {0.1, 0.5, 0.9}) {
            const BodyAdvice advice = said(part * end);
            REQUIRE(advice.adds == AddsEnergy::bounded);
            const Thrown thrown = throw_body(tumble<HalfStepJacobian>, body, Vector(part * end * way.normalized()),
                                             Frames(1, 1), 1e9, 3000);
            CAPTURE(body.moments.transpose(), part, advice.bound, thrown.most_energy);
            CHECK(thrown.most_energy <= advice.bound * (1 + 1e-10));
            CHECK(thrown.most_energy - 1 > 0.9 * (advice.bound - 1));
        }
        CHECK(said(1.01 * end).adds == AddsEnergy::one_step_can);
        CHECK(end >= 2);
    }
}

TEST_CASE("a watched throw has the energy, spin and orientation of the motion", "[library][I13]") {
    // Of two equal moments ball and remainder is the exact motion.
    const Body wheel(1, 1, 1.8);
    const Vector omega(2, 1, 9);
    const Thrown exact = throw_body(ball_and_remainder_2, wheel, omega, at_60_hz);
    CHECK(std::abs(exact.seconds - 10) < 1e-9);
    CHECK(std::abs(exact.energy - 1) < 1e-12);
    CHECK(exact.off < 1e-9);
    CHECK_FALSE(exact.lost);
    CHECK(std::abs(exact.spin_left - throw_exactly(wheel, omega).spin_left) < 1e-9);
    // A method of order two: half the step, a quarter of the error.
    const auto off = [&](double rate) {
        return throw_body(tumble<HalfStepJacobian>, box, Vector(1, 2, 2), Frames(1 / rate, 1 / rate)).off;
    };
    CHECK(std::abs(off(120) / off(240) - 4) < 0.1);
    const Thrown blown = throw_body(tumble<ExplicitGyroscopic>, box, Vector(20, 30, 5), at_60_hz);
    CHECK(std::isinf(blown.most_energy));
    CHECK(blown.lost);
    CHECK(throw_body(tumble<PassiveGyroscopic>, box, Vector(5, 10, 5), at_60_hz).energy < 0.99);
    CHECK(throw_body(tumble<NoGyroscopic>, box, Vector(5, 10, 5), at_60_hz).spin_left == 1);
    // Nobody knows where a body points after 1e12 turns, and the advice does not pretend to.
    CHECK(std::isnan(throw_body(strang, box, Vector(1e12, 1e12, 0), at_60_hz).off));
}

TEST_CASE("two nearly equal moments, declared equal, keep the spin that passive would take", "[library][I13]") {
    const ClosestMoments closest = closest_moments(plank);
    CHECK(closest.odd == 2);
    CHECK(std::abs(closest.apart - 0.029 / 0.787) < 1e-12);
    CHECK(closest.all_but_equal());
    CHECK_FALSE(closest_moments(box).all_but_equal());
    CHECK(std::abs(closest.equal[0] - 0.7725) < 1e-12);
    const double gone = half_gone_by_passive(plank, 20, at_60_hz);
    const Vector about_length = as_thrown(Vector(0, 0, 20));
    const auto left = [&](double seconds) {
        return throw_body(tumble<PassiveGyroscopic>, plank, about_length, at_60_hz, seconds).spin_left;
    };
    CAPTURE(gone, left(gone), left(gone - 0.05));
    CHECK(left(gone) < 0.51);
    CHECK(left(gone - 0.05) > 0.5);
    CHECK(throw_body(DeclaredEqual(plank), plank, about_length, at_60_hz).spin_left > 0.999);
    CHECK(std::isinf(half_gone_by_passive(Body(1, 1.02, 1.9), 20, at_60_hz)));  // it ends about the largest moment
}

TEST_CASE("a free body is recommended as many substeps as its turn needs", "[library][I13]") {
    // Spun in a direction in which all three moments count.
    const auto omega = [](double spin) { return Vector(spin / 9 * Vector(4, 7, 4)); };
    const Frames uneven(0.01, 1.0 / 60);
    const auto substeps = [&](double spin, const Frames& frames) {
        return recommend(box, omega(spin), frames).substeps;
    };
    CHECK(substeps(15, at_60_hz) == 1);
    CHECK(substeps(15.1, at_60_hz) == 2);
    CHECK(substeps(100, at_60_hz) == 7);
    CHECK(substeps(10, uneven) == 2);
    CHECK(substeps(1e-3, uneven) == 1);
    CHECK(substeps(1.4999e10, at_60_hz) == 999'933'334);
    CHECK_THROWS_AS(recommend(box, Vector(1e10, 0, 0), Frames(0.01, 0.02)), std::invalid_argument);  // 1e9 of 1/12
}

TEST_CASE("a body with two nearly equal moments is advised by what its throw does", "[library][I13]") {
    const auto asked = [](const Body& body, const Vector& omega, long count = 1) {
        return recommend(body, omega, at_60_hz, false, count);
    };
    const Body football(1, 1.02, 0.18), spear(0.3333, 0.3330, 0.0004);
    CHECK(asked(Body(1, 1.0000001, 0.5), Vector(1, 2, 20)).choice.name == "symmetric_free");
    CHECK(asked(Body(1, 1.000001, 0.18), Vector(0, 0, 63), 10'000).choice.name == "symmetric_free");
    CHECK(asked(spear, Vector(0.3, 0, 30)).choice.name == "symmetric_free");
    // Along its length, and across, where it turns over.
    CHECK(asked(football, Vector(0, 0, 63)).choice.name == "symmetric_free");
    CHECK(asked(football, Vector(63, 0, 0)).choice.name == "free_fast");
    CHECK(asked(football, Vector(63, 0, 0), 10'000).choice.name == "many_uneven");
    CHECK(asked(spear, Vector(0, 30, 0)).choice.name == "free_fast");
}

// Two moments that are close, and slow enough: then no Newton step of the engine gains.
TEST_CASE("a callback leaves the engine's own step on where that adds next to nothing", "[library][I13]") {
    const auto asked = [](const Body& body, double spin) {
        return recommend(body, Vector(0, 0, spin), at_60_hz, true, 1, true).choice.name;
    };
    CHECK(asked(Body(1, 1.001, 0.18), 20) == "callback_symmetric");
    CHECK(asked(Body(1, 1.001, 0.18), 60) == "callback_symmetric");
    CHECK(asked(Body(1, 1.02, 0.18), 20) == "callback_symmetric");
    CHECK(asked(Body(1, 1.02, 0.18), 120) == "callback");
    CHECK(asked(plank, 20) == "callback");
    CHECK(asked(Body(1, 1.2, 0.3), 1) == "callback");
    CHECK(asked(Body(3.9e-7, 3.9e-7, 7.6e-7), 100) == "callback_light");
    questions::Random random(13);
    int left_on = 0;
    for (int i = 0; i < 40; ++i) {
        const double apart = random.even_in_log(1e-6, nearly_equal);
        const Body body(1, 1 - apart, random.even_in_log(std::max(0.02, 1.1 * apart), 1.9));
        const double spin = random.even_in_log(5, 300);
        if (asked(body, spin) != "callback_symmetric") continue;
        ++left_on;
        double most = 0;
        for (int n = 0; n < 2000; ++n) {
            const Vector direction = n % 2 ? random.direction() : random.near_middle(body);
            most = std::max(most, body_solver(ImplicitGyroscopic::name).gain(body, Vector(spin / 60 * direction)));
        }
        CAPTURE(apart, body.moments.transpose(), spin, most);
        CHECK(most < 1.0011);
    }
    CHECK(left_on > 10);
}

// A roll about the length of a spear is not seen.
TEST_CASE("a body of revolution is lost when its axis is, not when its roll is", "[library][I13]") {
    const Body spear(0.3333, 0.3330, 0.0004);
    CHECK(axis_of_revolution(spear) == 2);
    CHECK(axis_of_revolution(Body(1, 0.3, 1)) == 1);
    CHECK(axis_of_revolution(box) == -1);
    CHECK(axis_of_revolution(Body(1, 1, 1)) == -1);
    CHECK(axis_of_revolution(Body(1, 1.02, 1.03)) == -1);
    const Vector omega(0.3, 0, 30);
    const Thrown thrown = throw_body(tumble<HalfStepJacobian>, spear, omega, at_60_hz);
    CHECK(thrown.off > 1);  // all of it roll: the turn by the mean falls short by (h|ω|)³/12 a step
    CHECK(thrown.axis_off < 0.04);
    CHECK_FALSE(thrown.lost);
    // The axis as the exact motion has it, about the world's L.
    const Thrown dropped = throw_body(tumble<NoGyroscopic>, spear, omega, at_60_hz);
    CHECK(dropped.axis_off > 0.5);
    CHECK(dropped.lost);
    CHECK(throw_body(ball_and_remainder_2, spear, omega, at_60_hz).axis_off < 1e-6);
    CHECK(std::isnan(throw_body(strang, box, omega, at_60_hz).axis_off));
    // Explicit is beyond all numbers.
    const Thrown blown = throw_body(tumble<ExplicitGyroscopic>, spear, omega, at_60_hz);
    CHECK((blown.lost && blown.axis_off == 2));
}

TEST_CASE("advice on a body depends on the ratios of its moments only, and refuses what is no spin", "[library][I13]") {
    const Vector omega(3, 10, 1);
    const auto plain = advise_body(Body(1, 2, 2.5), omega, at_60_hz);
    REQUIRE(plain.size() == 13);
    for (const double unit : {1e306, 1e-300}) {
        const auto all = advise_body(Body(unit, 2 * unit, 2.5 * unit), omega, at_60_hz);
        for (std::size_t i = 0; i < all.size(); ++i) {
            CAPTURE(unit, all[i].method);
            CHECK(all[i].adds == plain[i].adds);
            CHECK(std::abs(all[i].thrown.off - plain[i].thrown.off) < 1e-6);
            CHECK((all[i].thrown.energy == plain[i].thrown.energy ||
                   std::abs(all[i].thrown.energy / plain[i].thrown.energy - 1) < 1e-6));
        }
    }
    CHECK_THROWS_AS(advise_body(box, Vector(0, 0, 0), at_60_hz), std::invalid_argument);
    CHECK_THROWS_AS(advise_body(box, Vector(INFINITY, 0, 0), at_60_hz), std::invalid_argument);
    CHECK_THROWS_AS(advise_body(box, Vector(1e60, 0, 0), at_60_hz), std::invalid_argument);
    CHECK_NOTHROW(advise_body(box, Vector(1e49, 1e49, 0), at_60_hz));
    CHECK_NOTHROW(advise_body(box, Vector(1e-30, 0, 0), at_60_hz));
}
