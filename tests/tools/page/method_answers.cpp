// The course's answers to "which method?": put into pages from the one list, and all of them.
#include "course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <regex>

#include "which_method.hpp"

#include "context.hpp"
#include "directives.hpp"
#include "text.hpp"

using Catch::Matchers::ContainsSubstring;

namespace {

std::string page_of(const std::string& file) { return page::read_file(std::string{SOURCE} + "/" + file); }

// The names between {{which and }}, in their order.
std::vector<std::string> answers_in(const std::string& page) {
    std::vector<std::string> names;
    static const std::regex block{"\\{\\{which ([a-z_ ]+)\\}\\}"}, word{"[a-z_]+"};
    for (std::sregex_iterator each{page.begin(), page.end(), block}, end; each != end; ++each) {
        const std::string inner = (*each)[1];
        for (std::sregex_iterator name{inner.begin(), inner.end(), word}; name != end; ++name)
            names.push_back(name->str());
    }
    return names;
}

}  // namespace

TEST_CASE("answers to which method stand in a chapter as a table, one alone as a sentence, elsewhere as a list") {
    const Course course;
    const timestep::Choice& bumps = timestep::choice("bumps");
    CHECK_THAT(course.fill_paragraph("{{which bumps jumps}}"),
               ContainsSubstring("| you have | take |\n|---|---|\n| " + bumps.have + " | " + bumps.take + ": "));
    CHECK_THAT(course.fill_paragraph("{{which bumps}}"),
               ContainsSubstring("Take " + bumps.take + ", for " + bumps.have + ". Why: " + bumps.why + " ("));
    CHECK_THAT(course.fill_paragraph("{{which free}}"), ContainsSubstring("\\f$h\\lvert\\omega\\rvert\\f$"));
    CHECK_THAT(course.fill_paragraph("{{which contacts}}"), ContainsSubstring("page \\ref in_your_engine has"));
    CHECK_THAT(course.paragraph_error("{{which}}"), ContainsSubstring("takes names of answers"));
    CHECK_THAT(course.paragraph_error("{{which pull push}}"), ContainsSubstring("no answer \"push\""));
    CHECK_THAT(course.paragraph_error("Take {{which pull}}."), ContainsSubstring("on a line of its own"));

    page::Context context{SOURCE, SOURCE};
    const std::string list = page::fill(context, "{{which jumps bumps}}\n", "list.md");
    CHECK_THAT(list, ContainsSubstring("\n2. T" + bumps.have.substr(1) + "?<br>→ " + bumps.take));
    CHECK_THAT(list, ContainsSubstring("<details class=\"why\"><summary>why</summary>\\endhtmlonly " + bumps.why));
}

// The order of the list is that in which timestep::choose() asks.
TEST_CASE("the page of all answers names each once, in the order of the questions") {
    const std::vector<std::string> named = answers_in(page_of("docs/which_method.md"));
    std::vector<std::string> all;
    for (const timestep::Choice& each : timestep::choices()) all.push_back(each.name);
    CHECK(named == all);
}
