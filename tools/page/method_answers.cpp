// The course's answers to "which method?" on a page, from the list that ./course advise goes by.

#include "directives.hpp"
#include "text.hpp"

#include "which_method.hpp"

#include <cctype>
#include <stdexcept>

namespace page {

namespace {

/// The list is plain text, since programs print it, too: here its formulas become formulas, and a page it names a link.
std::string with_formulas(std::string text) {
    text = replace_all(text, "h|ω|", "$h\\lvert\\omega\\rvert$");
    text = replace_all(text, "|L|", "$\\lvert L\\rvert$");
    text = replace_all(text, "page In your engine", "page \\ref in_your_engine");
    return replace_all(text, "ωh", "$\\omega h$");
}

/// "ch6_kicks" is section 6's: a link that says so, or that it is on this page.
std::string link(const Context& context, const std::string& where) {
    const bool here =
        context.chapter() != nullptr && where.starts_with(context.chapter()->section_prefix(context.is_more()));
    const std::size_t digits = where.find_first_of("0123456789");
    const std::string chapter = where.substr(digits, where.find('_') - digits);
    return "[" + (here ? std::string{"below"} : "chapter " + chapter) + "](@ref " + where + ")";
}

}  // namespace

std::string method_answers_markdown(Context& context, const Directive& directive) {
    if (directive.arguments.empty())
        throw std::invalid_argument{"{{which}} takes names of answers, of tools/advise/words.txt"};
    const bool chapter = context.chapter() != nullptr, alone = chapter && directive.arguments.size() == 1;
    std::string text = chapter && !alone ? "| you have | take |\n|---|---|\n" : "";
    int number = 0;
    for (const std::string& name : directive.arguments) {
        const timestep::Choice& choice = timestep::choice(name);
        std::string have = with_formulas(choice.have);
        const std::string take = with_formulas(choice.take);
        const std::string why = with_formulas(choice.why);
        const std::string where = "(" + link(context, choice.where) + ")";
        if (!chapter && std::islower(static_cast<unsigned char>(have.front())) != 0)
            have.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(have.front())));
        if (alone) return "Take " + take + ", for " + have + ". Why: " + why + " " + where + ".";
        text += chapter ? "| " + have + " | " + take + ": " + why + " " + where + " |\n"
                        : std::to_string(++number) + ". " + have + "?<br>→ " + take + " " + where +
                              " \\htmlonly<details class=\"why\"><summary>why</summary>\\endhtmlonly " + why +
                              ".\\htmlonly</details>\\endhtmlonly\n";
    }
    return text;
}

}  // namespace page
