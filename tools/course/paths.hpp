#pragma once
/// \file
/// Where things are, and how long we wait for them. The tests put their own in the place of these.

#include <filesystem>
#include <string>

namespace course {

struct Paths {
    std::filesystem::path source;  ///< the checkout
    std::filesystem::path build;   ///< the build folder that this program belongs to
    std::string cmake, ctest;      ///< the programs that made the build folder
    /// So long a compiler may work for a learner's file, in a processor's time; by the clock it has
    /// ten times that, for it may have neighbours.
    int compiler_seconds = 9;
};

const Paths& paths();

}  // namespace course
