#pragma once
/// \file
/// What a learner is told of a mistake, by the name that the checker gives it (tools/checker/diagnose.cpp).

#include <string>

#include "exercises.hpp"

namespace course {

/// One paragraph or two for the screen; nothing where the name is none.
std::string told_of(const Exercise& exercise, const std::string& misconception);

}  // namespace course
