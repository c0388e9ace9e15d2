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

#include <catch2/catch_test_macros.hpp>

#include "answer.hpp"
#include "keyed.hpp"
#include "session.hpp"

/// Says which exercise the properties below it belong to; its declaration stands in the header of
/// the same name, which is included before.
#define EXERCISE(name)                                                         \
    static constexpr const char* exercise_tag = "[" #name "]";                 \
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
    /// −1 or 1.
    double sign() { return real(0, 1) < 0.5 ? -1 : 1; }
    /// low, …, high.
    int integer(int low, int high);

private:
    Keyed stream_;
};

/// Do two numbers agree to `relative` of the larger, or to `absolute`? An infinite one agrees with
/// none.
bool close(double a, double b, double relative, double absolute = 0);

/// The order that two errors tell, the second of half the step: log₂(error/half).
double order(double error, double error_of_half);

}  // namespace checker

using checker::close, checker::Draw, checker::order;
