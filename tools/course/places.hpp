#pragma once
/// \file
/// Where things are. The tests put places of their own in the place of these.

#include <filesystem>
#include <string>

namespace course {

struct Places {
    std::filesystem::path source;  ///< the checkout
    std::filesystem::path build;   ///< the build folder that this program belongs to
    std::string cmake, ctest;      ///< the programs that made the build folder
};

const Places& places();

}  // namespace course
