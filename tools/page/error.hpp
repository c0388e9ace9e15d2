#pragma once

#include <stdexcept>
#include <string>

namespace page {

/// What a page does wrong, and where: `file:line: message`, as compilers say it.
class Error : public std::runtime_error {
public:
    Error(const std::string& file, int line, const std::string& message)
        : std::runtime_error{file + ":" + std::to_string(line) + ": " + message} {}
};

}  // namespace page
