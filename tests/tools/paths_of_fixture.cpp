// The course program with the places of a test: a fixture with a small course and a fake for
// CMake.

#include <cstdlib>

#include "paths.hpp"

namespace course {

const Paths& paths() {
    static const auto from_environment = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value ? value : "");
    };
    static const auto patience = from_environment("FIXTURE_COMPILER_SECONDS");
    static const Paths fixture{from_environment("FIXTURE_SOURCE"), from_environment("FIXTURE_BUILD"),
                               from_environment("FIXTURE_CMAKE"), from_environment("FIXTURE_CTEST"),
                               patience.empty() ? Paths{}.compiler_seconds : std::stoi(patience)};
    return fixture;
}

}  // namespace course
