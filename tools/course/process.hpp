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

/// Runs `command` and hands on all it prints (standard output and error together) as it comes;
/// calls `silence` for every second in which nothing comes. Returns its exit status. Throws Stop
/// where it cannot be started or was ended by a signal.
int listen(
    const std::vector<std::string>& command, const std::function<void(std::string_view)>& heard,
    const std::function<void()>& silence = [] {});

/// Becomes this program, with all that this one has: terminal, output, process. Throws Stop where it
/// cannot be started.
[[noreturn]] void hand_over(const std::vector<std::string>& command);

/// How much a program may take. 0: as much as it likes.
struct Allowance {
    double seconds;
    std::size_t megabytes = 0;       ///< of memory
    std::size_t file_megabytes = 0;  ///< of a file that it writes
    std::size_t processes = 0;       ///< and threads, above what the machine runs anyway
    std::string temporary = {};      ///< the folder for its temporary files; empty: the usual one
    int processor_seconds = 0;       ///< of each of its processes
    double idle_seconds = 0;         ///< in which none of them does any work
    std::string waiting_for = {};    ///< what people are told who wait for it
};

struct Outcome {
    int status = 0;         ///< its exit status; 128 + signal where one ended it
    bool too_slow = false;  ///< it was stopped
    bool waited = false;    ///< and that because it did no work
    std::string said;  ///< standard output and error together, of a million bytes and more the beginning and the end
};

/// Runs `command`, which is to speak English, to its end or to the end of its allowance, and then
/// ends the whole process group. It has no terminal, and what it prints cannot be opened once more to
/// be read: nothing can wait for what never comes. Throws Stop where it cannot be started, and where there was an
/// interrupt (see TidyEnd).
/// `input`, of at most some kilobytes, is what it reads.
Outcome run_within(const std::vector<std::string>& command, const Allowance& allowance, const std::string& input = {});

/// Cuts what comes in pieces into whole lines.
class Lines {
public:
    explicit Lines(std::function<void(const std::string&)> line) : line_(std::move(line)) {}
    void operator()(std::string_view piece);

private:
    std::function<void(const std::string&)> line_;
    std::string rest_;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP end nothing by themselves: whoever waits looks at
/// `interrupted`, and throws, so that destructors run. A signal that nobody has looked at ends the
/// program after it.
class TidyEnd {
public:
    TidyEnd();
    ~TidyEnd();
    TidyEnd(const TidyEnd&) = delete;
    TidyEnd& operator=(const TidyEnd&) = delete;

private:
    std::array<struct sigaction, 3> before_;
};

/// Has there been a signal that nobody has thrown for?
bool interrupted();

/// Throws Stop(interrupted) if so.
void stop_if_interrupted();

}  // namespace course
