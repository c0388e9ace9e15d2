// Rewrites right answers so that they can slip (slip.hpp):
//
//     write_slips NAME OUT FILE…
//
// FILE… are the solution, and right answers that are written differently, each in a namespace of its own. They are
// C++ as clang-format leaves it: an operator with two operands stands between blanks, any other one does not. A file
// with the words "[no slips]" is left out: for what this cannot read.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "code.hpp"
#include "variables.hpp"

namespace {

class Rewriter : private Code {
public:
    Rewriter(std::string name, std::vector<Token> tokens, int& site)
        : Code(std::move(tokens)), name_(std::move(name)), site_(site) {}

    std::string rewritten() {
        for (std::size_t i = 1; i < size(); ++i) {
            if (text(i) != "{") continue;
            if (text(i - 1) == ")") function(other(i - 1), i);
            i = other(i);
        }
        std::string code;
        for (std::size_t i = 0; i < size(); ++i) {
            code += rendered(i, i + 1);
            if (text(i) == ";" || text(i) == "{" || text(i) == "}") code += '\n';
        }
        return code;
    }

    // What does not slip safely, or costs more to compile than it is worth.
    bool is_left_out() const {
        static const Words words{"sort",      "inverse", "colPivHouseholderQr", "fullPivLu", "eigenvalues",
                                 "remainder", "pair"};
        bool seen = false;
        for (std::size_t i = 0; i < size(); ++i) {
            if (words.count(text(i))) return true;
            if (text(i) == name_ && seen) return true;  // it calls itself
            if (text(i) == "*" && !blank(i) && is_name(text(i - 1)) && blank(i + 1))
                return true;                                                                    // pointers know no end
            if (text(i) == "begin" && (text(i + 3) == "+" || text(i + 3) == "-")) return true;  // nor do these
            seen |= text(i) == name_;
        }
        return false;
    }

private:
    std::string next() { return std::to_string(site_++); }

    void function(std::size_t open, std::size_t body) {
        begin_ = body, end_ = other(body);
        const Variables variables(*this, open, body);
        std::string entry;
        if (text(open - 1) == name_) {                        // the answer itself, not a helper
            for (std::size_t i = open; i < other(open); ++i)  // its own, to exchange
                if (text(i) == "const" || text(i) == "&") set(i, "");
            entry = slips_of_arguments(variables);
        }
        picks(variables);
        operators();  // before anything else is taken for another word
        subscripts();
        methods();
        calls();
        brackets();
        added();
        conditions();
        loops();
        lines();
        add_after(body, entry);
    }

    std::string slips_of_arguments(const Variables& variables) {
        std::string entry;
        const auto exchange = [&](const std::string& a, const std::string& b) {
            entry += " slip::exchange(" + next() + ", " + a + ", " + b + ");";
        };
        const std::vector<Variable>& all = variables.all();
        for (std::size_t a = 0; a < variables.arguments(); ++a)
            for (std::size_t b = a + 1; b < variables.arguments(); ++b)
                if (all[a].type == all[b].type) exchange(all[a].name, all[b].name);
        for (std::size_t a = 0; a < variables.arguments(); ++a) {
            if (all[a].type == "double") entry += " slip::given(" + next() + ", " + all[a].name + ");";
            if (all[a].type == "State") exchange(all[a].name + ".x", all[a].name + ".v");
        }
        return entry;
    }

