// The talks row by row: what they show, and where the course teaches, draws and tests it.

#include "directives.hpp"
#include "text.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <utility>

namespace page {
namespace {

/// The rows of a file whose first cell is a claim.
std::vector<Row> claims_of(const std::filesystem::path& file, std::size_t cells) {
    std::vector<Row> rows = rows_of(file, cells);
    for (const Row& row : rows)
        if (!is_row(row.cells.front())) throw Error{file.string(), row.line, "must begin with a claim"};
    return rows;
}

/// Every index file in the folder.
std::vector<IndexEntry> load_indexes(const std::filesystem::path& folder) {
    std::set<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator{folder})
            if (entry.path().extension() == ".tsv") files.insert(entry.path());
    std::vector<IndexEntry> index;
    for (const std::filesystem::path& file : files)
        for (const auto& [cells, line] : claims_of(file, 5))
            index.push_back({cells[0], cells[1], cells[2], cells[3], cells[4]});
    return index;
}

/// The tests below these folders, by file and line. Nothing is compiled for it.
std::vector<TestPlace> load_tests(Context& context) {
    std::set<std::filesystem::path> sources;
    for (const char* folder : {"tests/advise", "tests/chapters", "tests/library"}) {
        if (!std::filesystem::is_directory(context.root() / folder)) continue;
        for (const auto& entry : std::filesystem::directory_iterator{context.root() / folder})
            if (entry.path().extension() == ".cpp" && !entry.path().filename().string().starts_with("."))
                sources.insert(entry.path());
    }
    std::vector<TestPlace> tests;
    for (const std::filesystem::path& source : sources) {
        const std::string file = std::filesystem::proximate(source, context.root()).generic_string();
        const std::vector<TestPlace> found = tagged_tests(read_file(source), file);
        tests.insert(tests.end(), found.begin(), found.end());
    }
    context.inputs.insert(sources.begin(), sources.end());
    return tests;
}

struct Sources {
    std::map<std::string, TalkRow> talks;
    std::vector<IndexEntry> index;
    std::vector<TestPlace> tests;
};

std::string index_links(const Sources& sources, const std::string& row, const std::string& kind) {
    std::string links;
    for (const IndexEntry& entry : sources.index)
        if (entry.row == row && entry.kind == kind)
            links += (links.empty() ? "" : "<br>") + ("<a href=\"" + entry.page + "#" + entry.anchor) + "\">" +
                     escape_markdown(entry.title) + "</a>";
    return links;
}

/// A test's name where neither Doxygen nor the page tool shall find Markdown in it.
std::string plain_html(const std::string& name) {
    std::string html = escape_html(name);
    for (const auto& [mark, entity] : {std::pair{"$", "&#36;"}, {"`", "&#96;"}, {"{", "&#123;"}, {"\\", "&#92;"}})
        html = replace_all(html, mark, entity);
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
        if (!context.draft) throw;
        ++context.gaps;  // the other links of the row stay
        return "<span class=\"gap\">(…)</span>";
    } catch (const std::out_of_range& unknown) {
        throw Error{"docs/talks.tsv", row.line, unknown.what()};
    }
}

/// Links to the tests of a row and to the study's checks of it: the first, and the others folded away.
std::string evidence_links(Context& context, const Sources& sources, const std::string& row, const Chapter& chapter) {
    std::vector<std::string> links;
    const TalkRow& talk = sources.talks.at(row);
    for (const std::string& check : talk.checks) links.push_back(check_link(context, talk, check, chapter));
    for (const TestPlace& test : sources.tests) {
        if (test.row == row) links.push_back(source_link(test.file, test.line, plain_html(test.name)));
    }
    if (links.empty()) return {};
    std::string html = "\\htmlonly" + links.front();
    if (links.size() > 1) {
        html += "<details><summary>and " + std::to_string(links.size() - 1) + " more</summary>";
        for (std::size_t i = 1; i < links.size(); ++i) html += (i > 1 ? "<br>" : "") + links[i];
        html += "</details>";
    }
    return html + "\\endhtmlonly";
}

