#pragma once
/// \file
/// Names for new chapters and exercises: of each the build makes files, functions and targets, and none may be there
/// twice. All throw Stop(bad_use), one line with the name and the rule.

#include <string>

namespace course {

/// A name that a file, a target of CMake and a function of C++ can have.
void check_name(const std::string& name);

/// Has the build none of the targets that a chapter of this name makes?
void check_chapter_is_new(const std::string& name);

/// Has neither the build a target, nor the checker a header, nor C a function that an exercise of this name makes?
void check_exercise_is_new(const std::string& name);

}  // namespace course
