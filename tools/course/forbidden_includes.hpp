#pragma once
/// \file
/// Does an answer include the course's answers or tests?

#include <filesystem>
#include <string>

namespace course {

/// One clear line where an answer has made use of the course's answers or tests: what of them stands, beside the
/// `answer` itself, in the list that the compiler has written for make. Empty: nothing.
std::string forbidden_include(const std::filesystem::path& list, const std::filesystem::path& answer);

}  // namespace course
