#pragma once
/// \file
/// The language of the hidden tests. A test is a property that every right answer has, said in
/// words that a learner understands:
///
///     EXERCISE(twice);
///     PROPERTY("twice anything is the sum of it and itself") {
///         Draw draw;
///         for (int i = 0; i < 100; ++i) {
///             const double x = draw.real(-10, 10);
///             REQUIRE(close(learner(x), x + x, 1e-15));
///         }
///     }
///
/// `learner` is the learner's function, typed as the exercise declares it.

#include <initializer_list>

#include <catch2/catch_test_macros.hpp>

#include "answer.hpp"
#include "random_stream.hpp"
#include "session.hpp"

/// Says which exercise the properties below it belong to; its declaration stands in the header of
/// the same name, which is included before. The task asks for no more than nine digits; but those must be right also
/// where the arguments nearly cancel.
#define EXERCISE(name) EXERCISE_TOLD(name, (checker::Within{checker::nine_digits, {}, checker::all_digits}))

/// The same, where the learner's answers must be the course's to what a change of the arguments by `relative` makes
/// of them; `checker::many_are_right` where they need not be.
#define EXERCISE_WITHIN(name, relative) EXERCISE_TOLD(name, (checker::Within{relative}))

/// The same, where another way to write the answer, `way`, loses digits to cancellation, and is right all the same: as
/// many as it loses in a call may be lost there.
#define EXERCISE_BESIDE(name, relative, way) \
    EXERCISE_TOLD(name, (checker::Within{relative, checker::function_of(&way)}))

#define EXERCISE_TOLD(name, within)                                            \
    static constexpr const char* exercise_tag = "[" #name "]";                 \
    static const bool is_within = checker::register_tolerance(#name, within);  \
    static const checker::Typed<decltype(::name)> learner(                     \
        [](const checker::Numbers& arguments, const checker::Spoken& spoken) { \
            return checker::session().call(arguments, spoken);                 \
        })

/// A property that every right answer has. They are looked at from top to bottom; the learner is
/// told the first that does not hold.
#define PROPERTY(words) TEST_CASE(words, exercise_tag)

namespace checker {

/// Inputs, drawn anew for each check: the seed of the check and the property decide them.
class Draw {
public:
    Draw();
    /// Uniform in [low, high).
    double real(double low, double high);
    /// Uniform in its logarithm: for steps, masses, stiffnesses.
    double log(double low, double high);
    /// Whatever a range holds, `special` among it: now and then one of those, or what is nearly one, else as often
    /// small as large.
    double any_of(double low, double high, std::initializer_list<double> special = {});
    /// The i-th of `parts` equal parts of the range, in its logarithm, over and over: each seed draws from all of it.
    /// Two arguments with parts that have no common divisor meet in every combination.
    double spread(double low, double high, int i, int parts);
    /// −1 or 1.
    double sign() { return share() < 0.5 ? -1 : 1; }
    /// low, …, high.
    int integer(int low, int high);
    /// 0, …, count - 1, each as often.
    unsigned choice(unsigned count) { return static_cast<unsigned>(share() * count); }
    /// Is a simpler case looked for of what has failed? Then numbers are as round as can be, and whole ones small.
    bool is_roundest() const { return roundest_ && simple_ > 0; }

private:
    double share();  // of one, uniform
    bool draws_round() { return simple_-- > 0; }
    RandomStream stream_;
    bool roundest_, coarse_;
    int simple_;  // so many numbers are round, the first: what fails early can be worked out by hand
};

/// Several checks, all of which are made, also behind one that fails: their calls tell mistakes apart. The call before
/// the first that fails is the one that the learner is shown.
class Every {
public:
    Every& operator&=(bool holds) {
        if (!holds && holds_) session().show_last();
        holds_ = holds_ && holds;
        return *this;
    }
    explicit operator bool() const { return holds_; }

private:
    bool holds_ = true;
};

/// The share `relative` of a number, or what the task allows of an answer, if that is more; zero stays zero.
double allowed_share(double relative);

/// Do two numbers agree to `relative` of the larger, or to `absolute`? An infinite one agrees with
/// none. Above zero, `relative` is at least what the task allows of an answer.
bool close(double a, double b, double relative, double absolute = 0);

/// The order that two errors tell, the second of half the step: log₂(error/half).
double order(double error, double error_of_half);

}  // namespace checker

using checker::close, checker::Draw, checker::Every, checker::order;
