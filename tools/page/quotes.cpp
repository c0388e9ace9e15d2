// What a page quotes: code from the sources, the output of the run, and its tables.

#include "directives.hpp"
#include "number.hpp"
#include "snippet.hpp"
#include "text.hpp"

#include <algorithm>
#include <stdexcept>

namespace page {
namespace {

/// Doxygen highlights what it knows by this name.
std::string language(const std::string& file) {
    const std::string extension = std::filesystem::path{file}.extension().string();
    return extension == ".hpp" || extension == ".cpp" ? "cpp" : "";
}

/// A cell as a number, "× 1.5" and "57 %" among them, set so that no line breaks in it. Empty: words.
std::string number_cell(const std::string& cell) {
    static const std::string times = "× ", percent = " %";
    if (parse_number(cell)) {
        return typeset(cell, "");
    }
    if (cell.starts_with(times) && parse_number(cell.substr(times.size()))) {
        return "×\u00a0" + typeset(cell.substr(times.size()), "");
    }
    const std::string before = cell.substr(0, cell.size() - std::min(cell.size(), percent.size()));
    return cell.ends_with(percent) && parse_number(before) ? typeset(before, "%") : "";
}

/// A column is set flush right when there are numbers in it; the first only when it has no words.
bool is_numeric(const Table& table, std::size_t column) {
    bool any = false, words = false;
    for (const std::vector<std::string>& row : table.rows) {
        const bool number = !number_cell(row[column]).empty();
        any = any || number;
        words = words || (!number && !row[column].empty() && row[column] != "–");
    }
    return any && (column > 0 || !words);
}

/// Of the lines of `code` the one that holds these words, counted from 1.
int line_with(const std::string& words, const std::string& code) {
    const std::vector<std::string> lines = split_lines(code);
    int found = 0, count = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].find(words) != std::string::npos) {
            found = static_cast<int>(i) + 1;
            ++count;
        }
    }
    if (count != 1) {
        throw std::out_of_range{std::to_string(count) + " of the quoted lines hold \"" + words +
                                "\", instead of the one that matters"};
    }
    return found;
}

/// All of a file that is there.
Snippet whole(const std::filesystem::path& root, const std::string& file) {
    if (!std::filesystem::is_regular_file(root / file)) {
        throw std::out_of_range{"there is no file " + file};
    }
    return {read_file(root / file), 0};
}

}  // namespace

std::string source_link(const std::string& file, int line, const std::string& text) {
    std::string number = std::to_string(line);
    number.insert(0, number.size() < 5 ? 5 - number.size() : 0, '0');
    return "<a href=\"source:" + file + (line > 0 ? "#l" + number : "") + "\">" + text + "</a>";
}

std::string code_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.empty()) {
        throw std::invalid_argument{"a quotation is {{code file tag}}, or {{code file}} for all of it"};
    }
    const std::string& file = directive.arguments.front();
    std::string tag;  // of one or more words
    for (std::size_t i = 1; i < directive.arguments.size(); ++i) {
        tag += (i > 1 ? " " : "") + directive.arguments[i];
    }
    const Snippet snippet = tag.empty() ? whole(context.root(), file) : quote(context.root(), file, tag);
    context.inputs.insert(context.root() / file);
    // The site shows C++ sources whole; other files are quoted without a link.
    const std::string caption =
        language(file).empty() ? escape_markdown(file) : source_link(file, snippet.first_line, escape_markdown(file));
    const std::string fence = snippet.code.find("```") == std::string::npos ? "```" : "~~~~";
    const std::string marked =
        directive.text.empty() ? "" : " data-line=\"" + std::to_string(line_with(directive.text, snippet.code)) + "\"";
    return "\n\\htmlonly[block]<figure class=\"listing\"" + marked + "><figcaption>\\endhtmlonly\n" + caption +
           "\n\\htmlonly[block]</figcaption>\\endhtmlonly\n\n" + fence + language(file) + "\n" + snippet.code + fence +
           "\n\n\\htmlonly[block]</figure>\\endhtmlonly\n";
}

std::string run_markdown(Context& context, const Directive& directive) {
    if (context.chapter() == nullptr || !directive.arguments.empty()) {
        throw std::invalid_argument{"{{run}} or {{run: Heading}} stands on a chapter's page"};
    }
    std::string name;
    const std::string printed = context.run_of(context.chapter()->folder + "/", name).printed(directive.text);
    const std::size_t first = printed.find_first_not_of('\n');
    if (first == std::string::npos) {
        throw std::out_of_range{"the run of " + context.chapter()->folder + " printed nothing"};
    }
    const std::string prompt =
        "./course run " + std::to_string(context.chapter()->number) + (directive.text.empty() ? "" : " --study");
    return "\n\\htmlonly[block]<pre class=\"run\" tabindex=\"0\"><span class=\"prompt\">$ " + prompt + "</span>\n" +
           escape_html(printed.substr(first)) + "</pre>\\endhtmlonly\n";
}

std::string said_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) {
        throw std::invalid_argument{"what a program said is {{said file.txt}}"};
    }
    std::string file;
    RunData& run = context.run_of(directive.arguments.front(), file);
    const std::string words = run.text(file);
    if (trim(words).empty()) {
        throw std::out_of_range{file + " holds no word"};
    }
    return "\n\\htmlonly[block]<pre class=\"run said\">" + escape_html(words) + "</pre>\\endhtmlonly\n";
}

// A bar in a formula becomes TeX's; any other would end the cell.
std::string with_bars_kept(const std::string& cell) {
    std::string kept;
    bool formula = false;
    for (const char c : cell) {
        if (c == '$') formula = !formula;
        if (c == '|' && !formula) kept += '\\';
        kept += c;
    }
    return kept;
}

std::string table_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) {
        throw std::invalid_argument{"a table is {{table file.tsv}}"};
    }
    std::string file;
    RunData& run = context.run_of(directive.arguments.front(), file);
    const Table table = run.table(file);
    std::string names = "|", rule = "|", body;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        names += ' ';
        names += replace_all(table.columns[column], "_", " ") + " |";
        rule += is_numeric(table, column) ? "---:|" : "---|";
    }
    for (const std::vector<std::string>& row : table.rows) {
        body += "|";
        for (const std::string& cell : row) {
            // Words may hold formulas and Markdown: the cell is filled like the page itself.
            const std::string number = number_cell(cell);
            body += " " + (number.empty() ? with_bars_kept(cell) : number) + " |";
        }
        body += "\n";
    }
    return "\n" + names + "\n" + rule + "\n" + body;
}

}  // namespace page
