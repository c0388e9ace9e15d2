// A piece of a method's line, as the figures draw it, between words.

#include "directives.hpp"
#include "text.hpp"

#include <regex>
#include <stdexcept>

namespace page {

std::string line_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) {
        throw std::invalid_argument{"{{line passive_gyroscopic}} takes one name out of tools/figures/style.gp"};
    }
    const std::string& name = directive.arguments[0];
    const std::filesystem::path style = context.root() / "tools/figures/style.gp";
    context.inputs.insert(style);
    static const std::regex entry{"(\\w+) *= \"lc rgb '(#[0-9a-f]{6})' lw [0-9.]+ dt ([^\"]+)\""};
    const std::string text = read_file(style);
    for (std::sregex_iterator each{text.begin(), text.end(), entry}, end; each != end; ++each) {
        if ((*each)[1] == name) {
            const char* dashes = (*each)[3] == "1" ? "solid" : "dashed";
            return "<span class=\"line\" style=\"border-top: 3px " + std::string{dashes} + " " + (*each)[2].str() + "\"></span>";
        }
    }
    throw std::out_of_range{"tools/figures/style.gp draws no line \"" + name + "\""};
}

}  // namespace page
