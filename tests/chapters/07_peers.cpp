// What chapter 7 rests on where it compares libraries: they do the same sums, and their times are
// those of the runs whose errors are shown.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <timestep/methods.hpp>

#include "contest/entries.hpp"
#include "contest/peer.hpp"
#include "contest/scenes.hpp"

using namespace contest;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

std::vector<Scene> scenes_of_states() {
    std::vector<Scene> scenes;
    for (const auto make : {projectile, drag, spring, damped_spring, spring_3d, stiff_spring, two_time_scales})
        scenes.push_back(make());
    return scenes;
}

const Entry* ours(const Scene& scene, const std::string& method) {
    for (const Entry& e : scene.entries)
        if (e.library == "Timestep" && e.method == method) return &e;
    return nullptr;
}

double size(const Scene& scene, const Place& place) { return distance(scene, place, Place(place.size(), 0.0)); }

// Two programs that do the same sums in different orders drift apart by roundoff. A step is some
// ten roundings in each, by half an ε of what is on its way in the step: that is no more than 10 ε
// of the largest place so far. Stable methods, and a flight, carry such an error on without making
// it larger than the time that it has, of the order of one. Where a method blows up, an error grows
// as the motion does, so in proportion to it it stays what it was; only in the scene with two time
// scales the motion that blows up begins as a thousandth of the whole, and the roundings count a
// thousandfold.
void check_same_motion(const Scene& scene, const Track& a, const Track& b, long steps) {
    REQUIRE(a.size() == std::size_t(marks));
    REQUIRE(b.size() == std::size_t(marks));
    double largest = 1, furthest = 0;
    for (int mark = 0; mark < marks; ++mark) {
        largest = std::max(largest, size(scene, a[mark]));
        if (!(largest < 1e100)) break;
        furthest = std::max(furthest, distance(scene, a[mark], b[mark]) / largest);
    }
    CAPTURE(furthest);
    CHECK(furthest <= 10 * eps * double(steps + 1000));
}

}  // namespace

TEST_CASE("where a library has a method of ours, it goes where ours goes", "[N61][ch7]") {
    for (const Scene& scene : scenes_of_states())
        for (const Entry& peer : scene.entries) {
            const Entry* const same = ours(scene, peer.method);
            if (peer.library.starts_with("Timestep") || !same) continue;
            for (const long steps : {30L, 120L, 480L, 30L << 6, 30L << 10}) {
                CAPTURE(scene.id, peer.library, peer.method, steps);
                check_same_motion(scene, same->track(steps), peer.track(steps), steps);
            }
        }
}

TEST_CASE("GSL's Runge-Kutta 4 ends where ours ends with half the step, for eleven evaluations", "[N61][ch7]") {
    for (const Scene& scene : scenes_of_states())
        for (const Entry& peer : scene.entries) {
            if (peer.method != "Runge-Kutta 4, doubled") continue;
            for (const long steps : {30L, 480L, 30L << 8}) {
                CAPTURE(scene.id, steps);
                check_same_motion(scene, ours(scene, "Runge-Kutta 4")->track(2 * steps), peer.track(steps), 2 * steps);
                CHECK(peer.work(steps).evaluations == 11 * steps);
            }
        }
}

TEST_CASE("a method asks for the force as often as its cost says, whoever has written it", "[I12][ch7]") {
    std::map<std::string, timestep::Cost> costs;
    const auto add = [&](const auto& method) { costs[method.name] = method.cost; };
    timestep::for_each_method(add);
    timestep::for_each_verlet_method(add);
    for (const auto make : {spring, damped_spring, spring_3d, stiff_spring, two_time_scales})
        for (const Scene scene = make(); const Entry& e : scene.entries) {
            if (!costs.contains(e.method)) continue;
            const long steps = 90;
            const Work work = e.work(steps);
            CAPTURE(scene.id, e.library, e.method);
            CHECK(work.steps == steps);
            // Who keeps the force at the end of a step for the next one has one more at the start:
            // Boost's velocity Verlet, which so asks once a step, and SUNDIALS.
            const bool keeps =
                e.library == "SUNDIALS" || (e.library == "Boost.odeint" && e.method == "velocity Verlet");
            const long each =
                costs[e.method].evaluations - (e.library == "Boost.odeint" && e.method == "velocity Verlet");
            CHECK(work.evaluations == each * steps + keeps);
            CHECK(work.solves == costs[e.method].solves * steps);
        }
}

TEST_CASE("the run that is timed is the run whose error is shown, however often it is run", "[N61][ch7]") {
    auto scenes = scenes_of_states();
    scenes.push_back(bouncing_ball());
    for (const Scene& scene : scenes)
        for (const Entry& e : scene.entries) {
            CAPTURE(scene.id, e.library, e.method);
            const Track track = e.track(480);
            e.run(60);
            e.run(480);
            const double end = sink;
            const bool same = end == track.back()[0] || (std::isnan(end) && std::isnan(track.back()[0]));
            CHECK(same);
        }
}

// A method that chooses its steps guesses the error of each and keeps the guess to the tolerance.
// Where nothing grows the errors add up, in the worst case to the steps taken times the tolerance.
// (What a velocity is wrong by, in metres a second, moves the body for 4 s on a flight and 1/ω on a
// spring; that errors all point one way is so unlikely that this bound holds nonetheless.) And a
// tolerance 256 times smaller has to help: tenfold, or until the error is below the tolerance
// itself, as it is where the marks keep the steps short.
TEST_CASE("methods that choose their steps keep to the tolerance", "[N61][ch7]") {
    for (const Scene& scene : scenes_of_states())
        for (const Entry& e : scene.entries) {
            if (!e.adaptive) continue;
            const auto error = [&](long steps) {
                const Track track = e.track(steps);
                double largest = 0;
                for (int mark = 0; mark < marks; ++mark)
                    largest = std::max(largest, distance(scene, track[mark], scene.reference[mark]));
                return largest;
            };
            const long rough = 30L << 6, fine = 30L << 10;
            CAPTURE(scene.id, e.library, e.method, error(rough), error(fine), e.work(rough).steps);
            for (const long steps : {rough, fine}) {
                const Work work = e.work(steps);
                CHECK(error(steps) < tolerance(steps) * double(work.steps));
                CHECK(work.steps < work.evaluations);
            }
            CHECK(error(fine) < std::max(error(rough) / 10, tolerance(fine)));
        }
}
