#pragma once
/// \file
/// Running another program and listening to it.

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

/// Cuts what comes in pieces into whole lines.
class Lines {
public:
    explicit Lines(std::function<void(const std::string&)> line) : line_(std::move(line)) {}
    void operator()(std::string_view piece);

private:
    std::function<void(const std::string&)> line_;
    std::string rest_;
};

}  // namespace course
