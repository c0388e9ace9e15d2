#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace page {

/// A page source falls into these pieces; put together again they are the source.
struct Piece {
    enum class Kind {
        text,       ///< Markdown
        code,       ///< a fence or inline code: left alone
        formula,    ///< $…$, here without its dollars
        display,    ///< $$…$$, the same
        directive,  ///< {{…}}, here without its braces
        heading,    ///< a whole line beginning with #
    };
    Kind kind;
    std::string text;
    int line;       ///< where it begins
    bool own_line;  ///< nothing else stands on its line (or lines)
    bool in_table;  ///< it stands in a row of a Markdown table
};

/// Takes a source (or a part of one that begins at `first_line`) apart. Throws Error for a
/// formula, a directive or a fence without its end.
std::vector<Piece> scan(std::string_view source, const std::string& file, int first_line = 1);

/// A heading's parts: `## The spiral {#ch3_spiral}`.
struct Heading {
    int level;
    std::string title, id;  ///< the id is empty when there is none
};
Heading parse_heading(std::string_view line);

}  // namespace page
