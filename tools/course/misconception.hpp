#pragma once
/// \file
/// What a learner is told of a mistake that the checker has found (tools/checker/diagnose.cpp).

#include <string>

#include "../checker/finding.hpp"
#include "exercises.hpp"

namespace course {

/// One paragraph or two for the screen; nothing where nothing is known.
std::string told_of(const Exercise& exercise, const checker::Diagnosis& diagnosis);

}  // namespace course
