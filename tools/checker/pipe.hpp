#pragma once
/// \file
/// What goes through the pipes between the tests and the worker that holds the learner's code: a
/// head, and so many bytes.

#include <cstddef>
#include <cstdint>
#include <string>

#include "numbers.hpp"

namespace checker {

/// Where the worker reads calls and writes answers.
inline constexpr int calls_fd = 3, answers_fd = 4;

enum class Reply : std::uint32_t { answer, not_started, threw, out_of_memory, crashed };

struct Head {
    std::uint64_t number;  ///< of the call; its answer bears the same
    Reply reply;
    std::uint32_t bytes;
};

/// Reads exactly `size` bytes. False at the end of the pipe.
bool read_all(int fd, void* to, std::size_t size);
/// Writes exactly `size` bytes. False where nobody reads.
bool write_all(int fd, const void* from, std::size_t size);

}  // namespace checker
