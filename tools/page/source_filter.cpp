// source_filter: what Doxygen reads of a source file.
//
//     source_filter INTERFACE_FOLDER GROUPS FILE
//
// A header of the library is read line for line, less the markers of the snippets that pages quote,
// which would end up in the documentation of the declaration below them; and what it declares goes into the group
// that GROUPS has for it. Programs and tests are no interface: of them Doxygen reads nothing, and shows them in the
// source browser only.

#include "directives.hpp"
#include "text.hpp"

#include <iostream>

namespace {

/// The group of the header `file`, or nothing.
std::string group_of(const std::string& file, const std::string& groups) {
    for (const auto& [cells, line] : page::rows_of(groups, 2))
        if (file.ends_with("/" + cells[0])) return cells[1];
    return {};
}

/// A line of a header below the line `before`, with its group. None more and none less: the documentation tells where
/// things are defined.
std::string in_group(const std::string& before, const std::string& line, const std::string& group) {
    if (group.empty()) return page::marker_tag(line).empty() ? line : "";
    if (line == "#pragma once") return "/// \\file";
    if (line == "/// \\file" && before == "#pragma once") return "/// \\ingroup " + group;
    const bool hidden = line.find("detail") != std::string::npos;
    if (line.starts_with("namespace timestep") && line.ends_with("{") && !hidden)
        return line + " /** \\addtogroup " + group + " */ /** \\{ */";
    if (line.starts_with("}  // namespace timestep") && !hidden) return "/** \\} */ " + line;
    return page::marker_tag(line).empty() ? line : "";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: source_filter INTERFACE_FOLDER GROUPS FILE\n";
        return 2;
    }
    try {
        const std::string interface_folder{argv[1]};
        const std::string file{argv[3]};
        if (file.starts_with(interface_folder)) {
            const std::vector<std::string> lines = page::split_lines(page::read_file(file));
            const std::string group = group_of(file, argv[2]);
            for (std::size_t i = 0; i < lines.size(); ++i)
                std::cout << in_group(i > 0 ? lines[i - 1] : "", lines[i], group) << "\n";
        }
        return std::cout.flush() ? 0 : 2;
    } catch (const std::exception& wrong) {
        std::cerr << wrong.what() << "\n";
        return 2;
    }
}
