#include "exercise.hpp"
#include <functional>

// The course's answer, but for when `fits(a, b)` at a mark: a is the replay's height there, and b the right one.
static bool all_marks(const std::vector<double>& x, const std::vector<double>& exact,
                         const std::function<bool(double, double)>& fits) {
    if (x.size() != exact.size()) return false;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        if (!fits(x[mark], exact[mark])) return false;
    return true;
}

// Says: Only the last mark decides. A flight may go astray and still come down where it should. Is there no loop, or
//       does each round of it forget what the one before has found?
// Hint: Let the mark in the middle be bad, and the last one good. Which answer must come out, and which does?
namespace final_only {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    return std::fabs(x.back() - exact.back()) <= accuracy * size;
}

}  // namespace final_only

// Says: NaN gets through: it is neither above the limit nor below it, and std::max(worst, NaN) is worst. Every
//       comparison with it is false.
// Hint: Ask the question that NaN must answer with no: is the error at most what is allowed?
namespace nan_passes {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double worst = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        worst = std::max(worst, std::fabs(x[mark] - exact[mark]));
    return worst <= accuracy * size;
}

}  // namespace nan_passes

// Says: Two things get through: NaN, since every comparison with it is false, also "larger than"; and a replay that
//       broke off, since the loop ends where it does.
// Hint: Which question must NaN answer with no? And before the loop: are there as many heights as marks?
namespace nan_and_broken_off_pass {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        if (std::fabs(x[mark] - exact[mark]) / size > accuracy) return false;
    return true;
}

}  // namespace nan_and_broken_off_pass

// Says: Your maximum forgets: std::max(NaN, worst) is NaN, and std::max(error, NaN) is the next error. After NaN it
//       begins anew, as if nothing had been.
// Hint: A maximum of numbers that may be NaN is a trap. Decide at each mark, or ask std::isfinite first.
namespace nan_forgets {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double worst = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        worst = std::max(std::fabs(x[mark] - exact[mark]), worst);
    return worst <= accuracy * size;
}

}  // namespace nan_forgets

// Says: Marks that are NaN or infinite are passed over. They are not missing: there the replay has blown up.
// Hint: What does the task say of such heights?
namespace not_finite_skipped {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) {
        return !std::isfinite(a) || std::fabs(a - b) <= accuracy * size;
    });
}

}  // namespace not_finite_skipped

// Says: NaN is caught, but infinite heights are passed over: infinity is a number to std::isnan.
// Hint: An infinite error is more than any limit, if you compare it. Why is it not compared?
namespace only_nan_seen {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) {
        return std::isinf(a) || std::fabs(a - b) <= accuracy * size;
    });
}

}  // namespace only_nan_seen

// Says: The error in metres is not compared with accuracy times size.
// Hint: What is an error of 0.5 m in a scene of 20 m?
namespace no_size {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) <= accuracy; });
}

}  // namespace no_size

// Says: Each error is taken as a share of the true height at that mark. Near height zero nothing would be good enough,
//       and high up almost everything.
// Hint: The ground may be anywhere. Shares are of the size of the scene, the same at every mark.
namespace relative_to_height {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) <= accuracy * std::fabs(b); });
}

}  // namespace relative_to_height

// Says: You take the greatest true height for the size. It depends on where height zero is.
// Hint: The size is given.
namespace own_size {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    double highest = 0;
    for (const double height : exact) highest = std::max(highest, std::fabs(height));
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) <= accuracy * highest; });
}

}  // namespace own_size

// Says: The error has kept its sign: a replay that is too low passes, however low.
// Hint: An error has a size. std::fabs.
namespace signed_error {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return a - b <= accuracy * size; });
}

}  // namespace signed_error

// Says: The mean of the errors is compared. Many good marks hide a bad one.
// Hint: Within at every mark means that the worst of them counts.
namespace mean {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double sum = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark) sum += std::fabs(x[mark] - exact[mark]);
    return sum / double(x.size()) <= accuracy * size * (1 + 1e-12);
}

}  // namespace mean

// Says: This is the root of the mean square, which weighs large errors more but still spreads a bad mark over all the
//       good ones.
// Hint: Ask each mark for itself.
namespace root_mean_square {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double squares = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        squares += (x[mark] - exact[mark]) * (x[mark] - exact[mark]);
    return std::sqrt(squares / double(x.size())) <= accuracy * size * (1 + 1e-12);
}

}  // namespace root_mean_square

// Says: An error as large as the accuracy is turned down; with accuracy zero even a perfect replay would be.
// Hint: Is it "less" or "at most"?
namespace strictly_less {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) < accuracy * size; });
}

}  // namespace strictly_less

