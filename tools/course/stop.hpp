#pragma once
/// \file
/// How a command ends when it fails.

#include <stdexcept>
#include <string>

namespace course {

/// Exit status of the program.
enum class Status {
    fine = 0,
    wrong = 1,         ///< a check is wrong, or something did not build
    bad_use = 2,       ///< wrong use or bad input
    missing = 3,       ///< the machine lacks something
    interrupted = 130  ///< by Ctrl-C, as shells count it
};

/// Ends the command with a line for people and an exit status for programs.
class Stop : public std::runtime_error {
public:
    Stop(Status status, const std::string& line) : std::runtime_error(line), status_(status) {}
    Status status() const { return status_; }

private:
    Status status_;
};

}  // namespace course
