// A formula as it stands in a comment, as TeX.

#include "exercise.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace page {
namespace {

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A name: `omega2`, `x_above`, `L.x`, `inertia.x()`, `up'`; or a word of English.
std::string name_tex(std::string name) {
    static const std::array<std::string, 7> greek{"omega", "theta", "gamma", "beta", "zeta", "lambda", "alpha"},
        words{"of", "sum", "with", "force", "all", "and", "for"};
    const auto in = [](const auto& list, const std::string& word) {
        return std::find(list.begin(), list.end(), word) != list.end();
    };
    if (in(words, name)) {
        return "\\text{ " + name + " }";
    }
    name = replace_all(name, "()", "");
    std::string base, index;
    std::size_t at = 0;
    while (at < name.size() && letter(name[at])) {
        base += name[at++];
    }
    for (; at < name.size() && name[at] != '\''; ++at) {
        index += name[at] == '_' || name[at] == '.' ? "" : std::string{name[at]};
    }
    static const std::array<std::string, 3> functions{"sin", "cos", "exp"};
    const std::string set = in(greek, base) || in(functions, base) ? "\\" + base
                            : base.size() > 1                      ? "\\mathit{" + base + "}"
                                                                   : base;
    return set +
           (index.empty() ? ""
                          : "_{" + (index.size() > 1 && letter(index[0]) ? "\\text{" + index + "}" : index) + "}") +
           name.substr(at);
}

}  // namespace

std::string formula_tex(const std::string& plain) {
    std::string tex;
    const std::size_t size = plain.size();
    bool operand = false;  // does one stand before?
    for (std::size_t at = 0; at < size;) {
        const char c = plain[at];
        std::size_t end = at + 1;
        if (c == ' ') {
            end = std::min(plain.find_first_not_of(' ', at), size);
            const bool goes_on = end < size && operand && (letter(plain[end]) || plain[end] == '(');
            tex += end - at > 1 ? "\\quad " : goes_on ? "\\," : "";
        } else if (letter(c)) {
            while (end < size && (letter(plain[end]) || digit(plain[end]) || plain[end] == '_' || plain[end] == '\'' ||
                                  (plain[end] == '.' && end + 1 < size && letter(plain[end + 1])) ||
                                  plain.compare(end, 2, "()") == 0 || plain.compare(end - 1, 2, "()") == 0)) {
                ++end;
            }
            const std::string name = plain.substr(at, end - at);
            const bool cross = name == "x" && operand && at > 0 && plain[at - 1] == ' ' && end + 1 < size &&
                               plain[end] == ' ' && (letter(plain[end + 1]) || plain[end + 1] == '(');
            const std::size_t close = plain.find(')', end);
            if (name == "sqrt" && plain.compare(end, 1, "(") == 0 && close != std::string::npos) {
                tex += "\\sqrt{" + formula_tex(plain.substr(end + 1, close - end - 1)) + "}";
                end = close + 1;
            } else {
                tex += cross ? "\\times " : name_tex(name);
            }
            operand = !cross;
        } else if (plain.compare(at, 2, "²") == 0) {
            tex += "^2";
            end = at + 2;
        } else if (plain.compare(at, 2, "³") == 0) {
            tex += "^3";
            end = at + 2;
        } else if (c == '^' && end < size) {  // to a power: what stands in brackets, a name or a number
            const std::size_t close = plain.find(')', end), last = plain.find_first_of(" )/*,", end);
            const bool brackets = plain[end] == '(' && close != std::string::npos;
            const std::string power = brackets ? plain.substr(end + 1, close - end - 1) : plain.substr(end, last - end);
            tex += "^{" + formula_tex(power) + "}";
            end = brackets ? close + 1 : std::min(last, size);
        } else {
            tex += c == '|' ? "\\vert " : c == '*' ? "\\," : std::string{c};
            operand = digit(c) || c == ')';
        }
        at = end;
    }
    return replace_all(replace_all(tex, "\\,\\times", "\\times"), "\\times \\,", "\\times ");
}

}  // namespace page
