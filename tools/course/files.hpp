#pragma once
/// \file
/// Reading and writing whole files, locks, and folders for what is not whole yet.

#include <filesystem>
#include <optional>
#include <string>

namespace course {

/// The contents of a file of at most 1 MB. Throws Stop(bad_use) if it cannot be read.
std::string contents(const std::filesystem::path& file);

/// Writes a file beside `file` and moves it into place. Throws Stop(bad_use) if that fails, as on a full disk; the old
/// file then stays as it was.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// A file's path for people, safe to print: relative to the current folder, or absolute if that is shorter.
std::string shown(const std::filesystem::path& file);

/// Has this file, or anything in this folder, changed since `since` (in seconds), or is it gone? Compares the inode's
/// change time, which nobody can set back.
bool touched_since(const std::filesystem::path& place, double since);

/// When this file was last written, in seconds; nothing if it does not exist.
std::optional<double> written_at(const std::filesystem::path& file);

/// A folder with a new name in `parent`, for what is not whole yet. The destructor removes it, unless it was moved.
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

/// Holds a lock on this file, which is created if it does not exist. After one second of waiting for another's lock it
/// prints `waiting`. Throws Stop(bad_use) if the file cannot be opened.
class Lock {
public:
    explicit Lock(const std::filesystem::path& file, const std::string& waiting = {});
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

    /// Does anybody hold a lock on this file now?
    static bool is_held(const std::filesystem::path& file);

private:
    int file_;
};

}  // namespace course
