#include "misconception.hpp"

#include <cstdlib>
#include <map>

#include "terminal.hpp"

namespace course {

namespace {

// What the answer is of the right one, where that is the same in every call.
const std::map<std::string, std::string>& families() {
    static const std::map<std::string, std::string> words{
        {"minus", "the negative of the right one: a sign is lost."},
        {"twice", "twice the right one."},
        {"half", "half of the right one."},
        {"degrees", "180/π times the right one: degrees instead of radians?"},
        {"radians", "π/180 times the right one: radians instead of degrees?"},
        {"absolute", "the right one without its sign: is there an absolute value too many?"},
        {"squared", "the square of the right one: a root is missing."},
        {"root", "the root of the right one."},
        {"inverse", "one over the right one."},
        {"negated", "the opposite of the right one: yes and no have changed places."},
        {"changed_twice", "what was given, changed by twice as much as it should be."},
        {"changed_half", "what was given, changed by half as much as it should be."},
        {"changed_back", "what was given, changed the other way."},
        {"near", "a near thing: is there a tolerance, a number with too few digits, a rounding, or a < for a ≤?"},
        {"one_more", "one more than the right one."},
        {"one_less", "one less than the right one."},
        {"constant",
         "the right one times a number near one, the same in every call: is there a constant with too few "
         "digits, as 3.14 for π?"},
        {"digits",
         "mostly off by little, less than a five-hundredth of it: is there a constant with too few digits, a float, a "
         "tolerance, a difference of nearly equal numbers, a slope that is found by differences, a loop that ends too "
         "soon, or another method?"},
        {"single",
         "off by as much as numbers of six or seven digits make it: is there a float, a number with an f at "
         "its end, a constant with too few digits, or a tolerance?"}};
    return words;
}

// What would have to be done to a right answer for it to do as the learner's does. It says the kind and not the place,
// and no more than is true of every slip that has this name (tools/checker/slips/slip.hpp).
const std::map<std::string, std::string>& slips() {
    static const std::map<std::string, std::string> words{
        {"sign", "a sign turned round: a plus for a minus, a minus for a plus, or a minus lost"},
        {"twice", "one part of it twice as large as it should be"},
        {"half", "one part of it half as large as it should be"},
        {"term", "one term of a sum or of a difference too many, or left out"},
        {"factor", "one factor or divisor left out"},
        {"upside_down", "something turned upside down: multiplied where it should be divided, or the other way round"},
        {"power", "one factor or divisor counted twice"},
        {"function",
         "a function left out, or another of its kind in its place: a root, a length, sine and cosine, a logarithm, a "
         "rounding"},
        {"reversed", "a comparison the wrong way round, or the larger of two taken for the smaller"},
        {"edge",
         "a comparison that is off at its very edge, with < for ≤ or the other way round, or a count that is off by "
         "one"},
        {"guard", "a condition or a limit left out"},
        {"absolute", "an absolute value left out, or one too many: a number that has lost its sign, or kept it"},
        {"limit", "a limit that does not belong there: a number that cannot fall below zero, or not rise above it"},
        {"joined", "'and' where 'or' belongs, or the other way round"},
        {"brackets", "brackets left out of a sum: only its first term is multiplied or divided"},
        {"line", "one line left out"},
        {"loop", "a loop that begins one too late or ends one too soon"},
        {"exchanged",
         "two arguments, or two parts of one, that have changed places, or the two factors of a product that has an "
         "order"},
        {"variable", "one variable, or one part of it, taken for another"},
        {"constant", "π with too few digits"},
        {"degrees", "an angle in degrees where radians belong, or the other way round"},
        {"single", "numbers of single precision: is there a float, or a number with an f at its end?"}};
    return words;
}

// Of "slip_sign" and "slip_sign_and_term".
std::string of_slips(const std::string& name) {
    const std::string begin = "slip_", between = "_and_";
    if (name.compare(0, begin.size(), begin) != 0) return {};
    const auto at = name.find(between);
    const auto first = slips().find(name.substr(begin.size(), at == std::string::npos ? at : at - begin.size()));
    if (first == slips().end()) return {};
    const std::string as_right = "Your answer does what a right one does with ";
    if (at == std::string::npos) return as_right + first->second + (first->second.back() == '?' ? "" : ".");
    const auto second = slips().find(name.substr(at + between.size()));
    if (second == slips().end()) return {};
    if (first == second) return as_right + "two slips of one kind, each of them " + first->second + ".";
    return as_right + "two slips at once: " + first->second + "; and " + second->second + ".";
}

// What the numbers of the arguments are called, up to the first list, which is the last of them.
std::vector<std::string> numbers_in(const std::string& declaration) {
    std::vector<std::string> names;
    const auto end = declaration.rfind(')');
    int depth = 0;
    std::string argument;
    for (auto at = declaration.find('(') + 1; at <= end && at != 0; ++at) {
        const char c = declaration[at];
        depth += c == '<' ? 1 : c == '>' ? -1 : 0;
        if (at < end && (c != ',' || depth > 0)) {
            argument += c;
            continue;
        }
        const std::string name = argument.substr(argument.rfind(' ') + 1);
        const auto is = [&](const char* type) { return argument.find(type) != std::string::npos; };
        const auto add = [&](std::initializer_list<const char*> parts) {
            for (const char* part : parts) names.push_back(name + part);
        };
        if (is("vector<")) return names.push_back(name), names;
        if (is("State<"))
            add({".t", ".x", ".v"});
        else if (is("Vector3d"))
            add({".x()", ".y()", ".z()"});
        else if (is("Quaterniond"))
            add({".x()", ".y()", ".z()", ".w()"});
        else if (is("Matrix3d"))
            add({"(0, 0)", "(1, 0)", "(2, 0)", "(0, 1)", "(1, 1)", "(2, 1)", "(0, 2)", "(1, 2)", "(2, 2)"});
        else if (is("array<double, 2>"))
            add({"[0]", "[1]"});
        else
            add({""});
        argument.clear();
    }
    return names;
}

// Of "where_zero_3", "is_given", "where_negative_0_is_-1": where the answer is wrong, and what it always is there.
std::string of_where(const std::string& name, const std::string& declaration) {
    std::string where, what;
    const auto is = name.rfind("is_");
    if (name.compare(0, 6, "where_") == 0) {
        const auto behind = name.find('_', 6);
        const std::vector<std::string> names = numbers_in(declaration);
        const auto number = std::size_t(std::atoi(name.c_str() + behind + 1));
        if (behind == std::string::npos || number >= names.size()) return {};
        const std::string how = name.substr(6, behind - 6);
        where = "only where " + names[number] + " is " + how;
        if (how == "nonzero") {
            where = "wherever " + names[number] + " is not zero, or nearly so";
            if (is == std::string::npos)
                return "Of all that was tried, your answer is wrong " + where + ". Where does " + names[number] +
                       " come in?";
        }
        if (how == "above" || how == "below") {
            const auto limit = name.find('_', behind + 1);
            if (limit == std::string::npos) return {};
            const std::string least = name.substr(limit + 1, is == std::string::npos ? is : is - 1 - (limit + 1));
            where = "only where " + names[number] + " is " + least + (how == "above" ? " or more" : " or less");
        }
    } else if (is != 0) {
        return {};
    }
    if (is != std::string::npos) what = name.substr(is + 3);
    const bool is_yes_or_no = declaration.compare(0, 5, "bool ") == 0;
    if (what == "given")
        what = "what was given, unchanged: does it return too soon, or has a line no effect?";
    else if (!what.empty())
        what = "always " + (is_yes_or_no ? what == "0" ? "false" : "true" : what) +
               ": is there a condition too many, one too few, or a tolerance?";
    if (what.empty())
        return "Of all that was tried, your answer is wrong " + where +
               ". Does that case have its own condition, or want one?";
    if (where.empty()) return "Wherever your answer is wrong, it is " + what;
    return "Of all that was tried, your answer is wrong " + where + ", and there it is " + what;
}

std::string told_of_kind(const std::string& name, const std::string& declaration) {
    const std::string slip = of_slips(name);
    return slip.empty() ? of_where(name, declaration) : slip;
}

}  // namespace

std::string told_of(const Exercise& exercise, const std::string& misconception) {
    const auto known = exercise.mistakes();
    const auto mistake = known.find(misconception);
    if (mistake != known.end()) return wrapped(mistake->second.says, 2) + wrapped("Hint: " + mistake->second.hint, 2);
    const auto family = families().find(misconception);
    if (family != families().end()) return wrapped("Wherever your answer is wrong, it is " + family->second, 2);
    const std::string told = told_of_kind(misconception, exercise.declaration);
    return told.empty() ? told : wrapped(told, 2);
}

}  // namespace course
