// The rigid bodies of chapter 7: their references, and that other people's solvers are ours.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef TIMESTEP_WITH_BULLET
#include <LinearMath/btScalar.h>
#endif

#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/measured_order.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "contest/scenes.hpp"
#include "contest/sliding_capsule.hpp"
#include "extrapolation.hpp"

using namespace contest;
using namespace timestep;
using V = Vector3<double>;
using Long = long double;

namespace {

const Entry& find(const Scene& scene, const std::string& method, const std::string& library = "Timestep") {
    for (const Entry& entry : scene.entries)
        if (entry.method == method && entry.library == library) return entry;
    throw std::logic_error(method + ", " + library + ": not in the scene");
}

// In the first `looked_at` marks.
double largest_distance(const Scene& scene, const Track& a, const Track& b, int looked_at = marks) {
    REQUIRE(a.size() == marks);
    REQUIRE(b.size() == marks);
    double largest = 0;
    for (int i = 0; i < looked_at; ++i) largest = std::max(largest, distance(scene, a[i], b[i]));
    return largest;
}

// How far our run of 240 steps is from another library's.
[[maybe_unused]] double apart(const Scene& scene, const std::string& ours, const std::string& theirs,
                              const std::string& library, int looked_at) {
    return largest_distance(scene, find(scene, ours).track(240), find(scene, theirs, library).track(240), looked_at);
}

// The motion of a free body, without ω: L stands still in the world, so Ṙ = (R I⁻¹ Rᵀ L) × R.
Track turned_by_momentum(const Vector3<Long>& moments, const Vector3<Long>& omega) {
    const Vector3<Long> L = moments.cwiseProduct(omega);
    Matrix3<Long> R = Matrix3<Long>::Identity();
    const auto rate = [&](Long, const Matrix3<Long>& at) {
        const Vector3<Long> in_body = at.transpose() * L;
        return Matrix3<Long>(skew<Long>(at * in_body.cwiseQuotient(moments)) * at);
    };
    Track track;
    for (int mark = 0; mark < marks; ++mark) {
        R = test_support::extrapolated(rate, R, Long(0), Long(duration) / marks / 40, 40);
        const Matrix3<double> numbers = R.cast<double>();
        track.push_back(Place(numbers.data(), numbers.data() + 9));
    }
    return track;
}

}  // namespace

TEST_CASE("the free bodies' references agree with an independent integration", "[N40][N61][ch7]") {
    if (std::numeric_limits<Long>::digits == std::numeric_limits<double>::digits) SKIP("long double is double");
    // The integration is of order 16 with steps of 3 ms. But the box amplifies: where it turns over, an
    // error grows by e^(4.8 t/s), and with it the integration's own roundoff.
    const Scene box_scene = dzhanibekov();
    const auto brick = turned_by_momentum(box(12.0L, 1.0L, 2.0L, 3.0L).moments, {0.25L, 10, 0.25L});
    CHECK(largest_distance(box_scene, box_scene.reference, brick) < box_scene.reference_error);

    const Scene top = symmetric_top();
    const auto pill = capsule(1.0, 0.15, 0.6);
    const auto turned = turned_by_momentum({pill.across, pill.across, pill.along}, {2, 0, 6});
    // Nothing grows here. Nine numbers of size one, rounded to double: an ε each at most.
    const double roundoff = 8 * std::numeric_limits<double>::epsilon();
    CHECK(largest_distance(top, top.reference, turned) < roundoff);
}

