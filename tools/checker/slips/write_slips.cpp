// Rewrites right answers so that they can slip (slip.hpp):
//
//     write_slips NAME OUT FILE…
//
// FILE… are the solution, and right answers that are written differently, each in a namespace of its own. They are
// C++ as clang-format leaves it: an operator with two operands stands between blanks, any other one does not. A file
// with the words "[no slips]" is left out: for what this cannot read.

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

struct Token {
    std::string text;
    bool blank = false;  // before it
    std::string before, after;
};

using Words = std::set<std::string>;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_name(const std::string& text) { return !text.empty() && is_letter(text[0]); }
bool is_number(const std::string& text) { return !text.empty() && is_digit(text[0]); }
bool opens(const std::string& text) { return text == "(" || text == "[" || text == "{"; }
bool closes(const std::string& text) { return text == ")" || text == "]" || text == "}"; }
bool assigns(const std::string& text) {
    static const Words words{"=", "+=", "-=", "*=", "/=", "|=", "++", "--"};
    return words.count(text) > 0;
}

std::vector<Token> tokens_of(const std::string& code) {
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

struct Variable {
    std::string name, type;
    std::size_t from, to;  // where it can be used
    bool bound;            // by a structured binding: no lambda has it
};

class Rewriter {
public:
    Rewriter(std::string name, std::vector<Token> tokens, int& site)
        : name_(std::move(name)), t_(std::move(tokens)), site_(site) {
        t_.push_back({});  // so that there is always a next one
        t_.push_back({});
        t_.push_back({});
        match();
    }

    std::string rewritten() {
        for (std::size_t i = 0; i + 3 < t_.size(); ++i)
            if (depth_[i] == 0 && text(i) == "{" && i > 0 && text(i - 1) == ")") function(other_[i - 1], i);
        std::string code;
        for (const Token& token : t_) {
            if (token.blank) code += ' ';
            code += token.before + token.text + token.after;
            if (token.text == ";" || token.text == "{" || token.text == "}") code += '\n';
        }
        return code;
    }

    // What does not slip safely, or costs more to compile than it is worth.
    bool is_left_out() const {
        static const Words words{"sort",      "inverse", "colPivHouseholderQr", "fullPivLu", "eigenvalues",
                                 "remainder", "pair"};
        bool seen = false;
        for (std::size_t i = 0; i + 3 < t_.size(); ++i) {
            if (words.count(text(i))) return true;
            if (text(i) == name_ && seen) return true;  // it calls itself
            if (text(i) == "*" && !t_[i].blank && is_name(text(i - 1)) && t_[i + 1].blank)
                return true;                                                                    // pointers know no end
            if (text(i) == "begin" && (text(i + 3) == "+" || text(i + 3) == "-")) return true;  // nor do these
            seen |= text(i) == name_;
        }
        return false;
    }

private:
    const std::string& text(std::size_t i) const { return t_[i].text; }
    bool operand_before(std::size_t i) const {
        if (i == 0) return false;
        const std::string& last = text(i - 1);
        if ((last == "--" || last == "++") && i > 1) return is_name(text(i - 2));
        return last != "return" && (is_name(last) || is_number(last) || last == ")" || last == "]");
    }
    // Do these tokens stand there?
    bool stands(std::size_t i, std::initializer_list<const char*> tokens) const {
        for (const char* each : tokens)
            if (i >= t_.size() || text(i++) != each) return false;
        return true;
    }
    void replace(std::size_t i, std::size_t count, const std::string& by) {
        for (std::size_t j = i; j < i + count; ++j) t_[j].text.clear();
        t_[i].text = by;
    }
    bool between_blanks(std::size_t i) const { return t_[i].blank && t_[i + 1].blank; }
    std::string next() { return std::to_string(site_++); }
    void wrap(std::size_t first, std::size_t last, const std::string& before, const std::string& after) {
        t_[first].before = before + t_[first].before;
        t_[last].after += after;
    }

    // The other bracket of each, and how many braces stand round it.
    void match() {
        other_.assign(t_.size(), 0);
        depth_.assign(t_.size(), 0);
        std::vector<std::size_t> open;
        int depth = 0;
        for (std::size_t i = 0; i < t_.size(); ++i) {
            const std::string& it = text(i);
            if (it == "}") --depth;
            depth_[i] = depth;
            if (opens(it)) open.push_back(i);
            if (closes(it) && !open.empty()) {
                other_[i] = open.back();
                other_[open.back()] = i;
                open.pop_back();
            }
            if (it == "{") ++depth;
        }
    }

    // The next of `ends` from i on, outside of brackets; or the bracket that closes round i.
    std::size_t until(std::size_t i, const Words& ends) const {
        for (; i + 3 < t_.size(); ++i) {
            const std::string& it = text(i);
            if (ends.count(it) || closes(it)) return i;
            if (opens(it)) i = other_[i];
        }
        return i;
    }

    bool is_type(std::size_t i) const {
        static const Words types{"double", "int", "Vector3d", "Matrix3d", "Quaterniond"};
        return types.count(text(i)) && text(i - 1) != "<" && text(i + 1) != ">" && text(i + 1) != ",";
    }
    bool is_state(std::size_t i) const { return stands(i, {"State", "<", "double"}); }

    void function(std::size_t open, std::size_t body) {
        begin_ = body, end_ = other_[body];
        find_lambdas();
        find_variables(open);
        const bool is_answer = text(open - 1) == name_;
        std::string entry;
        if (is_answer) {
            for (std::size_t i = open; i < other_[open]; ++i)  // its own, to exchange
                if ((text(i) == "const" || text(i) == "&")) t_[i].text.clear();
            const auto exchange = [&](const std::string& a, const std::string& b) {
                entry += " slip::exchange(" + next() + ", " + a + ", " + b + ");";
            };
            for (std::size_t a = 0; a < arguments_; ++a)
                for (std::size_t b = a + 1; b < arguments_; ++b)
                    if (variables_[a].type == variables_[b].type) exchange(variables_[a].name, variables_[b].name);
            for (std::size_t a = 0; a < arguments_; ++a) {
                const auto& [name, type, from, to, bound] = variables_[a];
                if (type == "double") entry += " slip::given(" + next() + ", " + name + ");";
                if (type == "State") exchange(name + ".x", name + ".v");
            }
        }
        picks();
        operators();  // before anything else is taken for another word
        subscripts();
        methods();
        calls();
        brackets();
        added();
        conditions();
        loops();
        lines();
        t_[body].after += entry;
    }

    void find_lambdas() {
        lambdas_.clear();
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) != "[" || operand_before(i) || text(i - 1) == "auto") continue;
            const std::size_t close = other_[i];
            std::size_t body = other_[close + 1];
            while (text(body) != "{") ++body;
            lambdas_.push_back({close + 1, body, close > i + 1});
            for (std::size_t j = close + 2; j < other_[close + 1]; ++j)  // an argument that it changes is what it is
                if (text(j) == "&" && text(j - 2) != "const" && text(i - 1) == "=") changing_.insert(text(i - 2));
        }
    }

    void find_variables(std::size_t open) {
        variables_.clear();
        for (std::size_t i = open + 1; i < other_[open]; ++i)
            if (text(i + 1) == "," || text(i + 1) == ")") {
                std::size_t type = i - 1;
                if (text(type) == "&") --type;
                const bool state = text(type) == ">" && is_state(type - 3);
                if (is_name(text(i)) && (state || is_type(type)))
                    variables_.push_back({text(i), state ? "State" : text(type), begin_, end_, false});
            }
        arguments_ = variables_.size();
        for (std::size_t i = begin_; i < end_; ++i) {
            if (!is_type(i) && text(i) != "auto" && !is_state(i)) continue;
            std::size_t name = i + (is_state(i) ? 4 : 1);
            if (text(name) == "&") ++name;
            const std::size_t scope = scope_of(i);
            if (text(i) == "auto" && text(name) == "[") {
                for (std::size_t j = name + 1; j < other_[name]; ++j)
                    if (is_name(text(j)))
                        variables_.push_back({text(j), "double", until(name, {";"}), other_[scope], true});
                continue;
            }
            if (text(i) == "auto" || !is_name(text(name))) continue;
            const std::string type = is_state(i) ? "State" : text(i);
            if (text(scope) == "{") {
                const std::size_t end = until(name, {";"});
                if (text(name + 1) != "=") continue;
                while (name < end) {
                    variables_.push_back({text(name), type, end, other_[scope], false});
                    declared_.insert(name);
                    name = until(name, {",", ";"});
                    if (text(name) == ",") ++name;
                }
            } else {
                declared_.insert(name);
                for (const Lambda& lambda : lambdas_)
                    if (lambda.open == scope)
                        variables_.push_back({text(name), type, lambda.body, other_[lambda.body], false});
            }
        }
    }
    // The bracket that opens round it.
    std::size_t scope_of(std::size_t i) const {
        while (i > begin_ && !opens(text(--i)))
            if (closes(text(i))) i = other_[i];
        return i;
    }

    bool is_visible(const Variable& variable, std::size_t i) const {
        if (i <= variable.from || i >= variable.to) return false;
        for (const Lambda& lambda : lambdas_)
            if (i > lambda.body && i < other_[lambda.body] && variable.from < lambda.body &&
                (!lambda.captures || variable.bound))
                return false;
        return true;
    }
    // The innermost variable of that name.
    const Variable* variable_named(const std::string& name, std::size_t i) const {
        const Variable* found = nullptr;
        for (const Variable& each : variables_)
            if (each.name == name && is_visible(each, i)) found = &each;
        return found;
    }

    void picks() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (!is_name(text(i)) || declared_.count(i)) continue;
            const std::string last = text(i - 1), following = text(i + 1);
            static const Words not_behind{".", "->", "::", "++", "--", "&", ">"}, not_before{"(", "[", "{", "::"};
            if (not_behind.count(last) || not_before.count(following) || assigns(following)) continue;
            const Variable* variable = variable_named(text(i), i);
            if (!variable || scope_is_capture(i) || changing_.count(text(scope_of(i) - 1))) continue;
            std::size_t end = i;
            std::string type = variable->type, tail;
            if (following == ".") {
                const std::string member = text(i + 2);
                if (type == "State") {
                    end = i + 2, type = "double", tail = "." + member;
                } else if (type == "Vector3d" && (member == "x" || member == "y" || member == "z")) {
                    end = i + 4, type = "double", tail = "." + member + "()";
                }
                const std::size_t behind = until(i, {"=", ";", ",", "+=", "-="});
                if (assigns(text(end + 1)) || (end == i && text(behind) == "=")) continue;
            } else if (type == "State") {
                continue;
            }
            const std::size_t closes = until(end + 1, {});
            if (text(closes) == ")" && text(closes + 1) == "=") continue;  // (a ? b : c) = …
            std::string others;
            int count = 0;
            const auto add = [&](const std::string& other) {
                if (count < 6) others += ", " + other, ++count;
            };
            if (!tail.empty())
                for (const char* each : {"x", "y", "z", "v"}) {
                    const bool state = variable->type == "State";
                    const std::string other = std::string(".") + each + (state ? "" : "()");
                    if (other != tail && (state ? *each == 'x' || *each == 'v' : *each != 'v'))
                        add(variable->name + other);
                }
            // The nearest first: what is taken for another is most often that.
            for (std::size_t v = variables_.size(); v-- > 0;) {
                const Variable& each = variables_[v];
                if (each.name != variable->name && each.type == type && variable_named(each.name, i) == &each)
                    add(each.name);
            }
            if (count > 0) wrap(i, end, "slip::pick(" + next() + ", ", others + ")");
            i = end;
        }
    }
    bool scope_is_capture(std::size_t i) const {
        const std::size_t open = scope_of(i);
        return text(open) == "[" && !operand_before(open);
    }

    // What is asked for its elements, or its last one.
    void subscripts() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (!is_name(text(i)) || text(i - 1) == "." || text(i - 1) == "::" || text(i) == "auto" ||
                text(i) == "return")
                continue;
            const bool end =
                text(i + 1) == "." && (text(i + 2) == "back" || text(i + 2) == "front") && text(i + 3) == "(";
            if (end || (text(i + 1) == "[" && !t_[i + 1].blank)) t_[i].text = "slip::in(" + text(i) + ")";
        }
    }

    // The first token of what stands before the point at i.
    std::size_t begin_of_operand(std::size_t i) const {
        for (;;) {
            --i;
            if (text(i) == ")" || text(i) == "]") {
                i = other_[i];
                if (is_name(text(i - 1)) || text(i - 1) == ")" || text(i - 1) == "]") continue;
                return i;
            }
            if (text(i - 1) != "." && text(i - 1) != "::") return i;
            --i;
        }
    }

    void methods() {
        static const Words known{"norm", "squaredNorm", "normalized", "conjugate"};
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) != "." || !known.count(text(i + 1)) || !stands(i + 2, {"(", ")"}) || text(i + 4) == ".")
                continue;
            const std::size_t first = begin_of_operand(i);
            if (text(first - 1).rfind("slip::Negative", 0) == 0) continue;  // binds less
            replace(i, 4, "->*slip::" + text(i + 1) + "{" + next() + "}");
        }
    }

    void calls() {
        static const Words known{"sin",  "cos",  "sqrt", "exp",   "log",  "log1p", "expm1", "exp2", "log2",
                                 "cbrt", "fabs", "abs",  "floor", "ceil", "pow",   "max",   "min",  "clamp"};
        for (std::size_t i = begin_; i < end_; ++i) {
            if (stands(i, {"std", "::", "numbers", "::", "pi"})) {
                replace(i, 5, "slip::pi()");
            } else if (text(i) == "std" && known.count(text(i + 2)) && text(i + 3) == "(") {
                t_[i].text = "slip";
                t_[i + 3].after += next() + ", ";
            } else if (text(i) == "AngleAxisd" && (text(i + 1) == "(" || text(i + 2) == "(")) {
                const std::size_t open = text(i + 1) == "(" ? i + 1 : i + 2, comma = until(open + 1, {","});
                if (text(comma) == ",") wrap(open + 1, comma - 1, "slip::angle(", ")");
            }
        }
    }

    void operators() {
        static const std::map<std::string, std::string> names{{"+", "Plus"},    {"-", "Minus"}, {"*", "Times"},
                                                              {"/", "Over"},    {"%", "Rest"},  {"<", "Less"},
                                                              {"<=", "AtMost"}, {">", "More"},  {">=", "AtLeast"}};
        for (std::size_t i = begin_; i < end_; ++i) {
            const auto name = names.find(text(i));
            if (name == names.end()) continue;
            if (between_blanks(i) && operand_before(i)) {
                t_[i].text += " slip::" + name->second + "{" + next() + "} " + text(i);
            } else if (text(i) == "-" && !operand_before(i) && !is_number(text(i + 1))) {
                t_[i].text = "slip::Negative{" + next() + "}->*";
            }
        }
    }

    void added() {
        for (std::size_t i = begin_; i < end_; ++i)
            if (text(i) == "+=" || text(i) == "-=")
                wrap(i + 1, until(i + 1, {";", ","}) - 1, "slip::added(" + next() + ", ", ")");
    }

    // Of `a || b` and `a && b` each part can be left out; alone it is a guard that can.
    void parts_of(std::size_t first, std::size_t end, bool alone) {
        std::size_t part = first;
        std::string joined;
        std::vector<std::size_t> joints;
        for (;;) {
            const std::size_t stop = std::min(end, until(part, {"||", "&&", "?", ":"}));
            if (stop < end && (text(stop) == "?" || text(stop) == ":")) return;
            const bool last = stop >= end;
            if (!last) joined = text(stop);
            if (joined.empty() && !alone) return;
            wrap(part, stop - 1,
                 std::string("(slip::without(") + next() + ") ? " + (joined == "&&" ? "true" : "false") + " : bool(",
                 "))");
            if (last) break;
            joints.push_back(stop);
            part = stop + 1;
        }
        // All of it once more, with the other word between its parts.
        const auto is_joined = [&](std::size_t i) { return text(i) == joined; };
        if (joints.empty() || !std::all_of(joints.begin(), joints.end(), is_joined)) return;
        for (const std::size_t i : joints) t_[i].text = joined == "&&" ? "||" : "&&";
        const std::string other = rendered(first, end);
        for (const std::size_t i : joints) t_[i].text = joined;
        wrap(first, end - 1, "(slip::joined(" + next() + ") ? bool(" + other + ") : bool(", "))");
    }

    std::string rendered(std::size_t first, std::size_t end) const {
        std::string code;
        for (std::size_t i = first; i < end; ++i)
            code += (t_[i].blank ? " " : "") + t_[i].before + t_[i].text + t_[i].after;
        return code;
    }

    // An expression once more, without the brackets of a sum in it that is multiplied or divided. Of numbers alone:
    // what else there is may have no such sum.
    void brackets() {
        static const Words delimiters{"=", "return", ",",  ";",  "(",  "[",  "{",  "}",  "?",  ":",  "<",
                                      ">", "<=",     ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/="};
        static const Words no_numbers{"Vector3d", "Matrix3d", "Quaterniond", "complex"};
        for (std::size_t i = begin_; i < end_; ++i)
            if (no_numbers.count(text(i))) return;
        std::map<std::size_t, std::vector<std::string>> others;  // of the expressions that begin there
        std::map<std::size_t, std::size_t> ends;
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) != "(" || operand_before(i) || text(i - 1) == "]") continue;
            const std::size_t open = i, close = other_[open];
            const auto multiplies = [&](std::size_t j) { return is_operator(j, '*') || is_operator(j, '/'); };
            if (!multiplies(open - 1) && !multiplies(close + 1)) continue;
            bool is_sum = false;
            for (std::size_t j = open + 1; j < close; ++j) {
                if (opens(text(j))) j = other_[j];
                is_sum |= is_operator(j, '+') || is_operator(j, '-');
                if (delimiters.count(text(j)) && text(j) != "]") {
                    is_sum = false;
                    break;
                }
            }
            if (!is_sum) continue;
            std::size_t first = open;
            while (first > begin_ + 1 && !delimiters.count(text(first - 1))) {
                --first;
                if (text(first) == ")" || text(first) == "]") first = other_[first];
            }
            const std::size_t end = until(open, {",", ";", "?", ":", "<", ">", "<=", ">=", "==", "!=", "&&", "||"});
            t_[open].text = " ", t_[close].text = " ";
            if (others[first].size() < 3)
                others[first].push_back("(slip::unbracketed(" + next() + ") ? " + rendered(first, end) + " : ");
            t_[open].text = "(", t_[close].text = ")";
            ends[first] = end;
        }
        for (const auto& [first, all] : others) {
            std::string before, after;
            for (const std::string& other : all) before += other, after += ")";
            wrap(first, ends[first] - 1, before + "(", ")" + after);
        }
    }
    // As operators() has written it.
    bool is_operator(std::size_t i, char which) const {
        return text(i).size() > 1 && text(i)[0] == which && text(i).compare(1, 7, " slip::") == 0;
    }
    void conditions() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) == "if" && text(i + 1) == "(") parts_of(i + 2, other_[i + 1], true);
            if (text(i) == "return") parts_of(i + 1, until(i + 1, {";"}), false);
        }
    }

    void loops() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) == "while" && text(i + 1) == "(") wrap(i + 2, other_[i + 1] - 1, "slip::turn() && (", ")");
            if (text(i) != "for") continue;
            const std::size_t close = other_[i + 1], first = until(i + 2, {";", ":"});
            if (text(first) == ":") {
                if (first + 2 == close && is_name(text(first + 1)))
                    wrap(first + 1, first + 1, "slip::part(" + next() + ", ", ")");
            } else if (text(first) == ";") {
                bool down = false;
                for (std::size_t j = first; j < close; ++j) down |= text(j) == "--";
                const std::size_t equals = until(i + 2, {"=", ";"});
                if (text(equals) == "=" && text(until(equals + 1, {",", ";"})) == ";")
                    wrap(equals + 1, first - 1, (down ? "slip::down_from(" : "slip::from(") + next() + ", ", ")");
                const std::size_t second = until(first + 1, {";"});
                if (second == first + 1)
                    t_[second].after += second + 1 == close ? " slip::turn()" : " slip::turn(), ";
                else
                    wrap(first + 1, second - 1, "slip::turn() && (", ")");
            }
        }
    }

    // A line that calls something, or gives a variable another value.
    void lines() {
        static const Words words{"return",   "if",    "for",    "while", "else",  "break",
                                 "continue", "const", "static", "auto",  "using", "std"};
        for (std::size_t i = begin_ + 1; i < end_; ++i) {
            static const Words ends{";", "{", "}", ")"};
            const std::string& last = text(i - 1);
            if (!ends.count(last)) continue;
            if (!is_name(text(i)) || words.count(text(i)) || is_type(i) || is_state(i) || text(scope_of(i)) != "{")
                continue;
            if (last == ")" && text(other_[i - 1] - 1) != "for") continue;
            if (last == "{" && text(i - 2) != ")" && text(i - 2) != ";" && i - 1 != begin_)
                continue;  // the values of something
            const std::size_t end = until(i, {";", "+=", "-=", "*=", "/=", "|=", "++", "--"});
            if (text(end) != ";") continue;
            const std::size_t equals = until(i, {"=", ";"});
            const bool calls = text(i + 1) == "(" && other_[i + 1] + 1 == end;
            if (text(equals) != "=" && !calls) continue;
            if (text(equals) == "=" && is_name(text(equals - 1)) && is_name(text(equals - 2)))
                continue;  // of a type of its own
            wrap(i, end - 1, "if (slip::keeps(" + next() + ")) ", "");
        }
    }

    struct Lambda {
        std::size_t open, body;
        bool captures;
    };
    std::string name_;
    std::vector<Token> t_;
    int& site_;
    std::vector<std::size_t> other_;
    std::vector<int> depth_;
    std::size_t begin_ = 0, end_ = 0, arguments_ = 0;
    std::vector<Lambda> lambdas_;
    std::vector<Variable> variables_;
    std::set<std::size_t> declared_;
    std::set<std::string> changing_;
};

