#pragma once
/// \file
/// Where an answer is compiled and run: a folder of its own, and for strangers' code bubblewrap, which sees no network,
/// no home, no tests and no other process, and of files only those named here.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

class Sandbox {
public:
    /// Throws Stop(missing) if bubblewrap is not installed, or may not isolate here.
    Sandbox();

    /// The words to put before a compiler's command. It can write in `folder` only, and read what its own words name
    /// and the files in `reads`.
    std::vector<std::string> before_compiler(const std::vector<std::string>& command,
                                             const std::filesystem::path& folder,
                                             const std::vector<std::filesystem::path>& reads) const;

    /// The words to put before a worker. It can write nowhere.
    std::vector<std::string> before_worker(const std::filesystem::path& worker) const;

    /// Bubblewrap's complaint about these words; "" if they work.
    static std::string fault_of(std::vector<std::string> before);

private:
    static std::vector<std::string> walls();
};

}  // namespace course
