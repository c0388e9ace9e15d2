#pragma once
/// \file
/// Which slips there are in an exercise's answers, and what comes of them.

#include <string>
#include <vector>

#include "answer.hpp"
#include "roundoff.hpp"
#include "slip.hpp"

namespace checker {

namespace slip {

/// One slip: the place, which of those that can be made there, and its form.
struct Made {
    int site = 0, number = 0;
    Form form = Form::none;
};

/// More places than any answer passes that ends.
inline constexpr long most_places = 100'000'000;
/// What the answer gives with one slip, or with two. Nothing where that leads nowhere, or past more than `most` places.
Numbers answered(const Answer& answer, const Numbers& arguments, const Made& first, const Made* second = nullptr,
                 long most = most_places);
/// What the answer gives without a slip, where each result that is not exact is off by a few units of roundoff, which
/// are drawn at random (Monte Carlo arithmetic: D. S. Parker, 1997). An angle may have been moved by a part of a turn,
/// which is known to a share `constant` of it.
Numbers rounded(const Answer& answer, const Numbers& arguments, unsigned variation, double constant = few_units);
/// Adds the slips that can be made at the places which a call passes, and are not among `noted`. How many it passes.
long note(const Answer& answer, const Numbers& arguments, std::vector<Made>& noted);
/// How many places all calls have passed.
long work();

/// "sign", as the learner is told of it.
const char* name_of(Form form);

}  // namespace slip

}  // namespace checker
