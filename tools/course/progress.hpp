#pragma once
/// \file
/// How far the learner has come: a small text file in the checkout, kept by the names of the
/// exercises, so that it outlives new builds and new versions of the course.

#include <functional>
#include <map>
#include <string>

#include "exercises.hpp"

namespace course {

/// What is remembered of one exercise.
struct Remembered {
    bool passed = false;
    int hints = 0;  ///< how many have been shown
};

/// What is remembered of all. Throws Stop(bad_use) where the file cannot be read or holds what this
/// course has not written.
std::map<std::string, Remembered> read_progress();

/// Changes what is remembered, one command at a time. Where `change` throws, or the file cannot be
/// written, it stays as it was.
void change_progress(const std::function<void(std::map<std::string, Remembered>&)>& change);

/// `passed`, `started` or `not started`.
std::string state_of(const Exercise& exercise, const std::map<std::string, Remembered>& progress);

}  // namespace course
