// What a page quotes: code from the sources, the chapter's program, and the output of the run.

#include "directives.hpp"
#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace page {
namespace {

/// Takes away the blanks that every line begins with.
std::string join_at_margin(const std::vector<std::string>& lines) {
    std::size_t margin = std::string::npos;
    for (const std::string& line : lines) margin = std::min(margin, line.find_first_not_of(' '));
    std::string code;
    for (const std::string& line : lines) code += (line.size() > margin ? line.substr(margin) : "") + "\n";
    return code;
}

/// Doxygen highlights what it knows by this name.
std::string language(const std::string& file) {
    const std::string extension = std::filesystem::path{file}.extension().string();
    return extension == ".hpp" || extension == ".cpp" ? "cpp" : "";
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

/// Code as one sees it: without the blank lines at its end.
std::string listing(const std::string& code) {
    return "\n```cpp\n" + code.substr(0, code.find_last_not_of('\n') + 1) + "\n```\n";
}

}  // namespace

std::string marker_tag(std::string_view line) {
    line = trim(line);
    const std::size_t comment = line.find_first_not_of("/!#");
    if (comment == std::string_view::npos || comment == 0) return {};
    line = trim(line.substr(comment));
    if (!line.starts_with('[') || !line.ends_with(']') || line.find(']') + 1 != line.size()) return {};
    // An interval or a unit in brackets is a remark, no tag.
    const std::string_view tag = line.substr(1, line.size() - 2);
    const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == ' '; };
    return std::all_of(tag.begin(), tag.end(), fits) ? std::string{tag} : std::string{};
}

Snippet quote(const std::filesystem::path& root, const std::string& file, const std::string& tag) {
    if (!std::filesystem::is_regular_file(root / file)) throw std::out_of_range{"there is no file " + file};
    if (tag.empty()) return {read_file(root / file), 0};  // all of it
    std::vector<std::string> lines;
    int first_line = 0, line = 0, markers = 0;
    for (const std::string& text : split_lines(read_file(root / file))) {
        ++line;
        const std::string found = marker_tag(text);
        if (found == tag) {
            ++markers;
            first_line = markers == 1 ? line + 1 : first_line;
        } else if (markers == 1 && found.empty()) {
            lines.push_back(text);
        }
    }
    if (markers != 2) {
        throw std::out_of_range{"[" + tag + "] stands " + std::to_string(markers) + " times in " + file +
                                " instead of twice"};
    }
    while (!lines.empty() && trim(lines.front()).empty()) {
        lines.erase(lines.begin());
        ++first_line;
    }
    while (!lines.empty() && trim(lines.back()).empty()) lines.pop_back();
    if (lines.empty()) throw std::out_of_range{"nothing stands between the two [" + tag + "] in " + file};
    return {join_at_margin(lines), first_line};
}

std::vector<Part> parts_of(const std::string& source, const std::vector<std::string>& beginnings) {
    const std::vector<std::string> lines = split_lines(source);
    std::vector<std::size_t> starts;
    for (const std::string& words : beginnings) {
        std::size_t at = starts.empty() ? 0 : starts.back() + 1;
        while (at < lines.size() && !trim(lines[at]).starts_with(words)) ++at;
        if (at == lines.size() || (starts.empty() && at > 0)) {
            const std::string where = starts.empty() ? "the program does not begin with"
                                                     : "the rest of the program has no line that begins with";
            throw std::out_of_range{where + " \"" + words + "\""};
        }
        starts.push_back(at);
    }
    std::vector<Part> parts;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : lines.size();
        Part part{"", static_cast<int>(starts[i]) + 1};
        for (std::size_t line = starts[i]; line < end; ++line) part.code += lines[line] + "\n";
        parts.push_back(part);
    }
    return parts;
}

std::string source_link(const std::string& file, int line, const std::string& text) {
    std::string number = std::to_string(line);
    number.insert(0, number.size() < 5 ? 5 - number.size() : 0, '0');
    return "<a href=\"source:" + file + (line > 0 ? "#l" + number : "") + "\">" + text + "</a>";
}

std::string code_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.empty())
        throw std::invalid_argument{"a quotation is {{code file tag}}, or {{code file}} for all of it"};
    const std::string& file = directive.arguments.front();
    std::string tag;  // of one or more words
    for (std::size_t i = 1; i < directive.arguments.size(); ++i) tag += (i > 1 ? " " : "") + directive.arguments[i];
    const Snippet snippet = quote(context.root(), file, tag);
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
    if (context.chapter() == nullptr || !directive.arguments.empty())
        throw std::invalid_argument{"{{run}} or {{run: Heading}} stands on a chapter's page"};
    std::string name;
    const std::string printed = context.run_of(context.chapter()->folder + "/", name).printed(directive.text);
    const std::size_t first = printed.find_first_not_of('\n');
    if (first == std::string::npos)
        throw std::out_of_range{"the run of " + context.chapter()->folder + " printed nothing"};
    const std::string prompt =
        "./course run " + std::to_string(context.chapter()->number) + (directive.text.empty() ? "" : " --study");
    return "\n\\htmlonly[block]<pre class=\"run\" tabindex=\"0\"><span class=\"prompt\">$ " + prompt + "</span>\n" +
           escape_html(printed.substr(first)) + "</pre>\\endhtmlonly\n";
}

std::string said_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) throw std::invalid_argument{"what a program said is {{said file.txt}}"};
    std::string file;
    RunData& run = context.run_of(directive.arguments.front(), file);
    const std::string words = read_file(run.existing(file));
    if (trim(words).empty()) throw std::out_of_range{file + " holds no word"};
    return "\n\\htmlonly[block]<pre class=\"run said\">" + escape_html(words) + "</pre>\\endhtmlonly\n";
}

std::string program_markdown(Context& context, const Directive& directive) {
    if (!directive.arguments.empty() || context.program.empty())
        throw std::invalid_argument{"{{program: its first words}} or {{program}} stands on a chapter's page"};
    if (directive.text.empty())
        return "\n\\htmlonly[block]<details class=\"program\"><summary>The whole program</summary>\\endhtmlonly\n" +
               listing(context.program) + "\n\\htmlonly[block]</details>\\endhtmlonly\n";
    const Part& part = context.parts.at(context.parts_shown++);
    const std::string file = context.chapter()->program();
    return "\n\\htmlonly[block]<figure class=\"listing\"><figcaption>\\endhtmlonly\n" +
           source_link(file, part.first_line, escape_markdown(file)) +
           "\n\\htmlonly[block]</figcaption>\\endhtmlonly\n" + listing(part.code) +
           "\n\\htmlonly[block]</figure>\\endhtmlonly\n";
}

std::string compile_markdown(Context& context, const Directive& directive) {
    if (!directive.arguments.empty() || !directive.text.empty())
        throw std::invalid_argument{"{{compile}} takes nothing"};
    for (const std::string& line : split_lines(context.program)) {
        if (const std::string before = "//   c++ "; line.starts_with(before)) {
            std::string command = replace_all("c++ " + line.substr(before.size()), " chapters/", " \\\n    chapters/");
            return "\n```sh\n" + replace_all(command, " && ", " \\\n    && ") + "\n```\n";
        }
    }
    throw std::invalid_argument{"{{compile}}: no line of the program begins with \"//   c++ \""};
}

}  // namespace page
