#include "skeleton.hpp"

#include "error.hpp"

#include <array>

namespace page {

void check_skeleton(const std::vector<Piece>& pieces, const Chapter& chapter,
                    const std::string& file) {
    constexpr std::array sections{"question", "mathematics", "code",      "run",        "pictures",
                                  "break_it", "cost",        "exercises", "in_the_talk"};
    std::size_t next = 0;
    for (const Piece& piece : pieces) {
        if (piece.kind != Piece::Kind::heading) {
            continue;
        }
        const Heading heading = parse_heading(piece.text);
        if (heading.level == 1 && heading.title != chapter.title) {
            throw Error{file, piece.line,
                        "the page's title must be that of about.json: " + chapter.title};
        }
        if (heading.level != 2) {
            continue;
        }
        if (next == sections.size()) {
            throw Error{file, piece.line, "a chapter has nine ## sections; make this one a ###"};
        }
        const std::string wanted = chapter.section_prefix() + sections[next++];
        if (heading.id != wanted) {
            throw Error{
                file, piece.line,
                "section " + std::to_string(next) + " of 9 must have the id {#" + wanted + "}"};
        }
    }
    if (next < sections.size()) {
        throw Error{file, pieces.empty() ? 1 : pieces.back().line,
                    "the section {#" + chapter.section_prefix() + sections[next] +
                        "} is missing (a chapter has nine, in one order)"};
    }
}

}  // namespace page
