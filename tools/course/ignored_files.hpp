#pragma once
/// \file
/// What lies in and among submissions and is no answer.

#include <filesystem>
#include <string>
#include <vector>

#include "exercises.hpp"

namespace course {

/// All exercises of the course.
const std::vector<Exercise>& all_exercises();

/// Is it what versions, file managers and archives leave beside the submissions, and beside each file of a Mac's?
bool is_ignored(const std::string& name);

/// Is it a part of the whole course, which lies in the same folder?
bool is_of_the_course(const std::filesystem::path& entry);

/// Is it a C++ file by its name: .cpp, .cc, .cxx or .c++, in small letters or large?
bool is_source(const std::filesystem::path& file);

/// Is it named after an exercise, of which we know that it is not the one looked for?
bool answers_another(const std::filesystem::path& file);

}  // namespace course
