#include "pipe.hpp"

#include <cerrno>

#include <unistd.h>

namespace checker {

bool read_all(int fd, void* to, std::size_t size) {
    for (char* at = static_cast<char*>(to); size > 0;) {
        const ssize_t got = read(fd, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

bool write_all(int fd, const void* from, std::size_t size) {
    for (const char* at = static_cast<const char*>(from); size > 0;) {
        const ssize_t put = write(fd, at, size);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        at += put;
        size -= static_cast<std::size_t>(put);
    }
    return true;
}

}  // namespace checker
