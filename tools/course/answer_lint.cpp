#include "answer_lint.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

#include "files.hpp"
#include "terminal.hpp"

namespace course {

namespace {

struct Token {
    std::string text;
    std::size_t place;  // in the code
};
using Tokens = std::vector<Token>;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Words, numerals and signs, without comments and directives; what stands in quotation marks is one token, "".
Tokens tokens_of(const std::string& code) {
    Tokens tokens;
    const auto behind = [&](const char* end, std::size_t from) {
        const auto at = code.find(end, from);
        return at == std::string::npos ? code.size() : at + std::string(end).size();
    };
    for (std::size_t i = 0; i < code.size();) {
        const std::size_t begin = i;
        const char c = code[i], next = i + 1 < code.size() ? code[i + 1] : ' ';
        if (std::isspace(static_cast<unsigned char>(c))) {
            ++i;
            continue;
        }
        if (c == '#' || (c == '/' && (next == '/' || next == '*'))) {
            i = behind(next == '*' && c == '/' ? "*/" : "\n", i + 2);
            continue;
        }
        ++i;
        if (c == '"' || c == '\'') {
            while (i < code.size() && code[i] != c) i += code[i] == '\\' ? 2 : 1;
            tokens.push_back({"\"\"", begin});
            ++i;
            continue;
        }
        const bool is_numeral = is_digit(c) || (c == '.' && is_digit(next));
        if (is_of_word(c) || is_numeral)
            while (i < code.size() && (is_of_word(code[i]) || (is_numeral && (code[i] == '.' || code[i] == '\'')))) ++i;
        tokens.push_back({code.substr(begin, i - begin), begin});
    }
    return tokens;
}

// Behind the bracket that closes the one at `i`.
std::size_t behind_brackets(const Tokens& tokens, std::size_t i) {
    int depth = 0;
    for (; i < tokens.size(); ++i) {
        depth += (tokens[i].text == "(") - (tokens[i].text == ")");
        if (depth == 0) return i + 1;
    }
    return i;
}

bool is_numeral(const std::string& text) {
    constexpr std::size_t most_digits = 9;
    return text.size() <= most_digits && std::all_of(text.begin(), text.end(), is_digit);
}

bool has(const Tokens& tokens, const std::string& word) {
    return std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) { return token.text == word; });
}

// What a brace opens, by the words before it.
struct Scope {
    enum { function, name_space, type, neither } kind;
    std::string name;
};
Scope scope_of(const Tokens& before) {
    const auto name_behind = [&](const char* word) {
        std::string name;
        auto at = std::find_if(before.begin(), before.end(), [&](const Token& token) { return token.text == word; });
        for (++at; at != before.end() && at->text != ":"; ++at) name += at->text;
        return name;
    };
    if (has(before, "namespace")) return {Scope::name_space, name_behind("namespace")};
    if (has(before, "(")) return {Scope::function, ""};
    for (const char* word : {"struct", "class", "union"})
        if (has(before, word)) return {Scope::type, name_behind(word)};
    return {has(before, "extern") ? Scope::neither : Scope::function, ""};
}

// What is different about a definition with these words before its name, its arguments, and the scopes that it stands
// in.
std::string difference(const Tokens& before, const Tokens& arguments, const std::vector<Scope>& scopes) {
    for (const Scope& scope : scopes) {
        if (scope.kind == Scope::type)
            return "but as a part of " + scope.name +
                   ". The checker calls the function by its name alone: take it out of there.";
        if (scope.kind == Scope::name_space)
            return "but in " + (scope.name.empty() ? "a namespace without a name" : "the namespace " + scope.name) +
                   ". The checker calls the one that is in no namespace: take it out of there.";
    }
    if (has(before, "template") || has(arguments, "auto"))
        return "but it is a template: the compiler makes no function of it until some code calls it. Write it with the "
               "types that are declared above.";
    if (has(before, "static"))
        return "but it is static: no other file can call it, and the checker is in another file. Leave out static.";
    for (const std::string word : {"inline", "constexpr", "consteval"})
        if (has(before, word))
            return "but it is " + word +
                   ": the compiler makes no function of it that another file can call. Leave out " + word + ".";
    return {};
}

}  // namespace

