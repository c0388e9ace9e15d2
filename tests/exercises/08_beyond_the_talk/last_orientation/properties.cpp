#include "last_orientation.hpp"

#include "property_eigen.hpp"
#include "last_comparison.hpp"

// There are several turns of order two that the mean of two spins may stand for: by its angle, by Cayley's formula,
// by halves. It is the properties that say how near they are to each other.
EXERCISE_WITHIN(last_orientation, checker::many_are_right);

namespace {

// q and -q are the same orientation.
double apart(const Quaterniond& a, const Quaterniond& b) {
    return std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

// q, and then a turn by the length of a vector in the body's axes, about it.
Quaterniond turned(const Quaterniond& q, const Vector3d& turn) {
    return (q * Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()))).normalized();
}

// Is it so far from what is right at most? The learner is told both.
bool is_near(const Quaterniond& found, const Quaterniond& right, double allowed) {
    const auto shown = [&](const Quaterniond& q) {
        const double sign = q.dot(right) < 0 ? -1 : 1;
        std::string words = "{";
        for (int i = 0; i < 4; ++i)
            words += std::string(i > 0 ? ", " : "") + "xyzw"[i] + " " + checker::in_words(sign * q.coeffs()[i] + 0.0);
        return words + "}";
    };
    return checker::told(apart(found, right) <= allowed, "The orientation is " + shown(found) + ", and must be " +
                                                             shown(right) + ", or its negative: they are " +
                                                             checker::in_words(apart(found, right)) + " apart.");
}

struct Replay {
    Quaterniond q;
    std::vector<double> times;
    std::vector<Vector3d> spins;

    Quaterniond answer() const { return learner(q, times, spins); }
    double duration() const { return times.back() - times.front(); }
    // Does each gap turn the body by the mean of its two spins? By Cayley's formula the turn lags behind by angle^3/12,
    // and half of that shows in a quaternion; two halves, one about each spin, differ by a turn of an eighth of the
    // product of their angles.
    bool is_turned_by_means(double allowed) const {
        Quaterniond right = q;
        for (std::size_t k = 1; k < times.size(); ++k) {
            const double gap = times[k] - times[k - 1];
            const Vector3d turn = gap / 2 * (spins[k - 1] + spins[k]);
            if (turn.norm() > 0) right = turned(right, turn);
            allowed += std::pow(turn.norm(), 3) / 20 + gap * gap * spins[k - 1].cross(spins[k]).norm() / 14;
        }
        return is_near(answer(), right, allowed);
    }
};

// Frames at uneven times; from one to the next the body turns by `turn` at most. Of five gaps one,
// two or three are none: the game was paused. Nothing begins at zero.
Replay draw_replay(Draw& draw, int frames, double turn) {
    Replay replay{draw_rotation(draw), {draw.real(-100, 100)}, {}};
    const double speed = draw.log(0.1, 50);
    const int pause = draw.integer(1, 3);
    for (int i = 0; i < frames; ++i) {
        replay.spins.push_back(draw.real(0.1, 1) * speed * draw_direction(draw));
        if (i == 0) continue;
        const double gap = i % 5 >= 5 - pause ? 0 : draw.real(0.2, 1) * turn / speed;
        replay.times.push_back(replay.times.back() + gap);
    }
    return replay;
}

Replay draw_steady(Draw& draw, int frames, double turn) {
    Replay replay = draw_replay(draw, frames, turn);
    const Vector3d spin = replay.spins[0];
    for (Vector3d& s : replay.spins) s = spin;
    return replay;
}

// A spin that changes smoothly, and frames at uneven times, which are closer the more there are.
struct Smooth {
    explicit Smooth(Draw& draw)
        : q(draw_rotation(draw)),
          mean(0.5 * draw_direction(draw)),
          swing(draw_direction(draw)),
          twist(0.5 * swing.cross(draw_direction(draw))),
          begin(draw.real(-5, 5)),
          uneven(draw.real(0.3, 0.8)) {}

    Vector3d spin(double t) const {
        const double phase = 1.5 * (t - begin) + 0.5;
        return mean + std::cos(phase) * swing + std::sin(phase) * twist;
    }
    // The replay is 2 s long.
    Replay replay(int gaps) const {
        Replay frames{q, {}, {}};
        for (int i = 0; i <= gaps; ++i) {
            const double share = 1.0 * i / gaps;
            const double wave = uneven * std::sin(2 * std::numbers::pi * share);
            const double t = begin + 2 * share + wave / std::numbers::pi;
            frames.times.push_back(t);
            frames.spins.push_back(spin(t));
        }
        return frames;
    }
    // Runge and Kutta on q' = q omega / 2.
    Quaterniond exact() const {
        using Four = Eigen::Vector4d;
        const auto slope = [&](double t, const Four& y) -> Four {
            const Vector3d half = spin(t) / 2;
            return (Quaterniond(y) * Quaterniond(0, half.x(), half.y(), half.z())).coeffs();
        };
        Four y = q.coeffs();
        const int steps = 1000;
        const double h = 2.0 / steps;
        for (int i = 0; i < steps; ++i) {
            const double t = begin + i * h;
            const Four k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1), k3 = slope(t + h / 2, y + h / 2 * k2),
                       k4 = slope(t + h, y + h * k3);
            y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        return Quaterniond(y);
    }

