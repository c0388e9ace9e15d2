#include "temporary_folder.hpp"

#include <cstdlib>

#include "paths.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

const char* const lock = "lock";

// Removes what a killed check has left behind.
void sweep(const fs::path& temporaries) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(temporaries, ignored)) {
        const fs::path folder = entry.path();
        if (folder.filename().string().starts_with("check_") && entry.is_directory(ignored) &&
            !Lock::is_held(folder / lock))
            fs::remove_all(folder, ignored);
    }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    const fs::path temporaries = paths().build / "exercises";
    const Lock no_sweep(temporaries / "temporaries.lock");  // before ours has its lock
    sweep(temporaries);
    std::string name = (temporaries / "check_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Stop(Status::bad_use, temporaries.string() + ": cannot be written");
    folder_ = name;
    in_use_.emplace(folder_ / lock);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

}  // namespace course
