#include "skeleton.hpp"

#include "directives.hpp"
#include "error.hpp"
#include "text.hpp"

#include <algorithm>
#include <set>

namespace page {
namespace {

/// The rows that a chapter's second page teaches.
std::set<std::string> rows_of_more(const Context& context) {
    const Chapter& chapter = *context.chapter();
    std::set<std::string> rows;
    if (chapter.has_more) {
        const std::string file = chapter.source(true);
        for (const Piece& piece : scan(read_file(context.root() / file), file)) {
            if (piece.kind == Piece::Kind::directive && piece.text.starts_with("claims ")) {
                const Directive directive = parse_directive(piece.text);
                rows.insert(directive.arguments.begin(), directive.arguments.end());
            }
        }
    }
    return rows;
}

}  // namespace

void check_skeleton(const std::vector<Piece>& pieces, const Chapter& chapter, const std::string& file) {
    for (const Piece& piece : pieces) {
        if (piece.kind != Piece::Kind::heading) continue;
        const Heading heading = parse_heading(piece.text);
        if (heading.level == 1 && heading.title != chapter.title)
            throw Error{file, piece.line, "the page's title must be that of about.json: " + chapter.title};
        if (heading.level == 2 && !heading.id.starts_with(chapter.section_prefix()))
            throw Error{file, piece.line, "a ## section must have an id that begins {#" + chapter.section_prefix()};
    }
}

void check_more(const std::vector<Piece>& pieces, const Chapter& chapter, const std::string& file) {
    bool titled = false;
    for (const Piece& piece : pieces) {
        if (piece.kind != Piece::Kind::heading) continue;
        const Heading heading = parse_heading(piece.text);
        if (!titled && (heading.level != 1 || heading.id != chapter.id(true))) {
            throw Error{file, piece.line,
                        "the first heading must be the title, with the id {#" + chapter.id(true) + "}"};
        }
        if (titled && (heading.level == 1 || !heading.id.starts_with(chapter.section_prefix(true)))) {
            throw Error{
                file, piece.line,
                "below the title a section is ## or ###, with an id that begins {#" + chapter.section_prefix(true)};
        }
        titled = true;
    }
    if (!titled) throw Error{file, 1, "the page has no title, with the id {#" + chapter.id(true) + "}"};
}

void check_complete(const Context& context) {
    const Chapter& chapter = *context.chapter();
    for (const std::string& figure : chapter.figures) {
        const std::string name = chapter.folder + "/" + figure;
        const auto found = std::find_if(context.order.begin(), context.order.end(),
                                        [&](const Numbered& each) { return each.figure == name; });
        const bool belongs_here = found == context.order.end() ? !context.is_more() : found->page == context.page();
        if (belongs_here && context.figures.count(name) == 0 && context.left_out.count(name) == 0)
            throw Error{chapter.about(), 1, "the page does not show " + figure};
    }
    if (context.is_more()) return;
    const std::set<std::string> beside = rows_of_more(context);
    for (const std::string& row : chapter.claims) {
        const auto teaches = [&](const IndexEntry& entry) { return entry.row == row && entry.kind == "section"; };
        if (beside.count(row) == 0 && std::none_of(context.index.begin(), context.index.end(), teaches)) {
            throw Error{chapter.about(), 1,
                        row + " is claimed, but no section of the page teaches it ({{claims " + row + "}})"};
        }
    }
}

}  // namespace page