    Quaterniond q;
    Vector3d mean, swing, twist;
    double begin, uneven;
};

}  // namespace

PROPERTY("one frame leaves the orientation as it is, and so does a pause, or a replay without spin") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Replay one = draw_replay(draw, 1, 0.1);
        REQUIRE(is_near(one.answer(), one.q, 1e-6));
        Replay still = draw_replay(draw, 10, 0.1);
        for (Vector3d& spin : still.spins) spin.setZero();
        REQUIRE(is_near(still.answer(), still.q, 1e-6));
        Replay paused = draw_replay(draw, static_cast<int>(draw.log(2, 100)), 0.1);
        for (double& t : paused.times) t = paused.times[0];
        REQUIRE(is_near(paused.answer(), paused.q, 1e-6));
    }
}

// Of the usual turns the one of Cayley is the least exact: in a gap it lags behind by angle^3/12.
PROPERTY("a constant spin turns the body by |spin| times the time from first frame to last") {
    Draw draw;
    for (int i = 0; i < 40; ++i) {
        const Replay steady = draw_steady(draw, draw.integer(2, 12), i % 2 == 0 ? 0.02 : 0.1);
        const Vector3d spin = steady.spins[0];
        const Vector3d turn = steady.duration() * spin;
        double allowed = 1e-5;
        for (std::size_t j = 1; j < steady.times.size(); ++j)
            allowed += std::pow(spin.norm() * (steady.times[j] - steady.times[j - 1]), 3) / 20;
        REQUIRE(is_near(steady.answer(), turned(steady.q, turn), allowed));
    }
}

PROPERTY("from one frame to the next the body turns by the mean of the two spins") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        Replay replay = draw_replay(draw, 2, 0.1);
        replay.times = {0, draw.real(0.2, 1) / 10 / std::max(replay.spins[0].norm(), replay.spins[1].norm())};
        REQUIRE(replay.is_turned_by_means(1e-6));
    }
}

// What was the last frame comes first, each spin is turned round, and time runs from the end. The
// gaps are rounded as the times are, which are below 200 s: 3e-14 s, at 50 rad/s.
PROPERTY("the replay backwards leads back to where it came from, to twelve digits") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Replay replay = draw_replay(draw, draw.integer(2, 12), 0.1);
        REQUIRE(close(replay.answer().norm(), 1, 1e-13));
        Replay back{replay.answer(), {}, {}};
        for (std::size_t j = replay.times.size(); j-- > 0;) {
            back.times.push_back(-replay.times[j]);
            back.spins.push_back(-replay.spins[j]);
        }
        REQUIRE(is_near(back.answer(), replay.q, 1e-12));
    }
}

PROPERTY("it is right wherever the task allows: tiny turns, tiny gaps, spins of unlike length, pauses between") {
    Draw draw;
    Every all;
    for (int i = 0; i < 300; ++i) {
        const double angle = draw.log(1e-12, 0.1), gap = draw.any_of(1e-9, 100, {1e-9, 1.0 / 60, 100});
        Replay one{draw_rotation(draw), {0, gap}, {}};
        for (int end = 0; end < 2; ++end)
            one.spins.push_back(draw.any_of(0, 1, {0, 1}) * angle / gap * draw_direction(draw));
        const Vector3d axis = draw.sign() * Vector3d::Unit(i / 5 % 3);
        if (i % 5 == 3)
            for (Vector3d& spin : one.spins) spin = spin.norm() * axis;
        if (i % 4 == 0) one.spins[1] = draw.log(0.1, 1) * one.spins[0];
        for (int pause = i % 3 == 0 ? draw.integer(1, 3) : 0; pause > 0; --pause) {
            const int frame = i % 2 == 0 ? 0 : static_cast<int>(one.times.size()) - 1;
            one.times.insert(one.times.begin() + frame, one.times[frame]);
            one.spins.insert(one.spins.begin() + frame, one.spins[frame]);
        }
        all &= one.is_turned_by_means(1e-14);
    }
    REQUIRE(bool(all));
}

// Three spins in turn, of which no number of frames brings the body back.
PROPERTY("each of up to a thousand frames turns the body") {
    Draw draw;
    for (int i = 0; i < 8; ++i) {
        const int frames = i == 0 ? 1000 : i == 1 ? 999 : static_cast<int>(draw.spread(20, 1001, i, 6));
        Replay replay = draw_replay(draw, frames, draw.log(1e-3, 0.1));
        const double begin = replay.times[0];
        for (double& t : replay.times) t -= begin;
        REQUIRE(replay.is_turned_by_means(1e-9));
    }
}
