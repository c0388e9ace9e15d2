#pragma once
/// \file
/// Reading and writing whole files, where others may be at work, too.

#include <filesystem>
#include <optional>
#include <string>

namespace course {

/// A whole file of at most 1 MB. Throws Stop(bad_use) where it cannot be read.
std::string contents(const std::filesystem::path& file);

/// Writes a file beside and moves it into place, so that a full disk costs nothing. Throws
/// Stop(bad_use) where that cannot be done, and leaves the file as it was.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// A file's path for people, in one line that no terminal obeys: from where they are, unless the
/// path from the root is shorter.
std::string shown(const std::filesystem::path& file);

/// Has this file, or anything in this folder, been touched since `since` (in seconds), or is it
/// gone? What counts is when the system noticed, which nobody can set back.
bool touched_since(const std::filesystem::path& place, double since);

/// When this file was last written, in seconds; nothing where it is not there.
std::optional<double> written_at(const std::filesystem::path& file);

/// A folder of a new name in `parent`, for what is not whole yet. It goes, with all that is in it, unless it is moved.
class UnfinishedFolder {
public:
    /// Throws std::filesystem::filesystem_error.
    explicit UnfinishedFolder(const std::filesystem::path& parent);
    ~UnfinishedFolder();
    UnfinishedFolder(const UnfinishedFolder&) = delete;
    UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// While it lives, nobody else has a lock on this file, which is made where there is none. Who waits for it for a
/// second is told `waiting`. Throws Stop(bad_use) where it cannot be opened.
class Lock {
public:
    explicit Lock(const std::filesystem::path& file, const std::string& waiting = {});
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

    /// Has somebody a lock on this file at the moment?
    static bool is_held(const std::filesystem::path& file);

private:
    int file_;
};

}  // namespace course
