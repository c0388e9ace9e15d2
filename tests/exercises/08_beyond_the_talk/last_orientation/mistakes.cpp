#include "exercise_eigen.hpp"

#include <functional>

using Times = std::vector<double>;
using Spins = std::vector<Vector3d>;

// What the mistakes are put together from, so that it is compiled once: q, and then a turn of so many radians about
// `axis`, which has the length one or zero.
static Quaterniond turned(const Quaterniond& q, double angle, const Vector3d& axis) {
    const Vector3d v = std::sin(angle / 2) * axis;
    return q * Quaterniond(std::cos(angle / 2), v.x(), v.y(), v.z());
}
static Quaterniond turned(const Quaterniond& q, const Vector3d& turn) {
    return turned(q, turn.norm(), turn.normalized()).normalized();
}

// The sum of the spins at both ends of the gap that ends at frame i, and its length.
static Vector3d sum_of(const Spins& spins, std::size_t i) {
    return spins[i - 1] + spins[i];
}
static double gap_of(const Times& times, std::size_t i) {
    return times[i] - times[i - 1];
}

// A value, since an expression of Eigen's would outlive what it is made of.
static Vector3d scaled(double factor, const Vector3d& spin) {
    return factor * spin;
}

// From frame to frame, with what `turn(i)` says of the gap that ends at frame i.
static Quaterniond through(Quaterniond q, std::size_t frames, const std::function<Vector3d(std::size_t)>& turn) {
    for (std::size_t i = 1; i < frames; ++i) q = turned(q, turn(i));
    return q;
}

// Says: Each gap is turned with the new spin alone, as in the talk: the orientation has order one.
// Hint: At the start of the gap the body still had the old spin. Both ends of the gap should count alike.
namespace new_spin {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap_of(times, i), spins[i]); });
}

}  // namespace new_spin

// Says: Each gap is turned with the old spin alone: this is explicit Euler for the orientation, of order one.
// Hint: At the end of the gap the body already has the new spin, and the recording knows it.
namespace old_spin {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap_of(times, i), spins[i - 1]); });
}

}  // namespace old_spin

// Says: The turn stands on the left of the orientation: spins in the body's axes are taken for the world's.
// Hint: In a product of quaternions the right one acts first, on vectors in the body's axes.
namespace other_side {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i)
        now = turned(Quaterniond::Identity(), gap_of(times, i) / 2 * sum_of(spins, i)) * now;
    return now;
}

}  // namespace other_side

// Says: Nobody scales the quaternion: it gets longer with every gap.
// Hint: A 1 with something behind it is longer than 1. What does normalized() do?
namespace not_scaled {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d half = gap_of(times, i) / 4 * sum_of(spins, i);
        now = now * Quaterniond(1, half.x(), half.y(), half.z());
    }
    return now;
}

}  // namespace not_scaled

// Says: The body turns twice as far as it should: the sum of the two spins is taken, or the whole angle
//       where a quaternion wants half of it.
// Hint: Take two equal spins. What must their mean be? And by what angle does a quaternion turn whose vector
//       part is the sine of 10 degrees?
namespace twice {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap_of(times, i), sum_of(spins, i)); });
}

}  // namespace twice

// Says: The body turns half as far as it should: a half stands there once too often.
// Hint: One half is of the mean, the other one is of the quaternion, which holds half the angle. AngleAxisd
//       takes the whole angle and halves it itself.
namespace half {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap_of(times, i) / 4, sum_of(spins, i)); });
}

}  // namespace half

// Says: All gaps are taken as equally long.
// Hint: The frames come at uneven times. Each gap has its own length: the difference of two times.
namespace even_frames {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    const double gaps = double(times.size()) - 1;
    const double gap = gaps == 0 ? 0 : (times.back() - times[0]) / gaps;
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap / 2, sum_of(spins, i)); });
}

}  // namespace even_frames

// Says: Every gap is taken as long as the first one.
// Hint: The second gap is times[2] - times[1]. What is the one that ends at frame i?
namespace first_gap {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    const double gap = times.size() < 2 ? 0 : times[1] - times[0];
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap / 2, sum_of(spins, i)); });
}

}  // namespace first_gap

// Says: The time on the clock is used, where the time since the frame before is asked.
// Hint: Nobody says that the clock begins at zero with the replay. A gap is a difference of two times.
namespace clock_for_gap {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) { return scaled(times[i] / 2, sum_of(spins, i)); });
}

}  // namespace clock_for_gap

// Says: The last gap is missing: the answer is the orientation at the last frame but one.
// Hint: Of n frames there are n - 1 gaps. At which frame does the last one end?
namespace last_gap_lost {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size() - 1, [&](std::size_t i) { return scaled(gap_of(times, i) / 2, sum_of(spins, i)); });
}

}  // namespace last_gap_lost

// Says: The body turns the other way round.
// Hint: The signs of the quaternion's vector part are those of the spin. Or have you taken the older time
//       first?
namespace backwards {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) { return scaled(-gap_of(times, i) / 2, sum_of(spins, i)); });
}

}  // namespace backwards

