// The talks row by row: what they show, and where the course teaches, draws and tests it.

#include "directives.hpp"
#include "error.hpp"
#include "claims.hpp"
#include "tagged_tests.hpp"
#include "text.hpp"

#include <stdexcept>
#include <utility>

namespace page {
namespace {

struct Sources {
    std::map<std::string, TalkRow> talks;
    std::vector<IndexEntry> index;
    std::vector<TestPlace> tests;
};

std::string index_links(const Sources& sources, const std::string& row, const std::string& kind) {
    std::string links;
    for (const IndexEntry& entry : sources.index) {
        if (entry.row == row && entry.kind == kind) {
            links += (links.empty() ? "" : "<br>") + ("<a href=\"" + entry.page + "#" + entry.anchor) + "\">" +
                     escape_markdown(entry.title) + "</a>";
        }
    }
    return links;
}

/// A test's name where neither Doxygen nor the page tool shall find Markdown in it.
std::string plain_html(const std::string& name) {
    std::string html = escape_html(name);
    for (const auto& [mark, entity] : {std::pair{"$", "&#36;"}, {"`", "&#96;"}, {"{", "&#123;"}, {"\\", "&#92;"}}) {
        html = replace_all(html, mark, entity);
    }
    return html;
}

/// A link to the line of the study that makes the check. An unknown check is an Error in docs/talks.tsv.
std::string check_link(Context& context, const TalkRow& row, const std::string& check, const Chapter& chapter) {
    std::string name;
    RunData& run = context.run_of(chapter.folder + "/" + check, name);
    try {
        const std::string text = plain_html(run.check(name)), place = run.place_of(name, "check");
        const std::size_t colon = place.rfind(':');
        return colon == std::string::npos
                   ? text
                   : source_link(place.substr(0, colon), std::stoi(place.substr(colon + 1)), text);
    } catch (const NotYet&) {
        throw;
    } catch (const std::out_of_range& unknown) {
        throw Error{"docs/talks.tsv", row.line, unknown.what()};
    }
}

/// Links to the tests of a row and to the study's checks of it: the first, and the others folded away.
std::string evidence_links(Context& context, const Sources& sources, const std::string& row, const Chapter& chapter) {
    std::vector<std::string> links;
    const TalkRow& talk = sources.talks.at(row);
    for (const std::string& check : talk.checks) {
        links.push_back(check_link(context, talk, check, chapter));
    }
    for (const TestPlace& test : sources.tests) {
        if (test.row == row) {
            links.push_back(source_link(test.file, test.line, plain_html(test.name)));
        }
    }
    if (links.empty()) {
        return {};
    }
    std::string html = "\\htmlonly" + links.front();
    if (links.size() > 1) {
        html += "<details><summary>and " + std::to_string(links.size() - 1) + " more</summary>";
        for (std::size_t i = 1; i < links.size(); ++i) {
            html += (i > 1 ? "<br>" : "") + links[i];
        }
        html += "</details>";
    }
    return html + "\\endhtmlonly";
}

/// One row of the table. A claimed row that lacks its text, its section, or both check and test is an Error in the
/// about.json that claims it.
std::string row_markdown(Context& context, const Sources& sources, const std::string& row, const Chapter& chapter) {
    const auto claim = [&](bool kept, const std::string& lack) {
        if (!kept) {
            throw Error{chapter.about(), 1, row + " is claimed, but " + lack};
        }
    };
    const auto found = sources.talks.find(row);
    claim(found != sources.talks.end(), "docs/talks.tsv does not say what the talks show");
    const std::string sections = index_links(sources, row, "section");
    claim(!sections.empty(), "no section teaches it ({{claims " + row + "}})");
    const std::string tests = evidence_links(context, sources, row, chapter);
    claim(!tests.empty(), "docs/talks.tsv names no check of it, and no test is tagged [" + row + "]");
    const std::string figures = index_links(sources, row, "figure");

    const TalkRow& talk = found->second;
    const std::string erratum =
        talk.erratum.empty() ? "" : "<br><span class=\"erratum\"><b>Erratum.</b> " + talk.erratum + "</span>";
    return "<tr id=\"row_" + row + "\">\n<td class=\"id\"><b>" + row + "</b></td>\n<td>" + talk.text + erratum +
           "</td>\n<td class=\"section\">" + sections + "</td>\n<td class=\"figures\">" + figures +
           "</td>\n<td class=\"tests\">" + tests + "</td>\n</tr>\n";
}

}  // namespace

std::string talks_markdown(Context& context) {
    if (context.indexes.empty()) {
        throw std::invalid_argument{"{{talks}} needs the option --indexes"};
    }
    const std::filesystem::path file = context.root() / "docs/talks.tsv";
    const Sources sources{load_talks(file), load_indexes(context.indexes), load_tests(context.root())};
    context.inputs.insert(file);
    for (const std::filesystem::path& source : test_sources(context.root())) {
        context.inputs.insert(source);
    }
    std::string tables;
    for (const Chapter& chapter : context.chapters()) {
        if (chapter.claims.empty()) {
            continue;
        }
        tables += "\n## " + chapter.heading() + " {#talks_" + chapter.id() + "}\n\n" +
                  "<table class=\"talks\">\n<tr><th>Row</th><th>What the talks show</th>"
                  "<th>Taught in</th><th>Drawn in</th><th>Tested by</th></tr>\n";
        for (const std::string& row : chapter.claims) {
            tables += row_markdown(context, sources, row, chapter);
        }
        tables += "</table>\n";
    }
    return tables;
}

}  // namespace page
