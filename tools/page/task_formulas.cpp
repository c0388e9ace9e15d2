// The formulas in the sentences of a task: `only omega h decides`.

#include "exercise.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>

namespace page {
namespace {

using Names = std::set<std::string>;

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A word between blanks, with the comma or full stop behind it.
struct Token {
    enum Kind { plain, sign, number, named } kind = plain;
    std::string text, behind;
};

/// Is it a name of mathematics here: a parameter, a Greek letter, `v2`, `omega2`, `s.x`, `sqrt`?
bool is_name(std::string name, const Names& names) {
    static const std::array<std::string_view, 11> known{"omega", "theta", "gamma", "beta", "zeta", "lambda",
                                                        "alpha", "sqrt",  "sin",   "cos",  "exp"};
    while (name.ends_with('\'')) name.pop_back();
    if (names.contains(name) || names.contains(name.substr(0, name.find('.')))) return true;
    const std::size_t end = name.find_first_of("0123456789");
    const std::string base = name.substr(0, end);
    if (end != std::string::npos && name.find_first_not_of("0123456789", end) != std::string::npos) return false;
    if (std::find(known.begin(), known.end(), base) != known.end()) return true;
    return base.size() == 1 &&
           (end != std::string::npos || std::string_view{"ABsNm"}.find(base) == std::string_view::npos);
}

/// Where `unit` may be a unit: "2 m", "in m", "kg m²".
bool is_unit(const std::string& unit, const std::string& before) {
    static const std::array<std::string_view, 8> units{"m", "m²", "s", "s²", "1/m", "1/s", "m/s", "m/s²"};
    if (std::find(units.begin(), units.end(), unit) == units.end()) return false;
    return unit.find('/') != std::string::npos || before == "in" || before == "kg" || before == "N" ||
           before == "per" || (!before.empty() && digit(before.back()));
}

bool is_function(const std::string& text) { return text == "sin" || text == "cos" || text == "exp" || text == "sqrt"; }

Token token_of(const std::string& word, const Token& before, const Names& names) {
    Token token;
    const std::size_t end = word.find_last_not_of(".,;:?!") + 1;
    token.text = word.substr(0, end), token.behind = word.substr(end);
    const std::string& text = token.text;
    static const std::array<std::string_view, 8> signs{"+", "-", "\u2212", "*", "/", "=", "<", ">"};
    if (std::find(signs.begin(), signs.end(), text) != signs.end() ||
        (text == "x" && before.kind == Token::named && before.behind.empty() && !is_function(before.text))) {
        token.kind = Token::sign;
        return token;
    }
    if (text.empty() || text == "i.e" || text == "e.g" || text.find("++") != std::string::npos ||
        is_unit(text, before.text))
        return token;
    // A letter that is a unit or a word elsewhere: a power of it, or behind a sign, it is a name.
    if (text == "s²" || text == "m²" ||
        (text.size() == 1 && letter(text[0]) && before.kind == Token::sign && before.behind.empty())) {
        token.kind = Token::named;
        return token;
    }
    bool all_named = true, any = false;
    for (std::size_t at = 0; at < text.size();) {
        if (letter(text[at]) || text[at] == '_') {
            const std::size_t begin = at;
            while (at < text.size() && (letter(text[at]) || digit(text[at]) || text[at] == '_' || text[at] == '\'' ||
                                        (text[at] == '.' && at + 1 < text.size() && letter(text[at + 1]))))
                ++at;
            all_named = all_named && is_name(text.substr(begin, at - begin), names) &&
                        (begin == 0 || !digit(text[begin - 1]) || text[begin] != 'e');
            any = true;
        } else if (const std::string_view rest = std::string_view{text}.substr(at);
                   rest.starts_with("²") || rest.starts_with("³")) {
            at += 2;
        } else if (rest.starts_with("\u2212")) {
            at += 3;
        } else if (digit(text[at]) || std::string_view{"()+-*/=<>|.^[],"}.find(text[at]) != std::string_view::npos) {
            ++at;
        } else {
            return token;
        }
    }
    token.kind = !any ? Token::number : all_named && text.find("::") == std::string::npos ? Token::named : Token::plain;
    return token;
}

/// The end of a list of components that token `i` begins, "State<double>{t" or "Quaterniond(w": `i` where none begins,
/// or none ends in this sentence.
std::size_t end_of_list(const std::vector<Token>& tokens, std::size_t i) {
    const std::string& first = tokens[i].text;
    const std::size_t open = first.find_first_of("{(");
    const bool begins = tokens[i].kind == Token::plain && open != std::string::npos &&
                        (first[open] == '{' || (open > 1 && letter(first[open - 1])));
    int depth = 0;
    bool parted = false;
    for (std::size_t end = i; begins && end < tokens.size(); ++end) {
        for (const char c : tokens[end].text) depth += (c == '{' || c == '(') - (c == '}' || c == ')');
        if (depth == 0) return parted ? end + 1 : i;
        if (tokens[end].behind != "," && tokens[end].behind != "") return i;
        parted = parted || tokens[end].behind == ",";
    }
    return i;
}

int depth_of(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '(') - std::count(text.begin(), text.end(), ')'));
}