TEST_CASE("the capsule on ice: the reference is where short steps of any method lead", "[N36][ch7]") {
    const Scene scene = capsule_on_plane();
    const SlidingCapsule::Body body{capsule(1.0, 0.15, 0.6), 1.0, 0.15, 0.3};
    const plane::Orientation leaning(Eigen::AngleAxisd(0.2, V::UnitX()));
    const auto start = plane::placed(body, leaning, V(1, 0, 6), 0.3);
    const SlidingCapsule exact(body, 9.81, start, 1000), finer(body, 9.81, start, 2000);
    double off = std::fabs(exact.lies() - finer.lies());
    for (int mark = 1; mark <= marks; ++mark) {
        const double t = duration * mark / marks;
        off = std::max(off, (exact(t).x - finer(t).x).norm());
        off = std::max(off, exact(t).turning.q.angularDistance(finer(t).turning.q));
    }
    CHECK(off < scene.reference_error);
    CHECK(exact.lands() > 0.1);
    CHECK(exact.lies() > exact.lands() + 0.1);
    CHECK(exact.lies() < duration);
    // It slides off without leaving the ice.
    for (double t = exact.lands(); t < exact.lies(); t += 1e-3) CHECK(exact.pressure(t) > 0);

    for (const std::string method : {"explicit", "one Newton step", "passive", "passive, arms of the start",
                                     "Runge-Kutta 4 in the air, passive"}) {
        const Entry& entry = find(scene, method);
        std::vector<double> steps, errors;
        std::vector<Track> tracks;
        for (const long n : {1920, 3840, 7680}) {
            steps.push_back(duration / double(n));
            tracks.push_back(entry.track(n));
            errors.push_back(largest_distance(scene, tracks.back(), scene.reference));
        }
        INFO(method << ": " << errors[0] << ", " << errors[1] << ", " << errors[2]);
        // Order one, also where it is four in the air. error = C h + D h² with D/C at most some six
        // times the spin of 6 rad/s: the slope is off by 36/480 at most.
        CHECK(std::fabs(measured_order(steps, errors) - 1) < 0.08);
        // Without C h, which is extrapolated away, the methods lead to the reference a good deal closer.
        Track led_to = tracks[2];
        for (std::size_t mark = 0; mark < led_to.size(); ++mark)
            for (std::size_t i = 0; i < led_to[mark].size(); ++i)
                led_to[mark][i] += tracks[2][mark][i] - tracks[1][mark][i];
        CHECK(largest_distance(scene, led_to, scene.reference) < errors[2] / 10);
    }
}

TEST_CASE("with friction and rolling resistance shorter steps do not settle the throw", "[N36][ch7]") {
    const plane::Capsule<SymmetricInertia<double>> body{capsule(1.0, 0.15, 0.6), 1.0, 0.15, 0.3};
    const plane::Orientation leaning(Eigen::AngleAxisd(0.2, V::UnitX()));
    const auto after = [&](long steps) {
        const plane::Ground rough{9.81, 0.5, 0.1, plane::Arms::middle};
        plane::BodyState m = plane::placed(body, leaning, V(1, 0, 6), 0.3);
        plane::Contacts contacts;
        for (long i = 0; i < steps; ++i)
            m = plane::step(passive_gyroscopic, body, rough, m, duration / double(steps), contacts);
        return m.turning.q;
    };
    // Of order one, halving h six times would leave a thirty-second of the first change.
    std::vector<double> changes;
    Quaternion<double> before = after(480);
    for (long steps = 960; steps <= 480 * 64; steps *= 2) {
        const Quaternion<double> now = after(steps);
        changes.push_back(now.angularDistance(before));
        before = now;
    }
    CHECK(*std::max_element(changes.end() - 3, changes.end()) > changes[0] / 8);
}

#ifdef TIMESTEP_WITH_BULLET
TEST_CASE("Bullet's runs are ours", "[N48][ch7]") {
    // A step is off by some 32 ε of ω, so n steps by n² h |ω| 16 ε if nothing makes it grow: for the
    // capsule, at 60 Hz and 6 rad/s, 0.01. In the box the difference grows as the tumble does, by
    // e^(4.8 t/s): we look at the first half second, in which 16 n² ε h |ω| e^2.4 is 0.003.
    const std::string method = "one Newton step";
    const std::string real = sizeof(btScalar) == sizeof(float) ? ", float" : "";
    const std::string three = method + ", three moments" + real;
    CHECK(apart(symmetric_top(), three, three, "Bullet", marks) < 0.01);
    CHECK(apart(dzhanibekov(), method + real, method + real, "Bullet", 4) < 0.003);
}
#endif

#ifdef TIMESTEP_WITH_ODE
TEST_CASE("ODE's runs are ours", "[N51][ch7]") {
    // As for Bullet, in double: n² h |ω| times 100 ε is 1e-10 for 240 steps; in the box times e^2.4.
    const std::string three = "passive, three moments", world = ", in a world's step";
    CHECK(apart(symmetric_top(), three, three + world, "ODE", marks) < 1e-10);
    CHECK(apart(dzhanibekov(), "passive", "passive" + world, "ODE", 4) < 1e-9);
}
#endif
