#pragma once
/// \file
/// Where things are, and how long we wait for them. The tests put their own in the place of these.

#include <filesystem>
#include <string>

namespace course {

struct Places {
    std::filesystem::path source;  ///< the checkout
    std::filesystem::path build;   ///< the build folder that this program belongs to
    std::string cmake, ctest;      ///< the programs that made the build folder
    int compiler_seconds = 20;     ///< so long a compiler may take for a learner's file
};

const Places& places();

}  // namespace course
