#pragma once
/// \file
/// What goes through the pipes between the tests and the worker that holds the learner's code: a
/// head, and so many bytes.

#include <cerrno>
#include <cstddef>
#include <cstdint>

#include <unistd.h>

namespace checker {

/// Where the worker reads calls and writes answers.
inline constexpr int calls_fd = 3, answers_fd = 4;

/// `ready` comes before the first call, where nothing goes wrong.
enum class Reply : std::uint32_t {
    ready,
    answer,
    not_started,
    out_of_memory,
    arguments_changed,  ///< by a call, which is to read them only
    crashed
};

struct Head {
    std::uint64_t number;  ///< of the call, 0 before the first; its answer bears the same
    Reply reply;
    std::uint32_t bytes;
};

/// What follows the head of `crashed`: what happened, and where, from the inside out.
inline constexpr int most_places = 64;
struct LastWords {
    int places;  ///< how many there are
    void* place[most_places];
    char text[4096];  ///< ends with a 0
};

struct DoNotWait {
    void operator()() const {}
};

/// Reads exactly `size` bytes, and calls `wait` before each part of them. False at the end of the pipe.
template <class Wait = DoNotWait>
bool read_all(int fd, void* to, std::size_t size, const Wait& wait = {}) {
    for (char* at = static_cast<char*>(to); size > 0;) {
        wait();
        const ssize_t got = read(fd, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

/// Writes exactly `size` bytes, and calls `wait` before each part of them. False where nobody reads.
template <class Wait = DoNotWait>
bool write_all(int fd, const void* from, std::size_t size, const Wait& wait = {}) {
    for (const char* at = static_cast<const char*>(from); size > 0;) {
        wait();
        const ssize_t put = write(fd, at, size);
        if (put < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (put <= 0) return false;
        at += put;
        size -= static_cast<std::size_t>(put);
    }
    return true;
}

}  // namespace checker