// Says: You say yes at the first mark that is within. All of them must be.
// Hint: Which answer may a single mark decide on its own: yes or no?
namespace one_is_enough {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        if (std::fabs(x[mark] - exact[mark]) <= accuracy * size) return true;
    return false;
}

}  // namespace one_is_enough

// Says: The last mark is left out.
// Hint: Where does your loop end?
namespace last_left_out {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (!x.empty()) x.back() = exact.back();
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) <= accuracy * size; });
}

}  // namespace last_left_out

// Says: The first mark is left out.
// Hint: Lists begin at zero. The first mark need not be the start of the flight.
namespace first_left_out {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (!x.empty()) x[0] = exact[0];
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) <= accuracy * size; });
}

}  // namespace first_left_out

// Says: A replay that broke off is only compared as far as it goes: one that stops at once is found perfect.
// Hint: Are there as many heights as marks?
namespace broken_off_passes {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        if (!(std::fabs(x[mark] - exact[mark]) <= accuracy * size)) return false;
    return true;
}

}  // namespace broken_off_passes

// Says: The accuracy is taken for a percentage. It is a share: 0.01 is one percent.
// Hint: No factor of a hundred is needed.
namespace percent {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return 100 * std::fabs(a - b) / size <= accuracy; });
}

}  // namespace percent

// Says: The heights go through float, and small errors of large heights are lost in it.
// Hint: Take the difference in double.
namespace single_precision {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) {
        return std::fabs(float(a) - float(b)) <= float(accuracy * size);
    });
}

}  // namespace single_precision

// Says: Yes and no have changed places: you return whether the replay is broken.
// Hint: A perfect replay fits. What do you return for it?
namespace turned_round {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return !all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) <= accuracy * size; });
}

}  // namespace turned_round

// Says: Whatever is off by less than a whole size passes, however little the accuracy allows.
// Hint: Is there an int, or an abs without std:: before the error? Or is the accuracy no factor beside the size?
namespace whole_number_error {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return std::trunc(std::fabs(a - b) / size) <= accuracy; });
}

}  // namespace whole_number_error

// Says: A little is added to the accuracy, against roundoff. A replay that is off by a little more than is allowed
//       passes.
// Hint: The task says what an error just as large is. It needs no epsilon.
namespace forgiving {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) / size <= accuracy + 1e-9; });
}

}  // namespace forgiving

// Says: Every replay is turned down, even a perfect one.
// Hint: Take the heights of the example with an accuracy of 0.1, where the answer is yes. Where does yours become
//       no: at a mark, or behind the last?
namespace example {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return false;
}

}  // namespace example

// Says: The error is cut to whole metres: less than one counts as nothing, and NaN becomes some whole number that
//       passes.
// Hint: abs without std:: before it may be the one for whole numbers.
namespace whole_metres {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) {
        const double error = std::fabs(a - b);
        return !(error < 0x1p31 && std::trunc(error) > accuracy * size);  // beyond, an int becomes the least int
    });
}

}  // namespace whole_metres

// Says: Replays pass whose errors are far too large, as if nearly every error counted as nothing.
// Hint: Must every mark be near, or is one enough? And is the share cut to a whole number: look for an int, and for abs
//       without std:: before it, which may be the one for whole numbers.
namespace whole_share {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) {
        const double share = std::fabs(a - b) / size;
        return !(share < 0x1p31 && std::trunc(share) > accuracy);
    });
}

}  // namespace whole_share

// Says: Only the first mark is looked at. Does your loop return in its first round, whatever it finds?
// Hint: A bad mark may end the loop at once. When do you know that all of them are good?
namespace first_only {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    return std::fabs(x[0] - exact[0]) <= accuracy * size;
}

}  // namespace first_only

// Says: Each error is divided by the true height at that mark, with its sign: below height zero everything passes.
// Hint: What is a share of the size does not depend on how high the ball is, nor on where the ground is.
namespace divided_by_the_height {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) / b <= accuracy; });
}

}  // namespace divided_by_the_height

// Says: Each error is divided by the true height at that mark, with its sign: below height zero everything passes, and
//       so does NaN, of which every comparison is false.
// Hint: Shares are of the size of the scene, the same at every mark. And ask the question that NaN must answer with no.
namespace divided_by_the_height_and_nan {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return !(std::fabs(a - b) / b > accuracy); });
}

}  // namespace divided_by_the_height_and_nan

// Says: An error that is larger than the accuracy by a hair gets through: there is a tolerance in your comparison.
// Hint: The accuracy is the tolerance. Just as large is within, and larger by the last bit is not.
namespace tolerance_of_a_hair {

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return all_marks(x, exact, [&](double a, double b) { return std::fabs(a - b) <= accuracy * size * (1 + 1e-10); });
}

}  // namespace tolerance_of_a_hair
