#include "answer_lint.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>

#include "files.hpp"
#include "terminal.hpp"

namespace course {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '\''; }

// Blanks in place of comments.
std::string without_comments(std::string code) {
    for (std::size_t i = 0; i + 1 < code.size(); ++i) {
        if (code[i] != '/' || (code[i + 1] != '/' && code[i + 1] != '*')) continue;
        const bool is_line = code[i + 1] == '/';
        const auto end = std::min(code.find(is_line ? "\n" : "*/", i + 2), code.size());
        for (const auto last = std::min(is_line ? end : end + 2, code.size()); i < last; ++i)
            if (code[i] != '\n') code[i] = ' ';
        --i;
    }
    return code;
}

struct Quotient {
    std::ptrdiff_t line;
    std::string above, below;
};

// The first quotient of whole numbers that leaves a rest, or may leave one: "1 / 2", but not that of "x * 1 / 2", which
// divides x; and "1 / n" and "1 / (n - m)" where n and m are given by the exercise, and no other variables. What "n /
// 2" is meant to be nobody knows.
std::optional<Quotient> quotient_of_whole_numbers(const std::string& code, const std::string& declaration) {
    constexpr std::size_t most_digits = 9;
    const auto is_number = [](const std::string& text) {
        return !text.empty() && text.size() <= most_digits && std::all_of(text.begin(), text.end(), is_digit);
    };
    const auto is_given = [&](const std::string& text) {
        const auto place = declaration.find("int " + text);
        return !text.empty() && place != std::string::npos && !is_of_word(declaration[place + 4 + text.size()]) &&
               code.find("double " + text) == std::string::npos;
    };
    // Of what stands in brackets: is every word of it whole?
    const auto is_whole = [&](const std::string& text) {
        std::string word;
        bool all = true;
        for (const char c : text + ' ') {
            if (is_of_word(c))
                word += c;
            else if (!word.empty())
                all = all && (is_number(word) || is_given(word)), word.clear();
            all = all && (is_of_word(c) || is_blank(c) || c == '+' || c == '-' || c == '*' || c == '(' || c == ')');
        }
        return all;
    };
    const auto size = code.size();
    for (auto at = code.find('/'); at != std::string::npos; at = code.find('/', at + 1)) {
        auto end = at, next = at + 1;
        while (end > 0 && is_blank(code[end - 1])) --end;
        auto begin = end;
        while (begin > 0 && is_of_word(code[begin - 1])) --begin;
        while (next < size && is_blank(code[next])) ++next;
        auto last = next;
        while (last < size && is_of_word(code[last])) ++last;
        if (next < size && code[next] == '(') last = std::min(code.find(')', next), size - 1) + 1;
        const std::string above = code.substr(begin, end - begin), below = code.substr(next, last - next);
        if (!is_number(above) || below.empty() || !is_whole(below) || below == "1") continue;
        auto behind = begin;
        while (behind > 0 && is_blank(code[behind - 1])) --behind;
        const char before = behind > 0 ? code[behind - 1] : ' ';
        if (before == '*' || before == '/' || before == '%') continue;
        if (is_number(below) && (std::stol(below) == 0 || std::stol(above) % std::stol(below) == 0)) continue;
        return Quotient{1 + std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(begin), '\n'), above,
                        below};
    }
    return {};
}

// Is a value kept by `auto`: of what is no lambda, and no list of names?
bool keeps_by_auto(const std::string& code) {
    const std::string blanks = " \t\n";
    for (auto at = code.find("auto"); at != std::string::npos; at = code.find("auto", at + 1)) {
        const auto end = code.find_first_of("=;({[", at + 4);  // of the name, or of what has none
        if (end == std::string::npos || code[end] != '=') continue;
        const auto value = code.find_first_not_of(blanks, end + 1);
        if (value != std::string::npos && code[value] != '[') return true;
    }
    return false;
}

}  // namespace

std::string answer_lint(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file) {
    const std::string code = without_comments(contents(file));
    std::string text;
    if (const auto found = quotient_of_whole_numbers(code, exercise.declaration)) {
        const std::string is = is_digit(found->below[0])
                                   ? "is " + std::to_string(std::stol(found->above) / std::stol(found->below))
                                   : "has lost what is behind the point";
        text += "\n" + wrapped("Line " + std::to_string(found->line) + " divides whole numbers: in C++ " +
                                   found->above + " / " + found->below + " " + is + ". What you may want is " +
                                   found->above + ".0 / " + found->below + ".",
                               2);
    }
    // What crashes, or is wrong for no known reason, where an expression of Eigen's may have been kept.
    if (exercise.eigen && !verdict.watched && verdict.misconception.empty() && keeps_by_auto(code))
        text +=
            "\n" + wrapped(
                       "With auto you may keep a sum or a product of Eigen's that is not worked out yet, and refers to "
                       "what is gone by then. ./course check " +
                           exercise.name + " --sanitize looks for that.",
                       2);
    return text;
}

}  // namespace course
