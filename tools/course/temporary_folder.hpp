#pragma once
/// \file
/// A place for what a check makes on its way.

#include <filesystem>
#include <optional>

#include "files.hpp"
#include "process.hpp"

namespace course {

/// A folder for one check, gone with it, by Ctrl-C, too. Throws Stop(bad_use) where there can be
/// none.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& folder() const { return folder_; }

private:
    TidyEnd tidy_end_;  // over when all else is
    std::filesystem::path folder_;
    std::optional<Lock> in_use_;
};

}  // namespace course
