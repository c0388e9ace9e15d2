#pragma once
/// \file
/// A folder for the files that a check makes.

#include <filesystem>
#include <optional>

#include "files.hpp"
#include "process.hpp"

namespace course {

/// A folder for one check. It goes with the check, after Ctrl-C, too. Throws Stop(bad_use) if it cannot be made.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& folder() const { return folder_; }

private:
    TidyEnd tidy_end_;  // the last to go
    std::filesystem::path folder_;
    std::optional<Lock> in_use_;
};

}  // namespace course
