// A piece of a method's line, as the figures draw it, between words.

#include "directives.hpp"
#include "text.hpp"

#include <stdexcept>

namespace page {

std::string line_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) {
        throw std::invalid_argument{"{{line passive_gyroscopic}} takes one name out of tools/figures/style.gp"};
    }
    const std::string& name = directive.arguments[0];
    const std::filesystem::path style = context.root() / "tools/figures/style.gp";
    context.inputs.insert(style);
    for (const std::string& line : split_lines(read_file(style))) {  // name = "lc rgb '#123456' lw 2 dt 1"
        const std::vector<std::string> words = split_words(line);
        if (words.size() < 9 || words[0] != name || words[1] != "=" || words[2] != "\"lc" || words[7] != "dt") continue;
        const char* dashes = words[8] == "1\"" ? "solid" : "dashed";
        return "<span class=\"line\" style=\"border-top: 3px " + std::string{dashes} + " " + words[4].substr(1, 7) +
               "\"></span>";
    }
    throw std::out_of_range{"tools/figures/style.gp draws no line \"" + name + "\""};
}

}  // namespace page
