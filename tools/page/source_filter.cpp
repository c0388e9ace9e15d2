// source_filter: what Doxygen reads of a source file.
//
// A header of the library is read as it stands, less the markers of the snippets that pages quote,
// which would end up in the documentation of the declaration below them. Programs and tests are no
// interface: of them Doxygen reads nothing, and shows them in the source browser only.

#include "snippet.hpp"
#include "text.hpp"

#include <iostream>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: source_filter INTERFACE_FOLDER FILE\n";
        return 2;
    }
    try {
        const std::string interface_folder{argv[1]};
        const std::string file{argv[2]};
        if (file.starts_with(interface_folder)) {
            for (const std::string& line : page::split_lines(page::read_file(file))) {
                std::cout << (page::marker_tag(line).empty() ? line : "") << "\n";
            }
        }
        return std::cout.flush() ? 0 : 2;
    } catch (const std::exception& wrong) {
        std::cerr << wrong.what() << "\n";
        return 2;
    }
}
