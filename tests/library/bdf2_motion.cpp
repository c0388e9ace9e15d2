// BDF2 in a game: things happen between the steps.
#include <catch2/catch_test_macros.hpp>

#include <timestep/methods/bdf2.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

namespace {

const DampedSpring<double> spring(10.0, 0.2);
constexpr double h = 1.0 / 60;

bool same(const State<double>& a, const State<double>& b) { return a.t == b.t && a.x == b.x && a.v == b.v; }

}  // namespace

TEST_CASE("left alone a motion by BDF2 is a run of it", "[library]") {
    const State<double> start{0, 1, -2};
    Bdf2Motion motion(start);
    CHECK(same(motion.now(), start));
    for (int n = 1; n <= 50; ++n) {
        motion.step(spring, h);
        CHECK(same(motion.now(), run(bdf2, spring, start, h, n)));
    }
}

TEST_CASE("after a restart a motion by BDF2 knows nothing of what was before", "[library]") {
    Bdf2Motion motion(State<double>{0, 1, 0});
    for (int n = 0; n < 10; ++n) motion.step(spring, h);
    const State<double> kicked{motion.now().t, motion.now().x, motion.now().v + 1};
    motion.restart(kicked);
    CHECK(same(motion.now(), kicked));
    Bdf2Motion anew(kicked);
    for (int n = 0; n < 10; ++n) {
        motion.step(spring, h), anew.step(spring, h);
        CHECK(same(motion.now(), anew.now()));
    }
}

TEST_CASE("a step of another length is a restart of a motion by BDF2", "[library]") {
    Bdf2Motion motion(State<double>{0, 1, 0});
    for (int n = 0; n < 10; ++n) motion.step(spring, h);
    Bdf2Motion anew(motion.now());
    for (const double length : {2 * h, 2 * h, h, h}) {
        motion.step(spring, length), anew.step(spring, length);
        CHECK(same(motion.now(), anew.now()));
    }
}