// "1 / 2", but not that of "x * 1 / 2", which divides x; and "1 / n" and "1 / (n - m)" where n and m are given, and no
// other variables. What "n / 2" is meant to be nobody knows.
std::string divided_whole_numbers(const std::string& code, const std::string& declaration) {
    const Tokens tokens = tokens_of(code), declared = tokens_of(declaration);
    const auto is_typed = [](const Tokens& where, const char* type, const std::string& name) {
        for (std::size_t i = 0; i + 1 < where.size(); ++i)
            if (where[i].text == type && where[i + 1].text == name) return true;
        return false;
    };
    const auto is_whole = [&](const std::string& text) {
        return is_numeral(text) || (is_typed(declared, "int", text) && !is_typed(tokens, "double", text));
    };
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
        const std::string &above = tokens[i - 1].text, &first = tokens[i + 1].text;
        if (tokens[i].text != "/" || !is_numeral(above)) continue;
        if (i > 1 && std::string("*/%").find(tokens[i - 2].text) != std::string::npos) continue;
        const std::size_t end = first == "(" ? behind_brackets(tokens, i + 1) : i + 2;
        bool all_whole = true;
        for (std::size_t j = i + 1; j < end; ++j)
            all_whole &= is_whole(tokens[j].text) ||
                         (first == "(" && std::string("()+-*").find(tokens[j].text) != std::string::npos);
        if (!all_whole) continue;
        if (is_numeral(first) && (std::stol(first) == 0 || std::stol(above) % std::stol(first) == 0)) continue;
        const std::size_t begin = tokens[i + 1].place;
        const std::string below = code.substr(begin, tokens[end - 1].place + tokens[end - 1].text.size() - begin);
        const auto line =
            1 + std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(tokens[i - 1].place), '\n');
        const std::string is = is_numeral(first) ? "is " + std::to_string(std::stol(above) / std::stol(first))
                                                 : "has lost what is behind the point";
        return "Line " + std::to_string(line) + " divides whole numbers: in C++ " + above + " / " + below + " " + is +
               ". What you may want is " + above + ".0 / " + below + ".";
    }
    return {};
}

bool keeps_by_auto(const std::string& code) {
    const Tokens tokens = tokens_of(code);
    for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
        const std::size_t name = i + (tokens[i + 1].text == "&" ? 2 : 1);
        if (tokens[i].text == "auto" && name + 2 < tokens.size() && tokens[name + 1].text == "=" &&
            tokens[name + 2].text != "[")
            return true;
    }
    return false;
}

std::string uncallable_definition(const std::string& code, const std::string& name) {
    const Tokens tokens = tokens_of(code);
    std::vector<Scope> scopes;
    Tokens before;  // since the last statement
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string& word = tokens[i].text;
        const bool in_function =
            std::any_of(scopes.begin(), scopes.end(), [](const Scope& scope) { return scope.kind == Scope::function; });
        if (word == name && !in_function && i + 1 < tokens.size() && tokens[i + 1].text == "(") {
            const auto at = [&](std::size_t j) { return tokens.begin() + static_cast<std::ptrdiff_t>(j); };
            const std::size_t end = behind_brackets(tokens, i + 1);
            const auto body = std::find_if(at(end), tokens.end(),
                                           [](const Token& token) { return token.text == "{" || token.text == ";"; });
            if (body != tokens.end() && body->text == "{")
                if (const std::string why = difference(before, {at(i), at(end)}, scopes); !why.empty()) return why;
        }
        if (word == "{")
            scopes.push_back(scope_of(before));
        else if (word == "}" && !scopes.empty())
            scopes.pop_back();
        if (word == "{" || word == ";" || word == "}")
            before.clear();
        else
            before.push_back(tokens[i]);
    }
    return {};
}

bool is_utf16(const std::string& text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    // Of letters every other byte is zero, and no other one.
    std::size_t zeros[2] = {0, 0};
    for (std::size_t i = 0; i < text.size(); ++i) zeros[i % 2] += text[i] == '\0';
    return text.size() >= 8 && std::max(zeros[0], zeros[1]) > 2 * text.size() / 5 &&
           std::min(zeros[0], zeros[1]) <= text.size() / 20;
}

std::string answer_lint(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file) {
    const std::string code = contents(file), divided = divided_whole_numbers(code, exercise.declaration);
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