std::string contents(const char* file) {
    std::ifstream in(file);
    if (!in) {
        std::fprintf(stderr, "write_slips: %s cannot be read\n", file);
        std::exit(2);
    }
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "write_slips: takes NAME OUT FILE...\n");
        return 2;
    }
    const std::string name = argv[1];
    std::string code, list;
    int site = 10;
    const auto add = [&](const std::string& space, const std::vector<Token>& tokens) {
        Rewriter rewriter(name, tokens, site);
        if (rewriter.is_left_out()) return;
        code += "namespace " + space + " {\n" + rewriter.rewritten() + "\n}  // namespace " + space + "\n\n";
        list += (list.empty() ? "" : ", ") + ("checker::answer_of(&" + space + "::" + name + ")");
    };
    for (int file = 3; file < argc; ++file) {
        const std::string written = contents(argv[file]);
        if (written.find("[no slips]") != std::string::npos) continue;
        const std::vector<Token> tokens = tokens_of(written);
        std::size_t i = 0;
        if (tokens.empty() || tokens[0].text != "namespace") {
            add("solution", tokens);
            continue;
        }
        while (i + 2 < tokens.size() && tokens[i].text == "namespace") {
            std::size_t end = i + 3;
            for (int depth = 1; depth > 0 && end < tokens.size(); ++end)
                depth += tokens[end].text == "{" ? 1 : tokens[end].text == "}" ? -1 : 0;
            add(tokens[i + 1].text,
                {tokens.begin() + static_cast<long>(i) + 3, tokens.begin() + static_cast<long>(end) - 1});
            i = end;
        }
    }
    std::ofstream out(argv[2]);
    out << "// Written by write_slips from " << name << "'s right answers.\nnamespace slip = checker::slip;\n"
        << code << "const bool slips_known = checker::register_slips(\"" << name << "\", {" << list << "});\n";
    return out.good() ? 0 : 2;
}
