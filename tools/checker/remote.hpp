#pragma once
/// \file
/// The tests' end of the pipes.

#include <cstdint>
#include <string>
#include <vector>

#include <sys/types.h>

#include "finding.hpp"
#include "numbers.hpp"
#include "pipe.hpp"

namespace checker {

/// How much a worker may take. Seconds are those of a processor: on a busy machine the clock goes on while others work.
/// The clock ends only what does not work.
struct Limits {
    bool sanitizers = false;        ///< is it compiled with them? They need more room than a limit on addresses leaves
    std::size_t total_seconds = 8;  ///< for all answers; a quarter of them for one
    double clock_seconds = 20;      ///< by the clock, for one answer; for all of them four times that
    std::size_t megabytes = 1024;
    std::size_t printed_bytes = 1 << 20;
    std::size_t threads = 256;  ///< above what the machine runs anyway
};

/// A worker with the learner's code, in a process and a process group of its own. It ends with this one, and so does
/// every process that it has started. What it prints goes to a file.
class Remote {
public:
    /// Starts `program`; the file `printed` gets what it prints. `launcher` are the words of
    /// another program before it, which shuts it away: bubblewrap and its options.
    Remote(const std::string& program, const std::string& printed, const std::vector<std::string>& launcher = {},
           const Limits& limits = {});
    ~Remote();
    Remote(const Remote&) = delete;
    Remote& operator=(const Remote&) = delete;

    /// Waits for the first call to be possible: the learner's global variables are made before.
    /// Throws NoAnswer where it never is.
    void await();
    /// What the learner's code answers. Throws NoAnswer where it does not.
    Numbers operator()(const Numbers& arguments);
    /// The last call has been made: what the learner's code does at its end, it does now. Throws NoAnswer where that is
    /// a crash, or takes too much.
    void await_end();

private:
    void wait_for(int pipe, short event);
    bool send(const void* from, std::size_t size);
    std::string hear(Reply expected);
    void receive(void* to, std::size_t size);
    [[noreturn]] void gone();
    void end();

    Limits limits_;
    bool launched_;
    pid_t process_ = -1;
    int calls_ = -1, answers_ = -1;
    std::uint64_t number_ = 0;   // of the last call
    std::size_t most_bytes_;     // of its answer
    double begin_, call_begin_;  // by the clock
};

}  // namespace checker
