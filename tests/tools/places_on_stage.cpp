// The course program with the places of a test: a stage with a small course and a stand-in for
// CMake.

#include <cstdlib>

#include "places.hpp"

namespace course {

const Places& places() {
    static const auto from_environment = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value ? value : "");
    };
    static const auto patience = from_environment("STAGE_COMPILER_SECONDS");
    static const Places stage{from_environment("STAGE_SOURCE"), from_environment("STAGE_BUILD"),
                              from_environment("STAGE_CMAKE"), from_environment("STAGE_CTEST"),
                              patience.empty() ? Places{}.compiler_seconds : std::stoi(patience)};
    return stage;
}

}  // namespace course
