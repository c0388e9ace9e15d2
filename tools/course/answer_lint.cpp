#include "answer_lint.hpp"

#include <algorithm>
#include <cstddef>
#include <regex>

#include "files.hpp"
#include "terminal.hpp"

namespace course {

namespace {

// The code with blanks in place of comments and quoted text; its lines stay where they are.
std::string without_comments(std::string code) {
    for (std::size_t i = 0; i < code.size(); ++i) {
        std::size_t end = i + 1;
        if (code.compare(i, 2, "//") == 0)
            end = code.find('\n', i);
        else if (code.compare(i, 2, "/*") == 0)
            end = code.find("*/", i + 2);
        else if (code[i] == '"')
            while (end < code.size() && code[end] != '"') end += code[end] == '\\' ? 2 : 1;
        else
            continue;
        for (end = std::min(end, code.size()); i < end; ++i)
            if (code[i] != '\n') code[i] = ' ';
        if (i + 1 < code.size() && code[i] == '*') code[i] = code[i + 1] = ' ';
        if (i < code.size() && code[i] == '"') code[i] = ' ';
    }
    return code;
}

bool is_numeral(const std::string& text) { return text.find_first_not_of("0123456789") == std::string::npos; }

}  // namespace

// "1 / 2", but not that of "x * 1 / 2", which divides x, nor of "1e-1 / 2"; and "1 / n" where n is given. What "n / 2"
// is meant to be nobody knows. The counts are bounded, as std::regex takes a stack frame for each letter.
std::string divided_whole_numbers(const std::string& code, const std::string& declaration) {
    static const std::regex quotient(
        R"(([.*/%]\s{0,9}|[eE][-+])?\b(\d{1,9})\s{0,9}/\s{0,9}([A-Za-z_]\w{0,40}|\d{1,9})(?![\w.(]))");
    const std::string plain = without_comments(code);
    for (std::sregex_iterator at(plain.begin(), plain.end(), quotient), end; at != end; ++at) {
        const std::string above = (*at)[2], below = (*at)[3];
        if ((*at)[1].matched) continue;
        const bool is_number = is_numeral(below);
        if (is_number && (std::stol(below) == 0 || std::stol(above) % std::stol(below) == 0)) continue;
        const bool is_given = std::regex_search(declaration, std::regex("\\bint " + below + "\\b"));
        if (!is_number && (!is_given || plain.find("double " + below) != std::string::npos)) continue;
        const auto line = 1 + std::count(plain.begin(), (*at)[2].first, '\n');
        const std::string is = is_number ? "is " + std::to_string(std::stol(above) / std::stol(below))
                                         : "has lost what is behind the point";
        return "Line " + std::to_string(line) + " divides whole numbers: in C++ " + above + " / " + below + " " + is +
               ". What you may want is " + above + ".0 / " + below + ".";
    }
    return {};
}

bool keeps_by_auto(const std::string& code) {
    static const std::regex kept(R"(\bauto(\s{1,9}&?|&)\s{0,9}\w{1,40}\s{0,9}=\s{0,9}[^\[\s])");
    return std::regex_search(without_comments(code), kept);
}

std::string answer_lint(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file) {
    constexpr std::size_t most = 1 << 16;  // a longer text takes seconds, and no learner writes it
    const std::string code = contents(file).substr(0, most),
                      divided = divided_whole_numbers(code, exercise.declaration);
    std::string text = divided.empty() ? "" : "\n" + wrapped(divided, 2);
    // What crashes, or is wrong for no known reason, where an expression of Eigen's may have been kept.
    if (exercise.eigen && !verdict.watched && verdict.diagnosis.empty() && keeps_by_auto(code))
        text +=
            "\n" + wrapped(
                       "With auto you may keep a sum or a product of Eigen's that is not worked out yet, and refers to "
                       "what is gone by then. ./course check " +
                           exercise.name + " --sanitize looks for that.",
                       2);
    return text;
}

}  // namespace course