    // A variable, or a part of one, may be taken for another of its type.
    void picks(const Variables& variables) {
        static const Words not_behind{".", "->", "::", "++", "--", "&", ">"}, not_before{"(", "[", "{", "::"};
        static const std::vector<std::string> parts{"x", "y", "z"}, of_state{"x", "v"};
        for (std::size_t i = begin_; i < end_; ++i) {
            const std::string& following = text(i + 1);
            if (!is_name(text(i)) || variables.declares(i) || not_behind.count(text(i - 1)) ||
                not_before.count(following) || assigns(following))
                continue;
            const Variable* variable = variables.find(text(i), i);
            const std::size_t scope = scope_of(i);
            const bool is_capture = text(scope) == "[" && !operand_before(scope);
            if (!variable || is_capture || variables.changes_argument(text(scope - 1))) continue;
            const bool is_state = variable->type == "State";
            std::size_t end = i;
            std::string type = variable->type, part;
            if (following == ".") {
                if (is_state)
                    end = i + 2, type = "double", part = text(i + 2);
                else if (type == "Vector3d" && std::count(parts.begin(), parts.end(), text(i + 2)))
                    end = i + 4, type = "double", part = text(i + 2);
                const std::size_t behind = until(i, {"=", ";", ",", "+=", "-="});
                if (assigns(text(end + 1)) || (end == i && text(behind) == "=")) continue;
            } else if (is_state) {
                continue;
            }
            if (stands(until(end + 1, {}), {")", "="})) continue;  // (a ? b : c) = …
            std::vector<std::string> others;
            if (!part.empty())
                for (const std::string& other : is_state ? of_state : parts)
                    if (other != part) others.push_back(variable->name + "." + other + (is_state ? "" : "()"));
            // The nearest first: what is taken for another is most often that.
            for (auto each = variables.all().rbegin(); each != variables.all().rend(); ++each)
                if (each->name != variable->name && each->type == type && variables.find(each->name, i) == &*each)
                    others.push_back(each->name);
            std::string list;
            for (std::size_t k = 0; k < std::min<std::size_t>(others.size(), 6); ++k) list += ", " + others[k];
            if (!list.empty()) wrap(i, end, "slip::pick(" + next() + ", ", list + ")");
            i = end;
        }
    }

