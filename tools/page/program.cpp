// The chapter's program on its page: woven in, every line once and in order, and then whole.

#include "program.hpp"

#include "directives.hpp"
#include "text.hpp"

#include <stdexcept>

namespace page {

std::vector<Part> parts_of(const std::string& source, const std::vector<std::string>& beginnings) {
    const std::vector<std::string> lines = split_lines(source);
    std::vector<std::size_t> starts;
    for (const std::string& words : beginnings) {
        std::size_t at = starts.empty() ? 0 : starts.back() + 1;
        while (at < lines.size() && !trim(lines[at]).starts_with(words)) {
            ++at;
        }
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
        for (std::size_t line = starts[i]; line < end; ++line) {
            part.code += lines[line] + "\n";
        }
        parts.push_back(part);
    }
    return parts;
}

namespace {

/// Code as one sees it: without the blank lines at its end.
std::string listing(const std::string& code) {
    return "\n```cpp\n" + code.substr(0, code.find_last_not_of('\n') + 1) + "\n```\n";
}

}  // namespace

std::string part_markdown(const Context& context, const Part& part) {
    return "\n\\htmlonly[block]<figure class=\"listing\"><figcaption>\\endhtmlonly\n" +
           source_link(context.chapter()->program(), part.first_line, escape_markdown(context.chapter()->program())) +
           "\n\\htmlonly[block]</figcaption>\\endhtmlonly\n" + listing(part.code) +
           "\n\\htmlonly[block]</figure>\\endhtmlonly\n";
}

std::string program_markdown(const std::string& source) {
    return "\n\\htmlonly[block]<details class=\"program\"><summary>The whole program</summary>\\endhtmlonly\n" +
           listing(source) + "\n\\htmlonly[block]</details>\\endhtmlonly\n";
}

std::string compile_markdown(const std::string& source, const Directive& directive) {
    if (!directive.arguments.empty() || !directive.text.empty()) {
        throw std::invalid_argument{"{{compile}} takes nothing"};
    }
    for (const std::string& line : split_lines(source)) {
        if (const std::string before = "//   c++ "; line.starts_with(before)) {
            std::string command = replace_all("c++ " + line.substr(before.size()), " chapters/", " \\\n    chapters/");
            return "\n```sh\n" + replace_all(command, " && ", " \\\n    && ") + "\n```\n";
        }
    }
    throw std::invalid_argument{"{{compile}}: no line of the program begins with \"//   c++ \""};
}

}  // namespace page
