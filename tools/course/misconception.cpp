#include "verdict_text.hpp"

#include <map>
#include <vector>

#include "terminal.hpp"

namespace course {

namespace {

// What the answer is of the right one, where that is the same in every call.
const std::map<std::string, std::string>& generic_mistakes() {
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

std::string of_slips(const std::vector<std::string>& forms) {
    std::vector<std::string> words;
    for (const std::string& form : forms)
        if (const auto known = slips().find(form); known != slips().end()) words.push_back(known->second);
    if (words.empty()) return {};
    const std::string as_right = "Your answer does what a right one does with ";
    if (words.size() == 1) return as_right + words[0] + (words[0].back() == '?' ? "" : ".");
    if (words[0] == words[1]) return as_right + "two slips of one kind, each of them " + words[0] + ".";
    return as_right + "two slips at once: " + words[0] + "; and " + words[1] + ".";
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

// Where the answer is wrong, and what it always is there.
std::string of_region(const checker::Diagnosis& found, const std::string& declaration) {
    const std::vector<std::string> names = numbers_in(declaration);
    if (found.argument >= names.size()) return {};
    const std::string& name = names[found.argument];
    std::string where = "only where " + name + " is " + found.region, what;
    if (found.region == "nonzero") where = "wherever " + name + " is not zero, or nearly so";
    if (!found.limit.empty())
        where = "only where " + name + " is " + found.limit + (found.region == "above" ? " or more" : " or less");
    const std::string wrong = "Of all that was tried, your answer is wrong " + where;
    if (found.value.empty())
        return wrong + (found.region == "nonzero" ? ". Where does " + name + " come in?"
                                                  : ". Does that case have its own condition, or want one?");
    if (found.value == "given")
        what = "what was given, unchanged: does it return too soon, or has a line no effect?";
    else
        what = "always " +
               (!declaration.starts_with("bool ") ? found.value
                : found.value == "0"              ? "false"
                                                  : "true") +
               ": is there a condition too many, one too few, or a tolerance?";
    return found.region.empty() ? "Wherever your answer is wrong, it is " + what : wrong + ", and there it is " + what;
}

}  // namespace

std::string told_of(const Exercise& exercise, const checker::Diagnosis& diagnosis) {
    if (diagnosis.empty()) return {};
    if (diagnosis.mistake.empty())
        return wrapped(diagnosis.slips.empty() ? of_region(diagnosis, exercise.declaration) : of_slips(diagnosis.slips),
                       2);
    const auto known = exercise.mistakes();
    if (const auto mistake = known.find(diagnosis.mistake); mistake != known.end())
        return wrapped(mistake->second.says, 2) + wrapped("Hint: " + mistake->second.hint, 2);
    const auto generic = generic_mistakes().find(diagnosis.mistake);
    return generic == generic_mistakes().end() ? ""
                                               : wrapped("Wherever your answer is wrong, it is " + generic->second, 2);
}

}  // namespace course
