// Numbers and checks: what a sentence on a page rests on.

#include "directives.hpp"
#include "number.hpp"
#include "text.hpp"

#include <stdexcept>

namespace page {
namespace {

/// The number that `reference` names, without its unit when it ends in `.value`.
Number look_up(Context& context, std::string reference) {
    const bool bare = reference.ends_with(".value");
    if (bare) {
        reference.erase(reference.size() - 6);
    }
    std::string name;
    RunData& run = context.run_of(reference, name);
    Number number = run.number(name);
    if (number.value == "nan" || number.value == "-nan" || number.value.empty()) {
        throw std::out_of_range{
            "the number \"" + name + "\" is " +
            (number.value.empty() ? "not measured here; what needs it stands between {{where " + name + "}} and {{end}}"
                                  : "\"" + number.value + "\"") +
            run.written_at(name, "number")};
    }
    number.unit = bare ? "" : number.unit;
    return number;
}

}  // namespace

std::string number_markdown(Context& context, const std::string& reference) {
    const Number number = look_up(context, reference);
    // A sentence may be broken at the end of a line, a number or a name may not.
    const char* kind = number.value.size() > 40 ? "words" : "number";
    return "<span class=\"" + std::string(kind) + "\" title=\"" + attribute(number.meaning) + "\">" +
           typeset(number.value, number.unit) + "</span>";
}

std::string number_tex(Context& context, const std::string& reference) {
    const Number number = look_up(context, reference);
    return typeset_tex(number.value, number.unit);
}

std::string check_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.size() != 1) {
        throw std::invalid_argument{"{{check name}} takes one name"};
    }
    std::string name;
    const std::string statement = attribute(context.run_of(directive.arguments.front(), name).check(name));
    // Shown by the style sheet under the pointer, and on a phone at a tap.
    return "<span class=\"check\" tabindex=\"0\" role=\"note\" aria-label=\"The run confirms: " + statement +
           "\" data-statement=\"" + statement + "\">✓</span>";
}

std::string with_marks_joined(std::string page) {
    static const std::string begin = "<span class=\"check\"", told = "data-statement=\"", end = "\">✓</span>",
                             label = "The run confirms: ";
    for (std::size_t at = page.find(end); at != std::string::npos; at = page.find(end, at + 1)) {
        while (true) {
            const std::size_t next = page.find_first_not_of(" \n", at + end.size());
            if (next == std::string::npos || page.compare(next, begin.size(), begin) != 0) {
                break;
            }
            const std::size_t from = page.find(told, next) + told.size(), to = page.find(end, next);
            const std::size_t first = page.rfind(told, at) + told.size();
            const std::string all = page.substr(first, at - first) + "; " + page.substr(from, to - from);
            const std::size_t open = page.rfind(begin, at), named = page.find(label, open) + label.size();
            const std::string mark = page.substr(open, named - open) + all + "\" " + told + all + end;
            page.replace(open, to + end.size() - open, mark);
            at = open + mark.size() - end.size();
        }
        // No line begins with a mark.
        const std::size_t open = page.rfind(begin, at), words = page.find_last_not_of(" \n", open - 1);
        if (words != std::string::npos && words + 1 < open &&
            std::string{"|-*>"}.find(page[words]) == std::string::npos && page.compare(words + 1, 2, "\n\n") != 0) {
            page.replace(words + 1, open - words - 1, "\u00a0");
            at = page.find(end, words);
        }
    }
    return page;
}

}  // namespace page
