#include "workshop.hpp"

#include <cstdlib>

#include "places.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

const char* const lock = "lock";

// What a check has left behind that was killed.
void sweep(const fs::path& workshops) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(workshops, ignored)) {
        const fs::path folder = entry.path();
        if (folder.filename().string().starts_with("check_") && entry.is_directory(ignored) &&
            !Lock::is_held(folder / lock))
            fs::remove_all(folder, ignored);
    }
}

}  // namespace

Workshop::Workshop() {
    const fs::path workshops = places().build / "exercises";
    const Lock no_sweep(workshops / "workshops.lock");  // before ours has its lock
    sweep(workshops);
    std::string name = (workshops / "check_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw Stop(Status::bad_use, workshops.string() + ": cannot be written");
    folder_ = name;
    in_use_.emplace(folder_ / lock);
}

Workshop::~Workshop() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

}  // namespace course
