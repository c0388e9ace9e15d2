#pragma once
/// \file
/// What a learner's file is made of, as the compiler tells.

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// The files in the lists that a compiler or an assembler has written for make, and where a list
/// may be read in two ways those of both, of which some are nowhere.
std::vector<std::filesystem::path> files_in(const std::vector<std::filesystem::path>& lists);

/// One clear line where an answer has made use of the course's answers or tests: what of them is
/// among `files` beside the `answer` itself. Empty: nothing.
std::string forbidden_include(const std::vector<std::filesystem::path>& files, const std::filesystem::path& answer);

}  // namespace course
