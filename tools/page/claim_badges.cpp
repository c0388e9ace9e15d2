// Claims of the talks on a chapter's page: badges below a heading.

#include "directives.hpp"
#include "text.hpp"

#include <algorithm>
#include <stdexcept>

namespace page {

std::string rows_markdown(Context& context, const Directive& directive, const Heading& heading) {
    const Chapter* chapter = context.chapter();
    if (chapter == nullptr || directive.arguments.empty() || heading.id.empty()) {
        throw std::invalid_argument{"{{claims N22 N24}} stands directly below a heading that has an id"};
    }
    std::string badges;
    for (const std::string& row : directive.arguments) {
        if (std::count(chapter->claims.begin(), chapter->claims.end(), row) == 0) {
            throw std::out_of_range{"\"" + row + "\" is none of this chapter's claims"};
        }
        context.index.push_back({row, "section", context.page() + ".html", heading.id, heading.title});
        badges += " <a class=\"row\" href=\"talks.html#row_" + row + "\">" + row + "</a>";
    }
    return "\n<div class=\"claims\">In the talks:" + badges + "</div>\n";
}

}  // namespace page
