#include "uncallable_definition.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

namespace course {

namespace {

using Words = std::vector<std::string>;

// Words and signs, without comments, directives and what stands in quotation marks.
Words words_of(const std::string& code) {
    Words words;
    const auto is_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (std::size_t i = 0; i < code.size();) {
        const std::string two = code.substr(i, 2);
        if (std::isspace(static_cast<unsigned char>(code[i]))) {
            ++i;
        } else if (two == "//" || code[i] == '#') {
            i = std::min(code.find('\n', i), code.size());
        } else if (two == "/*") {
            const auto end = code.find("*/", i + 2);
            i = end == std::string::npos ? code.size() : end + 2;
        } else if (code[i] == '"' ||
                   (code[i] == '\'' && !words.empty() && !std::isdigit(static_cast<unsigned char>(words.back()[0])))) {
            const char quote = code[i++];
            for (; i < code.size() && code[i] != quote; ++i) i += code[i] == '\\';
            ++i;
            words.emplace_back("\"\"");
        } else {
            std::size_t end = i + 1;
            if (is_of_word(code[i]))
                while (end < code.size() && is_of_word(code[end])) ++end;
            words.push_back(code.substr(i, end - i));
            i = end;
        }
    }
    return words;
}

bool has(const Words& words, const std::string& one) {
    return std::find(words.begin(), words.end(), one) != words.end();
}

// Behind the bracket that closes the one at `i`.
std::size_t behind(const Words& words, std::size_t i) {
    int depth = 0;
    for (; i < words.size(); ++i) {
        depth += (words[i] == "(") - (words[i] == ")");
        if (depth == 0) return i + 1;
    }
    return i;
}

// What a brace opens, by the words before it.
struct Scope {
    std::string kind, name;  // "namespace", "class", "" for none of these, "function" for what may be one
};
Scope scope_of(const Words& before) {
    const auto follows = [&](const std::string& word) {
        const auto at = std::find(before.begin(), before.end(), word);
        std::string name;
        for (auto next = at == before.end() ? at : at + 1; next != before.end() && *next != ":"; ++next) name += *next;
        return name;
    };
    if (has(before, "namespace")) return {"namespace", follows("namespace")};
    if (has(before, "(")) return {"function", ""};
    for (const char* word : {"struct", "class", "union"})
        if (has(before, word)) return {"class", follows(word)};
    if (has(before, "extern")) return {"", ""};
    return {"function", ""};
}

// What is different, of a definition with these words before its name, its arguments, and the scopes that it stands in.
std::string difference(const Words& before, const Words& arguments, const std::vector<Scope>& scopes) {
    for (const Scope& scope : scopes) {
        if (scope.kind == "class")
            return "but as a part of " + scope.name +
                   ". The checker calls the function by its name alone: take it out of there.";
        if (scope.kind == "namespace")
            return "but in " +
                   (scope.name.empty() ? std::string("a namespace without a name") : "the namespace " + scope.name) +
                   ". The checker calls the one that is in no namespace: take it out of there.";
    }
    if (has(before, "template") || has(arguments, "auto"))
        return "but it is a template: the compiler makes no function of it until some code calls it. Write it with the "
               "types that are declared above.";
    if (has(before, "static"))
        return "but it is static: no other file can call it, and the checker is in another file. Leave out static.";
    for (const char* word : {"inline", "constexpr", "consteval"})
        if (has(before, word))
            return std::string("but it is ") + word +
                   ": the compiler makes no function of it that another file can call. Leave out " + word + ".";
    return {};
}

}  // namespace

std::string uncallable_definition(const std::string& code, const std::string& name) {
    const Words words = words_of(code);
    std::vector<Scope> scopes;
    Words before;  // since the last statement
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const bool in_function =
            std::any_of(scopes.begin(), scopes.end(), [](const Scope& scope) { return scope.kind == "function"; });
        if (word == name && !in_function && i + 1 < words.size() && words[i + 1] == "(") {
            const std::size_t end = behind(words, i + 1);
            std::size_t body = end;
            while (body < words.size() && words[body] != "{" && words[body] != ";") ++body;
            const Words arguments(words.begin() + static_cast<std::ptrdiff_t>(i),
                                  words.begin() + static_cast<std::ptrdiff_t>(end));
            const std::string why =
                body < words.size() && words[body] == "{" ? difference(before, arguments, scopes) : "";
            if (!why.empty()) return why;
        }
        if (word == "{")
            scopes.push_back(scope_of(before)), before.clear();
        else if (word == ";")
            before.clear();
        else if (word == "}")
            before.clear(), scopes.empty() ? void() : scopes.pop_back();
        else
            before.push_back(word);
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

}  // namespace course
