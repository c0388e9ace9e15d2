#pragma once

#include <string>
#include <vector>

namespace page {

/// A part of a chapter's program.
struct Part {
    std::string code;
    int first_line;
};

/// Cuts a program into parts, each from the line that begins with its words to where the next one begins. Together
/// they are the program: the first words must stand at its beginning, and all of them in their order. Throws
/// std::out_of_range.
std::vector<Part> parts_of(const std::string& source, const std::vector<std::string>& beginnings);

}  // namespace page
