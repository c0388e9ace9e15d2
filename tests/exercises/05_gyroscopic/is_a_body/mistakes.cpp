#include "exercise_eigen.hpp"

// Says: This comes to asking only whether the moments are above zero: one of them may still be much too large. Or
//       is there an || between your comparisons, so that one that holds is enough?
// Hint: Let a body grow along x. Two of its moments grow with it. Can you think of a body of which only one
//       grows, for ever?
namespace only_positive {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0;
}

}  // namespace only_positive

// Says: Right, except that a moment of zero gets through.
// Hint: A line of masses has no moment about itself, and a solver divides by each of them. The task calls
//       that wrong.
namespace zero_allowed {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() >= 0 && 2 * inertia.maxCoeff() <= inertia.sum();
}

}  // namespace zero_allowed

// Says: Right, except for flat plates, whose largest moment is just the sum of the other two.
// Hint: Put z = 0 for all pieces, and add the first two moments. Which comparison lets them be equal?
namespace plate_rejected {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0 && 2 * inertia.maxCoeff() < inertia.sum();
}

}  // namespace plate_rejected

// Says: Only the last moment is compared with the sum of the other two, as if it were always the largest.
// Hint: The artist may have named the axes in any order. Which of the three can be too large?
namespace last_only {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0 && inertia.z() <= inertia.x() + inertia.y();
}

}  // namespace last_only

// Says: The squares of the moments are compared: this is Pythagoras, not the rule for moments.
// Hint: The moments have squares of lengths in them already. They add up as they are.
namespace squares {

bool is_a_body(const Vector3d& inertia) {
    const Vector3d squares = inertia.cwiseAbs2();
    return inertia.minCoeff() > 0 && 2 * squares.maxCoeff() <= squares.sum();
}

}  // namespace squares

// Says: The square roots of the moments are compared, as if the rule were about lengths. A moment may then
//       be up to four times the other two.
// Hint: Add the sums in the task before you take any root. What is inertia.x() + inertia.y() - inertia.z()?
namespace roots {

bool is_a_body(const Vector3d& inertia) {
    if (inertia.minCoeff() <= 0) return false;
    const Vector3d radii = inertia.cwiseSqrt();
    return 2 * radii.maxCoeff() <= radii.sum();
}

}  // namespace roots

// Says: The tolerance is a fixed number of kg m²: a body much smaller than that is none, whatever its shape.
// Hint: What is small depends on the body. Compare with the moments themselves, or use no tolerance at all.
namespace fixed_tolerance {

bool is_a_body(const Vector3d& inertia) {
    const double tolerance = 1e-6;
    return inertia.minCoeff() > tolerance && 2 * inertia.maxCoeff() <= inertia.sum() + tolerance;
}

}  // namespace fixed_tolerance

// Says: The largest moment may exceed the other two by a fixed number of kg m²: a small body may then have
//       any shape.
// Hint: Multiply all three moments by a million, and the slack must grow by as much. Take it as a share of
//       one of them, or none.
namespace fixed_slack {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z(), slack = 1e-9;
    const bool positive = a > 0 && b > 0 && c > 0;
    return positive && a <= b + c + slack && b <= c + a + slack && c <= a + b + slack;
}

}  // namespace fixed_slack

// Says: A moment that is too large by a small part, below a millionth, gets through. Is this float, which has half
//       of the digits, or a tolerance that is too wide?
// Hint: Look for float, or a number with an f at its end, and for a tolerance: a billionth of the largest moment is
//       the most.
namespace single_precision {

bool is_a_body(const Vector3d& inertia) {
    const Eigen::Vector3f moments = inertia.cast<float>();
    return moments.minCoeff() > 0 && 2 * moments.maxCoeff() <= moments.sum();
}

}  // namespace single_precision

// Says: The comparison is the wrong way round: only plates and what is no body at all get through.
// Hint: Try a ball, with three equal moments. Is one of them greater than the sum of the other two?
namespace upside_down {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0 && 2 * inertia.maxCoeff() >= inertia.sum();
}

}  // namespace upside_down

// Says: The signs are dropped: a body with a negative moment gets through.
// Hint: A mirrored model may bring a minus sign into the file. It is an error to report, not one to hide.
namespace signs_dropped {

bool is_a_body(const Vector3d& inertia) {
    const Vector3d sizes = inertia.cwiseAbs();
    return sizes.minCoeff() > 0 && 2 * sizes.maxCoeff() <= sizes.sum();
}

}  // namespace signs_dropped

// Says: The largest moment is compared with twice the least: long bodies, a staff say, are turned away.
// Hint: A staff has two large moments and a small one. The largest has to be compared with both of the
//       others together.
namespace twice_the_least {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0 && inertia.maxCoeff() <= 2 * inertia.minCoeff();
}

}  // namespace twice_the_least

