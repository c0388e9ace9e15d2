#pragma once
/// \file
/// Ctrl-C, and what else asks a program to end, while there is something to tidy up.

#include <array>
#include <csignal>

namespace course {

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
