#pragma once
/// \file
/// Running another program and listening to it; Ctrl-C while there is something to tidy up.

#include <array>
#include <csignal>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Runs `command` and passes on all it prints (standard output and error together) at once; calls `silence` for every
/// second without output. Returns the exit status. Throws Stop if the command cannot be started or a signal ended it.
int listen(
    const std::vector<std::string>& command, const std::function<void(std::string_view)>& heard,
    const std::function<void()>& silence = [] {});

/// Replaces this program by another in the same process. Throws Stop if that one cannot be started.
[[noreturn]] void hand_over(const std::vector<std::string>& command);

/// Limits of a program. 0 means no limit.
struct Allowance {
    double seconds;
    std::size_t megabytes = 0;       ///< of memory
    std::size_t file_megabytes = 0;  ///< of a file that it writes
    std::size_t processes = 0;       ///< and threads, in addition to those that the machine runs already
    std::string temporary = {};      ///< the folder for its temporary files; empty: the usual one
    int processor_seconds = 0;       ///< of each of its processes
    std::string waiting_for = {};    ///< what Wait prints meanwhile
};

struct Outcome {
    int status = 0;         ///< its exit status; 128 + signal where one ended it
    bool too_slow = false;  ///< it was stopped
    std::string said;  ///< standard output and error together; of more than a million bytes, the beginning and the end
};

/// Runs `command` in an English locale until it ends or reaches a limit, then kills its whole process group. The
/// command has no terminal, and its output is a socket, which it cannot open again to read: it cannot wait for input.
/// It reads `input`, which is at most some kilobytes. Throws Stop if it cannot be started, and after an interrupt (see
/// TidyEnd).
Outcome run_within(const std::vector<std::string>& command, const Allowance& allowance, const std::string& input = {});

/// Cuts output that comes in pieces into lines.
class Lines {
public:
    explicit Lines(std::function<void(const std::string&)> line) : line_(std::move(line)) {}
    void operator()(std::string_view piece);

private:
    std::function<void(const std::string&)> line_;
    std::string rest_;
};

/// While one exists, SIGINT, SIGTERM and SIGHUP only set `interrupted`: whoever waits, in any thread, checks it and
/// throws, so that destructors run. A signal that nobody has checked ends the program when the last TidyEnd goes.
class TidyEnd {
public:
    TidyEnd();
    ~TidyEnd();
    TidyEnd(const TidyEnd&) = delete;
    TidyEnd& operator=(const TidyEnd&) = delete;

private:
    std::array<struct sigaction, 3> before_;
};

/// Was there a signal?
bool interrupted();

/// Throws Stop(interrupted) if there was.
void stop_if_interrupted();

}  // namespace course