// Says: Only the first moment is compared with the sum of the other two, as if it were always the largest.
// Hint: The axes may be named in any order. What if the second one is too large?
namespace first_only {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    return a > 0 && b > 0 && c > 0 && a <= b + c;
}

}  // namespace first_only

// Says: Only the second moment is compared with the sum of the other two, as if it were always the largest.
// Hint: The axes may be named in any order. What if the first one is too large?
namespace middle_only {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    return a > 0 && b > 0 && c > 0 && b <= c + a;
}

}  // namespace middle_only

// Says: The first two moments are compared with the sums, or their difference with the third; but that the
//       third is too large goes unseen.
// Hint: There are three differences of two moments, and three sums. Is the last moment ever compared with one
//       of the sums?
namespace all_but_the_last {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    return a > 0 && b > 0 && c > 0 && a <= b + c && b <= c + a;
}

}  // namespace all_but_the_last

// Says: Only three equal moments get through: plates and staffs are turned away. Is a moment compared with the mean
//       of the other two and not with their sum, or with a third of all three?
// Hint: Add the two sums in the task: y² + z² and z² + x². What do they have beside the third?
namespace mean_of_the_others {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    return a > 0 && b > 0 && c > 0 && 2 * a <= b + c && 2 * b <= c + a && 2 * c <= a + b;
}

}  // namespace mean_of_the_others

// Says: A moment is compared with the product of the other two: in other units the answer is another.
// Hint: A product of two moments is in kg² m⁴. What can one compare with a moment?
namespace product_of_the_others {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    return a > 0 && b > 0 && c > 0 && a <= b * c && b <= c * a && c <= a * b;
}

}  // namespace product_of_the_others

// Says: A moment that is a little too large, by some per cent or by a part of one, gets through.
// Hint: No mass can make it so. If you want a tolerance for rounding, a billionth of the largest moment is plenty.
namespace some_slack {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 0 && inertia.maxCoeff() <= 1.05 * (inertia.sum() - inertia.maxCoeff());
}

}  // namespace some_slack

// Says: The last two moments are compared with the sums; but that the first is too large goes unseen.
// Hint: Let the first moment grow for ever. Which of your comparisons would notice?
namespace all_but_the_first {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    return a > 0 && b > 0 && c > 0 && b <= c + a && c <= a + b;
}

}  // namespace all_but_the_first

// Says: The first and the last moment are compared with the sums; but that the second is too large goes
//       unseen.
// Hint: Let the second moment grow for ever. Which of your comparisons would notice?
namespace all_but_the_middle {

bool is_a_body(const Vector3d& inertia) {
    const double a = inertia.x(), b = inertia.y(), c = inertia.z();
    return a > 0 && b > 0 && c > 0 && a <= b + c && c <= a + b;
}

}  // namespace all_but_the_middle

// Says: Nothing gets through, not even a ball: one of your comparisons fails for every body, or they cannot all hold
//       at once.
// Hint: Try the moments of a ball, (1, 1, 1), in each of them. Which one fails, and should it?
namespace nothing_is {

bool is_a_body(const Vector3d& inertia) {
    return false;
}

}  // namespace nothing_is

// Says: One moment above zero is enough here, whatever the other two are: your comparisons are joined by || where &&
//       belongs.
// Hint: Which of the conditions must hold: one of them, or all? (&& goes before ||, as times goes before plus.)
namespace any_positive {

bool is_a_body(const Vector3d& inertia) {
    return inertia.maxCoeff() > 0;
}

}  // namespace any_positive

// Says: Everything gets through, also what has a negative moment or a far too large one.
// Hint: Which files does the task call wrong? There are two kinds of them.
namespace everything_is {

bool is_a_body(const Vector3d& inertia) {
    return true;
}

}  // namespace everything_is

// Says: A needle is a body, too: you refuse one whose least moment is far less than its largest.
// Hint: The mass may be spread in any way that gives three moments above zero. How thin may a staff be?
namespace needle_refused {

bool is_a_body(const Vector3d& inertia) {
    return inertia.minCoeff() > 1e-5 * inertia.maxCoeff() && 2 * inertia.maxCoeff() <= inertia.sum();
}

}  // namespace needle_refused

// Says: You ask whether the largest moment equals the sum of the other two. That holds for flat plates alone;
//       of a body it is at most that.
// Hint: A cube is a body, too. What of its moments?
namespace plates_only {

bool is_a_body(const Vector3d& inertia) {
    const double largest = inertia.maxCoeff();
    return inertia.minCoeff() > 0 && std::fabs(inertia.sum() - 2 * largest) <= 1e-9 * largest;
}

}  // namespace plates_only