/// `h` is a formula, `state` a word.
bool is_word(const std::string& text) {
    static const std::array<std::string_view, 7> greek{"omega", "theta", "gamma", "beta", "zeta", "lambda", "alpha"};
    return std::all_of(text.begin(), text.end(), letter) && !is_function(text) &&
           (text == "a" || text == "I" ||
            (text.size() > 1 && std::find(greek.begin(), greek.end(), text) == greek.end()));
}

bool is_code(const std::string& text) {
    if (text.find('_') != std::string::npos &&
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos)
        return true;  // `most_steps`
    const std::size_t dot = text.find('.');
    return text.find("()") != std::string::npos || text.find(" * ") != std::string::npos ||
           text.find('[') != std::string::npos ||
           (dot != std::string::npos && dot > 0 && letter(text[dot - 1]) && dot + 1 < text.size() &&
            letter(text[dot + 1]));
}

}  // namespace

std::set<std::string> names_in(const std::string& declaration) {
    std::set<std::string> names;
    int brackets = 0;
    std::string word;
    for (const char c : declaration.substr(declaration.find('(') + 1)) {
        brackets += (c == '<') - (c == '>');
        if ((c == ',' && brackets == 0) || c == ')') {
            if (!word.empty()) names.insert(word);
            word.clear();
        } else {
            word = letter(c) || digit(c) || c == '_' ? word + c : "";
        }
    }
    return names;
}

std::string with_formulas(const std::string& sentence, const std::set<std::string>& names) {
    std::vector<Token> tokens;
    for (const std::string& word : split_words(sentence))
        tokens.push_back(token_of(word, tokens.empty() ? Token{} : tokens.back(), names));
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i)  // "a share" of a word is no product
        if (tokens[i].text == "a" && is_word(tokens[i + 1].text)) tokens[i].kind = Token::plain;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool last = i + 1 == tokens.size();
        // "length of the step, s (above zero)": a unit, though a parameter may have that name.
        if (i > 0 && tokens[i - 1].behind == "," && (tokens[i].text == "s" || tokens[i].text == "m") &&
            (last || tokens[i + 1].text.starts_with('(')))
            tokens[i].kind = Token::plain;
        // "A x = b" is a product, "A body" is not.
        if (tokens[i].text == "A" && tokens[i].behind.empty() && i + 2 < tokens.size() &&
            tokens[i + 1].kind == Token::named && tokens[i + 2].kind == Token::sign)
            tokens[i].kind = Token::named;
    }
    std::string text;
    const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : " ") + more; };
    for (std::size_t i = 0; i < tokens.size();) {
        if (const std::size_t end = end_of_list(tokens, i); end > i) {
            std::string list;
            for (; i < end; ++i)
                list += (list.empty() ? "" : " ") + tokens[i].text + (i + 1 < end ? tokens[i].behind : "");
            add("`" + list + "`" + escape_markdown(tokens[end - 1].behind));
            continue;
        }
        // As far as a formula may go: over a comma within its brackets alone, and not from a name to a bare number.
        std::size_t end = i;
        std::string formula;
        while (end < tokens.size() && tokens[end].kind != Token::plain) {
            if (end > i && tokens[end - 1].text == "1" && is_word(tokens[end].text)) break;
            if (tokens[end].kind == Token::number && end > i && tokens[end - 1].kind != Token::sign &&
                tokens[end - 1].behind.empty())
                break;
            formula += (end == i ? "" : " ") + tokens[end].text;
            if (++end; !tokens[end - 1].behind.empty()) {
                if (tokens[end - 1].behind != "," || depth_of(formula) <= 0) break;
                formula += ",";
            }
        }
        const auto has = [&](const auto& what) {
            return std::any_of(tokens.begin() + static_cast<std::ptrdiff_t>(i),
                               tokens.begin() + static_cast<std::ptrdiff_t>(end), what);
        };
        const bool any = has([](const Token& t) { return t.kind == Token::named; });
        const bool words = has([](const Token& t) { return is_word(t.text); }) &&
                           !has([](const Token& t) { return t.kind == Token::sign || t.kind == Token::number; });
        const bool whole = any && !words && end > i && depth_of(formula) == 0 &&
                           formula.find(')') >= formula.find('(') &&
                           std::count(formula.begin(), formula.end(), '|') % 2 == 0;
        if (!whole || tokens[end - 1].kind == Token::sign || (tokens[i].kind == Token::sign && tokens[i].text != "-")) {
            add(escape_markdown(tokens[i].text + tokens[i].behind));
            ++i;
            continue;
        }
        add((is_code(formula) ? "`" + formula + "`" : "\\f$" + formula_tex(formula) + "\\f$") +
            escape_markdown(tokens[end - 1].behind));
        i = end;
    }
    return text;
}

}  // namespace page