    // What is asked for its elements, or its last one.
    void subscripts() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (!is_name(text(i)) || text(i - 1) == "." || text(i - 1) == "::") continue;
            const bool is_end = stands(i + 1, {".", "back", "("}) || stands(i + 1, {".", "front", "("});
            if (is_end || (text(i + 1) == "[" && !blank(i + 1))) set(i, "slip::in(" + text(i) + ")");
        }
    }

    // The first token of what stands before the point at i.
    std::size_t begin_of_operand(std::size_t i) const {
        for (;;) {
            --i;
            if (text(i) == ")" || text(i) == "]") {
                i = other(i);
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
                set(i, "slip");
                add_after(i + 3, next() + ", ");
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
            if (blank(i) && blank(i + 1) && operand_before(i)) {
                set(i, text(i) + " slip::" + name->second + "{" + next() + "} " + text(i));
            } else if (text(i) == "-" && !operand_before(i) && !is_number(text(i + 1))) {
                set(i, "slip::Negative{" + next() + "}->*");
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
        for (const std::size_t i : joints) set(i, joined == "&&" ? "||" : "&&");
        const std::string other = rendered(first, end);
        for (const std::size_t i : joints) set(i, joined);
        wrap(first, end - 1, "(slip::joined(" + next() + ") ? bool(" + other + ") : bool(", "))");
    }

    // An expression once more, without the brackets of a sum in it that is multiplied or divided. Of numbers alone:
    // what else there is may have no such sum.
    void brackets() {
        static const Words delimiters{"=", "return", ",",  ";",  "(",  "[",  "{",  "}",  "?",  ":",  "<",
                                      ">", "<=",     ">=", "==", "!=", "&&", "||", "+=", "-=", "*=", "/="};
        static const Words no_numbers{"Vector3d", "Matrix3d", "Quaterniond", "complex"};
        for (std::size_t i = begin_; i < end_; ++i)
            if (no_numbers.count(text(i))) return;
        struct Whole {
            std::size_t end;
            std::vector<std::string> others;
        };
        std::map<std::size_t, Whole> wholes;  // the expressions that begin there
        for (std::size_t open = begin_; open < end_; ++open) {
            if (text(open) != "(" || operand_before(open) || text(open - 1) == "]") continue;
            const std::size_t close = other(open);
            const auto multiplies = [&](std::size_t j) { return is_operator(j, '*') || is_operator(j, '/'); };
            if (!multiplies(open - 1) && !multiplies(close + 1)) continue;
            bool is_sum = false, is_more = false;
            for (std::size_t j = open + 1; j < close; ++j) {
                if (opens(text(j))) j = other(j);
                is_sum |= is_operator(j, '+') || is_operator(j, '-');
                is_more |= delimiters.count(text(j)) && text(j) != "]";
            }
            if (!is_sum || is_more) continue;
            std::size_t first = open;
            while (first > begin_ + 1 && !delimiters.count(text(first - 1))) {
                --first;
                if (text(first) == ")" || text(first) == "]") first = other(first);
            }
            Whole& whole = wholes[first];
            whole.end = until(open, {",", ";", "?", ":", "<", ">", "<=", ">=", "==", "!=", "&&", "||"});
            if (whole.others.size() == 3) continue;
            set(open, " "), set(close, " ");
            whole.others.push_back("(slip::unbracketed(" + next() + ") ? " + rendered(first, whole.end) + " : ");
            set(open, "("), set(close, ")");
        }
        for (const auto& [first, whole] : wholes) {
            std::string before;
            for (const std::string& other : whole.others) before += other;
            wrap(first, whole.end - 1, before + "(", ")" + std::string(whole.others.size(), ')'));
        }
    }
    // As operators() has written it.
    bool is_operator(std::size_t i, char which) const { return text(i).rfind(which + std::string(" slip::"), 0) == 0; }

    void conditions() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) == "if" && text(i + 1) == "(") parts_of(i + 2, other(i + 1), true);
            if (text(i) == "return") parts_of(i + 1, until(i + 1, {";"}), false);
        }
    }

    void loops() {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (text(i) == "while") wrap(i + 2, other(i + 1) - 1, "slip::turn() && (", ")");
            if (text(i) != "for") continue;
            const std::size_t close = other(i + 1), first = until(i + 2, {";", ":"});
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
                    add_after(second, second + 1 == close ? " slip::turn()" : " slip::turn(), ");
                else
                    wrap(first + 1, second - 1, "slip::turn() && (", ")");
            }
        }
    }

    // A line that calls something, or gives a variable another value.
    void lines() {
        static const Words words{"return",   "if",    "for",    "while", "else",  "break",
                                 "continue", "const", "static", "auto",  "using", "std"};
        static const Words ends{";", "{", "}", ")"};
        for (std::size_t i = begin_ + 1; i < end_; ++i) {
            const std::string& last = text(i - 1);
            if (!ends.count(last) || !is_name(text(i)) || words.count(text(i)) || is_type(i) || is_state(i) ||
                text(scope_of(i)) != "{")
                continue;
            if (last == ")" && text(other(i - 1) - 1) != "for") continue;
            if (last == "{" && text(i - 2) != ")" && text(i - 2) != ";" && i - 1 != begin_)
                continue;  // the values of something
            const std::size_t end = until(i, {";", "+=", "-=", "*=", "/=", "|=", "++", "--"});
            if (text(end) != ";") continue;
            const std::size_t equals = until(i, {"=", ";"});
            const bool calls = text(i + 1) == "(" && other(i + 1) + 1 == end;
            if (text(equals) != "=" && !calls) continue;
            if (text(equals) == "=" && is_name(text(equals - 1)) && is_name(text(equals - 2)))
                continue;  // of a type of its own
            wrap(i, end - 1, "if (slip::keeps(" + next() + ")) ", "");
        }
    }

    std::string name_;
    int& site_;
    std::size_t begin_ = 0, end_ = 0;  // of the function in hand
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
    const auto add = [&](const std::string& space, std::vector<Token> tokens) {
        Rewriter rewriter(name, std::move(tokens), site);
        if (rewriter.is_left_out()) return;
        code += "namespace " + space + " {\n" + rewriter.rewritten() + "\n}  // namespace " + space + "\n\n";
        list += (list.empty() ? "" : ", ") + ("checker::answer_of(&" + space + "::" + name + ")");
    };
    for (int file = 3; file < argc; ++file) {
        const std::string written = contents(argv[file]);
        if (written.find("[no slips]") != std::string::npos) continue;
        const std::vector<Token> tokens = tokens_of(written);
        const Code all(tokens);
        if (all.text(0) != "namespace") add("solution", tokens);
        for (std::size_t i = 0; all.text(i) == "namespace";) {
            const std::size_t end = all.other(i + 2);
            add(all.text(i + 1), {tokens.begin() + long(i) + 3, tokens.begin() + long(end)});
            i = end + 1;
        }
    }
    std::ofstream out(argv[2]);
    out << "// Written by write_slips from " << name << "'s right answers.\nnamespace slip = checker::slip;\n"
        << code << "const bool slips_known = checker::register_slips(\"" << name << "\", {" << list << "});\n";
    return out.good() ? 0 : 2;
}