// Says: This is the turn since the first frame, and not the orientation: q is not in it.
// Hint: What would you return where no time goes by?
namespace only_the_turn {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    const Quaterniond start = Quaterniond::Identity();
    return through(start, times.size(), [&](std::size_t i) { return scaled(gap_of(times, i) / 2, sum_of(spins, i)); });
}

}  // namespace only_the_turn

// Says: The mean of all spins turns the body once, for the whole time. But turns about different axes cannot
//       be added up.
// Hint: Turns do not commute: go from frame to frame, and multiply.
namespace mean_of_all {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& spin : spins) sum += spin;
    return turned(q, (times.back() - times[0]) / double(spins.size()) * sum);
}

}  // namespace mean_of_all

// Says: Where the mean of two spins is zero, this divides zero by zero.
// Hint: Without a spin there is no axis. Ask first, take normalized(), which leaves a zero vector alone, or
//       write a turn that needs no axis.
namespace zero_divides {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d sum = sum_of(spins, i);
        now = turned(now, sum.norm() / 2 * gap_of(times, i), sum / sum.norm());
    }
    return now;
}

}  // namespace zero_divides

// Says: A pause is passed over once, but it may last for more frames than two: then the gap is still zero,
//       and this divides by it.
// Hint: An if looks once, a while as often as it must. Or do without: in a gap of zero nothing turns, and
//       the mean of two spins is divided by no gap.
namespace short_pause {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Quaterniond now = q;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] == times[i - 1]) ++i;
        if (i == times.size()) break;
        const double gap = gap_of(times, i);
        const Vector3d change = spins[i] - spins[i - 1], slope = change / gap;
        const Vector3d mean = spins[i - 1] + gap / 2 * slope;
        now = turned(now, gap * mean);
    }
    return now;
}

}  // namespace short_pause

// Says: The formula is right, but it is computed with about seven digits, as float has them.
// Hint: Is there a float in your answer, or a number of few digits?
namespace single_precision {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Eigen::Quaternionf now = q.cast<float>();
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d half = gap_of(times, i) / 4 * sum_of(spins, i);
        const Eigen::Vector3f v = half.cast<float>();
        now = (now * Eigen::Quaternionf(1, v.x(), v.y(), v.z())).normalized();
    }
    return now.cast<double>();
}

}  // namespace single_precision

// Says: The turns of all gaps are added up as vectors, and the body is turned once by their sum. But turns about
//       different axes cannot be added.
// Hint: A quarter turn about x and then one about y is no turn about the diagonal. Turn the body in every gap.
namespace sum_of_turns {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 1; i < times.size(); ++i) sum += gap_of(times, i) / 2 * sum_of(spins, i);
    return turned(q, sum);
}

}  // namespace sum_of_turns

// Says: Each gap is turned by the difference of its two spins, not by their mean.
// Hint: A body that spins evenly has the same spin at both ends of a gap. By what does yours turn then?
namespace difference_of_spins {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap_of(times, i) / 2, spins[i] - spins[i - 1]); });
}

}  // namespace difference_of_spins

// Says: The angle is turned into degrees before its sine and its cosine are taken, which want radians.
// Hint: Spins are in rad/s, and times in s. In what is their product?
namespace degrees {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    for (std::size_t i = 1; i < times.size(); ++i) {
        const Vector3d turn = scaled(gap_of(times, i) / 2, sum_of(spins, i));
        const double degrees = turn.norm() * 180 / std::numbers::pi;
        if (degrees > 0) q = turned(q, degrees, turn / degrees);
    }
    return q.normalized();
}

}  // namespace degrees

// Says: The first gap is counted from time zero, but the replay begins with its first frame.
// Hint: The orientation that is given is the one at the first frame. From there on the body turns.
namespace clock_from_zero {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    if (!times.empty()) times.insert(times.begin(), 0), spins.insert(spins.begin(), spins.front());
    return through(q, times.size(), [&](std::size_t i) { return scaled(gap_of(times, i) / 2, sum_of(spins, i)); });
}

}  // namespace clock_from_zero

// Says: The speed is the mean of both, but the axis is that of the old spin.
// Hint: Take the mean of the two vectors, and then its length and its direction.
namespace mean_speed_about_old_axis {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    return through(q, times.size(), [&](std::size_t i) {
        return scaled(gap_of(times, i) / 2 * (spins[i - 1].norm() + spins[i].norm()), spins[i - 1].normalized());
    });
}

}  // namespace mean_speed_about_old_axis

// Says: The replay is turned from time zero on, and by Cayley's formula, for which that may be a long gap.
// Hint: At the first frame the body is turned by q already. Which gap is the first one, and between which two frames?
namespace clock_from_zero_by_cayley {

Quaterniond last_orientation(Quaterniond q, std::vector<double> times, std::vector<Vector3d> spins) {
    times.insert(times.begin(), 0), spins.insert(spins.begin(), spins.front());
    return through(q, times.size(), [&](std::size_t i) {
        const Vector3d half = gap_of(times, i) / 4 * sum_of(spins, i);
        return scaled(2 * std::atan(half.norm()), half.normalized());
    });
}

}  // namespace clock_from_zero_by_cayley