/// One row of the table. A claimed row that lacks its text, its section, or both check and test is an Error in the
/// about.json that claims it.
std::string row_markdown(Context& context, const Sources& sources, const std::string& row, const Chapter& chapter) {
    const auto claim = [&](bool kept, const std::string& lack) {
        if (!kept) throw Error{chapter.about(), 1, row + " is claimed, but " + lack};
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

/// Adjacent string literals, "so" " much", as the one that the compiler makes of them.
static std::string joined(const std::string& literals) {
    std::string text;
    bool inside = false;
    for (std::size_t at = 0; at < literals.size(); ++at) {
        if (literals[at] == '"')
            inside = !inside;
        else if (inside)
            text += literals[at] == '\\' ? literals[++at] : literals[at];
    }
    return text;
}

std::vector<TestPlace> tagged_tests(const std::string& text, const std::string& file) {
    static const std::string literals = R"re(((?:\s*"(?:[^"\\]|\\.)*")+))re";
    static const std::regex test{"[A-Z_]*TEST_CASE\\(" + literals + "," + literals}, tag{R"(\[([^\[\]]*)\])"};
    std::vector<TestPlace> tests;
    for (std::sregex_iterator each{text.begin(), text.end(), test}, end; each != end; ++each) {
        if (each->position() > 0 && text[static_cast<std::size_t>(each->position()) - 1] != '\n') continue;
        const int line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + each->position(), '\n'));
        const std::string name = joined((*each)[1]), tags = joined((*each)[2]);
        for (std::sregex_iterator row{tags.begin(), tags.end(), tag}; row != end; ++row)
            if (is_row((*row)[1].str())) tests.push_back({(*row)[1], name, file, line});
    }
    return tests;
}

std::map<std::string, TalkRow> load_talks(const std::filesystem::path& file) {
    std::map<std::string, TalkRow> talks;
    for (const auto& [cells, line] : claims_of(file, 5)) {
        if (cells[2].empty()) throw Error{file.string(), line, cells[0] + " has no text"};
        if (!talks.emplace(cells[0], TalkRow{cells[1], cells[2], cells[3], split_words(cells[4]), line}).second)
            throw Error{file.string(), line, cells[0] + " stands here twice"};
    }
    return talks;
}

std::string index_lines(const std::vector<IndexEntry>& index) {
    std::string lines;
    for (const IndexEntry& entry : index)
        lines += entry.row + "\t" + entry.kind + "\t" + entry.page + "\t" + entry.anchor + "\t" + entry.title + "\n";
    return lines;
}

std::string claims_markdown(Context& context, const Directive& directive) {
    const Chapter* chapter = context.chapter();
    if (chapter == nullptr || directive.arguments.empty() || context.heading.id.empty())
        throw std::invalid_argument{"{{claims N22 N24}} stands directly below a heading that has an id"};
    std::string badges;
    for (const std::string& row : directive.arguments) {
        if (std::count(chapter->claims.begin(), chapter->claims.end(), row) == 0)
            throw std::out_of_range{"\"" + row + "\" is none of this chapter's claims"};
        context.index.push_back({row, "section", context.page() + ".html", context.heading.id, context.heading.title});
        badges += " <a class=\"row\" href=\"talks.html#row_" + row + "\">" + row + "</a>";
    }
    return "\n<div class=\"claims\">In the talks:" + badges + "</div>\n";
}

std::string talks_markdown(Context& context, const Directive&) {
    if (context.indexes.empty()) throw std::invalid_argument{"{{talks}} needs the option --indexes"};
    const std::filesystem::path file = context.root() / "docs/talks.tsv";
    const Sources sources{load_talks(file), load_indexes(context.indexes), load_tests(context)};
    context.inputs.insert(file);
    std::string tables;
    for (const Chapter& chapter : context.chapters()) {
        if (chapter.claims.empty()) continue;
        tables += "\n## " + chapter.heading() + " {#talks_" + chapter.id() + "}\n\n" +
                  "<table class=\"talks\">\n<tr><th>Row</th><th>What the talks show</th>"
                  "<th>Taught in</th><th>Drawn in</th><th>Tested by</th></tr>\n";
        for (const std::string& row : chapter.claims) tables += row_markdown(context, sources, row, chapter);
        tables += "</table>\n";
    }
    return tables;
}

}  // namespace page
