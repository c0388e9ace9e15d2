#pragma once
/// \file
/// The learner's progress: a small text file in the checkout, by exercise name, so that it outlives new builds and new
/// versions of the course.

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

/// Progress in all exercises. Throws Stop(bad_use) if the file cannot be read or has another format.
std::map<std::string, Remembered> read_progress();

/// Changes the progress, under a lock. If `change` throws or the file cannot be written, it stays as it was.
void change_progress(const std::function<void(std::map<std::string, Remembered>&)>& change);

/// `passed`, `started` or `not started`.
std::string state_of(const Exercise& exercise, const std::map<std::string, Remembered>& progress);

}  // namespace course
