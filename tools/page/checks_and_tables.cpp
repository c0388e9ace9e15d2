// Numbers, checks and tables: what a sentence on a page rests on.

#include "directives.hpp"
#include "number.hpp"
#include "text.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>

namespace page {
namespace {

/// The number that `reference` names, without its unit when it ends in `.value`.
Number look_up(Context& context, std::string reference) {
    const bool bare = reference.ends_with(".value");
    if (bare) reference.erase(reference.size() - 6);
    std::string name;
    RunData& run = context.run_of(reference, name);
    Number number = run.number(name);
    if (number.value == "nan" || number.value == "-nan" || number.value.empty()) {
        throw std::out_of_range{
            "the number \"" + name + "\" is " +
            (number.value.empty() ? "not measured here; what needs it stands between {{where " + name + "}} and {{end}}"
                                  : "\"" + number.value + "\"") +
            run.written_at(name, "number")};
    }
    number.unit = bare ? "" : number.unit;
    return number;
}

/// A cell as a number, "× 1.5" and "57 %" among them, set so that no line breaks in it. Empty: words.
std::string number_cell(const std::string& cell) {
    static const std::string times = "× ", percent = " %";
    if (is_number(cell)) return typeset(cell, "");
    if (cell.starts_with(times) && is_number(cell.substr(times.size())))
        return "×\u00a0" + typeset(cell.substr(times.size()), "");
    const std::string before = cell.substr(0, cell.size() - std::min(cell.size(), percent.size()));
    return cell.ends_with(percent) && is_number(before) ? typeset(before, "%") : "";
}

/// A column is set flush right when there are numbers in it; the first only when it has no words.
bool is_numeric(const Table& table, std::size_t column) {
    bool any = false, words = false;
    for (std::size_t row = 1; row < table.size(); ++row) {
        const std::string& cell = table[row][column];
        const bool number = !number_cell(cell).empty();
        any = any || number;
        words = words || (!number && !cell.empty() && cell != "–");
    }
    return any && (column > 0 || !words);
}

/// A bar in a formula becomes TeX's; any other would end the cell.
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

/// The sign that a check is made, shown by the style sheet under the pointer, and on a phone at a tap.
std::string mark(const std::string& statement) {
    return "<span class=\"check\" tabindex=\"0\" role=\"note\" aria-label=\"The run confirms: " + statement +
           "\" data-statement=\"" + statement + "\">✓</span>";
}

}  // namespace

std::string number_markdown(Context& context, const std::string& reference) {
    const Number number = look_up(context, reference);
    // A sentence may be broken at the end of a line, a number or a name may not.
    const char* kind = number.value.size() > 40 ? "words" : "number";
    return "<span class=\"" + std::string(kind) + "\" title=\"" + attribute(number.meaning) + "\">" +
           typeset(number.value, number.unit) + "</span>";
}

std::string number_tex(Context& context, const std::string& reference) {
    const Number number = look_up(context, reference);
    return typeset_tex(number.value, number.unit);
}

std::string check_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) throw std::invalid_argument{"{{check name}} takes one name"};
    std::string name;
    return mark(attribute(context.run_of(directive.arguments.front(), name).check(name)));
}

std::string with_marks_joined(std::string page) {
    static const std::string any = mark("([^\"]*)");
    static const std::regex two{any + "[ \\n]+" + any},
        apart{"([^ \\n|*>-])(?!\\n\\n)[ \\n]+(?=<span class=\"check\")"};
    for (std::smatch found; std::regex_search(page, found, two);)
        page = found.prefix().str() + mark(found[1].str() + "; " + found[3].str()) + found.suffix().str();
    return std::regex_replace(page, apart, "$1\u00a0");  // no line begins with a mark
}

bool is_measured(Context& context, const Directive& directive, const std::string& folder) {
    if (directive.arguments.size() != 1) throw std::invalid_argument{"{{where name}} takes one name"};
    const std::string& reference = directive.arguments.front();
    std::string name;
    return !context
                .run_of(
                    reference.find('/') == std::string::npos && !folder.empty() ? folder + "/" + reference : reference,
                    name)
                .number(name)
                .value.empty();
}

std::string table_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) throw std::invalid_argument{"a table is {{table file.tsv}}"};
    std::string file;
    RunData& run = context.run_of(directive.arguments.front(), file);
    const Table table = run.table(file);
    std::string markdown = "\n", rule = "|";
    for (std::size_t row = 0; row < table.size(); ++row) {
        markdown += "|";
        for (std::size_t column = 0; column < table[row].size(); ++column) {
            const std::string &cell = table[row][column], number = number_cell(cell);
            // Words may hold formulas and Markdown: the cell is filled like the page itself.
            markdown += " " +
                        (row == 0         ? replace_all(cell, "_", " ")
                         : number.empty() ? with_bars_kept(cell)
                                          : number) +
                        " |";
            if (row == 0) rule += is_numeric(table, column) ? "---:|" : "---|";
        }
        markdown += row == 0 ? "\n" + rule + "\n" : "\n";
    }
    return markdown;
}

}  // namespace page
