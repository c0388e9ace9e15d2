#pragma once
/// \file
/// Where things are, and how long the compiler may take. Tests link paths of their own.

#include <filesystem>
#include <string>

namespace course {

struct Paths {
    std::filesystem::path source;  ///< the checkout
    std::filesystem::path build;   ///< the build folder that this program belongs to
    std::string cmake, ctest;      ///< the programs that made the build folder
    /// Processor time that a compiler may use for a learner's file. By the clock it has ten times that, since the
    /// machine may be busy.
    int compiler_seconds = 9;
};

const Paths& paths();

}  // namespace course
