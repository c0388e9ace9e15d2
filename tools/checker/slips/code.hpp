#pragma once
/// \file
/// The tokens of an answer's C++, as clang-format leaves it, with the bracket that belongs to each bracket.

#include <cctype>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>
#include <vector>

using Words = std::set<std::string>;

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
inline bool is_name(const std::string& text) { return !text.empty() && is_letter(text[0]); }
inline bool is_number(const std::string& text) { return !text.empty() && is_digit(text[0]); }
inline bool opens(const std::string& text) { return text == "(" || text == "[" || text == "{"; }
inline bool closes(const std::string& text) { return text == ")" || text == "]" || text == "}"; }
inline bool assigns(const std::string& text) {
    static const Words words{"=", "+=", "-=", "*=", "/=", "|=", "++", "--"};
    return words.count(text) > 0;
}

struct Token {
    std::string text;
    bool blank = false;         ///< stands before it
    std::string before, after;  ///< what is written round it
};

inline std::vector<Token> tokens_of(const std::string& code) {
    static const Words pairs{"::", "->", "<=", ">=", "==", "!=", "&&", "||",
                             "++", "--", "+=", "-=", "*=", "/=", "|=", "%="};
    std::vector<Token> tokens;
    bool blank = false;
    for (std::size_t i = 0; i < code.size();) {
        const auto at = [&](std::size_t j) { return j < code.size() ? code[j] : '\0'; };
        if (std::isspace(static_cast<unsigned char>(code[i]))) {
            blank = true, ++i;
            continue;
        }
        if (at(i) == '#' || (at(i) == '/' && at(i + 1) == '/')) {
            while (i < code.size() && code[i] != '\n') ++i;
            continue;
        }
        std::size_t end = i + 1;
        const auto in_word = [&](std::size_t j) { return is_letter(at(j)) || is_digit(at(j)); };
        if (in_word(i)) {
            const auto in_number = [&](std::size_t j) {
                return at(j) == '.' || at(j) == '\'' || ((at(j) == '-' || at(j) == '+') && at(j - 1) == 'e');
            };
            while (in_word(end) || (is_digit(code[i]) && in_number(end))) ++end;
        } else if (pairs.count(code.substr(i, 2))) {
            end = i + 2;
        }
        tokens.push_back({code.substr(i, end - i), blank, "", ""});
        blank = false;
        i = end;
    }
    return tokens;
}

class Code {
public:
    explicit Code(std::vector<Token> tokens) : t_(std::move(tokens)), other_(t_.size() + 3) {
        t_.resize(t_.size() + 3);  // so that there is always a next one
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < size(); ++i) {
            if (opens(text(i))) open.push_back(i);
            if (closes(text(i)) && !open.empty()) {
                other_[i] = open.back();
                other_[open.back()] = i;
                open.pop_back();
            }
        }
    }

    std::size_t size() const { return t_.size() - 3; }
    const std::string& text(std::size_t i) const { return t_[i].text; }
    bool blank(std::size_t i) const { return t_[i].blank; }  ///< Does a blank stand before it?
    std::size_t other(std::size_t bracket) const { return other_[bracket]; }

    void set(std::size_t i, const std::string& text) { t_[i].text = text; }
    void add_after(std::size_t i, const std::string& text) { t_[i].after += text; }
    void wrap(std::size_t first, std::size_t last, const std::string& before, const std::string& after) {
        t_[first].before = before + t_[first].before;
        t_[last].after += after;
    }
    void replace(std::size_t i, std::size_t count, const std::string& by) {
        for (std::size_t j = i; j < i + count; ++j) t_[j].text.clear();
        t_[i].text = by;
    }
    std::string rendered(std::size_t first, std::size_t end) const {
        std::string code;
        for (std::size_t i = first; i < end; ++i)
            code += (t_[i].blank ? " " : "") + t_[i].before + t_[i].text + t_[i].after;
        return code;
    }

    /// Do these tokens stand there?
    bool stands(std::size_t i, std::initializer_list<const char*> tokens) const {
        for (const char* each : tokens)
            if (i >= t_.size() || text(i++) != each) return false;
        return true;
    }
    bool operand_before(std::size_t i) const {
        if (i == 0) return false;
        const std::string& last = text(i - 1);
        if ((last == "--" || last == "++") && i > 1) return is_name(text(i - 2));
        return last != "return" && (is_name(last) || is_number(last) || last == ")" || last == "]");
    }
    /// The next of `ends` from i on, outside of brackets; or the bracket that closes round i.
    std::size_t until(std::size_t i, const Words& ends) const {
        for (; i < size(); ++i) {
            if (ends.count(text(i)) || closes(text(i))) return i;
            if (opens(text(i))) i = other_[i];
        }
        return i;
    }
    /// The bracket that opens round it.
    std::size_t scope_of(std::size_t i) const {
        while (i > 0 && !opens(text(--i)))
            if (closes(text(i))) i = other_[i];
        return i;
    }
    bool is_type(std::size_t i) const {
        static const Words types{"double", "int", "Vector3d", "Matrix3d", "Quaterniond"};
        return types.count(text(i)) && text(i - 1) != "<" && text(i + 1) != ">" && text(i + 1) != ",";
    }
    bool is_state(std::size_t i) const { return stands(i, {"State", "<", "double"}); }

private:
    std::vector<Token> t_;
    std::vector<std::size_t> other_;
};
