// The places of a learner's edition, whose course program comes built: where the edition is, it is.

#include "places.hpp"

namespace course {

const Places& places() {
    static const Places known = [] {
        const auto root = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
        return Places{root, root / "build", "cmake", "ctest"};
    }();
    return known;
}

}  // namespace course
