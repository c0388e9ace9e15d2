#include "files.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>

#include <unistd.h>
#ifndef _WIN32
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include "process.hpp"
#endif

#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

// Only of a regular file is it sure that reading ends.
std::string contents(const fs::path& file) {
    const std::size_t most = 1 << 20;
    const auto refuse = [&](const std::string& why) {
        throw Stop(Status::bad_use,
                   (file.empty() ? "''" : sanitized_line(file.string())) + ": cannot be read (" + why + ")");
    };
    std::error_code error;
    const auto type = fs::status(file, error).type();
    if (error) refuse(error.message());
    if (type != fs::file_type::regular)
        refuse(type == fs::file_type::directory ? "it is a folder" : "it is no regular file");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) refuse(std::strerror(errno));
    std::string text;
    char piece[8192];
    while (text.size() <= most && (stream.read(piece, sizeof piece) || stream.gcount() > 0))
        text.append(piece, static_cast<std::size_t>(stream.gcount()));
    if (stream.bad()) refuse(std::strerror(errno));
    if (text.size() > most) refuse("it is larger than 1 MB");
    return text;
}

void write_whole(const fs::path& file, const std::string& text) {
    const fs::path fresh =
        file.parent_path() / ("." + file.filename().string() + "." + std::to_string(getpid()) + ".new");
    std::error_code error, ignored;
    std::ofstream out(fresh, std::ios::binary);
    out << text;
    out.close();
    if (out) fs::rename(fresh, file, error);
    if (out && !error) return;
    fs::remove(fresh, ignored);
    throw Stop(Status::bad_use, file.string() + ": cannot be written");
}

UnfinishedFolder::UnfinishedFolder(const fs::path& parent) {
    std::random_device random;
    do path_ = parent / (".unfinished_" + std::to_string(random()));
    while (!fs::create_directory(path_));
}

UnfinishedFolder::~UnfinishedFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string shown(const fs::path& file) {
    std::error_code ignored;
    const std::string whole = file.string();
    const std::string here = fs::relative(file, fs::current_path(ignored), ignored).string();
    return sanitized_line(here.empty() || here.size() > whole.size() ? whole : here);
}

#ifndef _WIN32  // where files are only read and written (tools/checker/check_in_process.cpp)
namespace {

double seconds(const timespec& time) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

bool touched_since(const fs::path& place, double since) {
    struct stat status;
    if (stat(place.c_str(), &status) != 0 || seconds(status.st_ctim) > since) return true;
    if (!S_ISDIR(status.st_mode)) return false;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(place, error))
        if (!entry.is_symlink(error) && touched_since(entry.path(), since)) return true;
    return static_cast<bool>(error);
}

std::optional<double> written_at(const fs::path& file) {
    struct stat status;
    if (stat(file.c_str(), &status) != 0) return {};
    return seconds(status.st_mtim);
}

// On a file system without locks there is none.
Lock::Lock(const fs::path& file, const std::string& waiting)
    : file_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0) throw Stop(Status::bad_use, file.string() + ": cannot be written (" + std::strerror(errno) + ")");
    for (int looks = 0; flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++looks) {
        if (looks == 50 && !waiting.empty()) std::fprintf(stderr, "%s\n", waiting.c_str());
        usleep(20'000);
        if (!interrupted()) continue;
        close(file_);
        stop_if_interrupted();
    }
}

Lock::~Lock() { close(file_); }

bool Lock::is_held(const fs::path& file) {
    const int opened = open(file.c_str(), O_RDWR | O_CLOEXEC);
    if (opened < 0) return false;
    const bool held = flock(opened, LOCK_EX | LOCK_NB) != 0;
    close(opened);
    return held;
}
#endif

}  // namespace course
