// The page of the talks: every claimed row has its text, its section and its test.
#include "context.hpp"
#include "course.hpp"
#include "directives.hpp"
#include "text.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Matchers::ContainsSubstring;

namespace {

void index_row(const Course& course) {
    course.write("index/03_springs.tsv",
                 "N22\tsection\tchapter_03.html\tch3_steps\tSteps\n"
                 "N22\tfigure\tchapter_03.html\tfig-spiral\tspiral\n");
    course.write("tests/chapters/a.cpp", "#include <x>\n\nTEST_CASE(\"it grows as $n$\", \"[N22][ch3]\") {\n");
}

std::string talks(const Course& course) {
    page::Context context{course / "", course / "runs"};
    context.indexes = course / "index";
    try {
        return page::fill(context, "{{talks}}\n", "talks.md");
    } catch (const page::Error& wrong) {
        return wrong.what();
    }
}

}  // namespace

TEST_CASE("a row stands with what the talks show, its erratum, section, figure, checks and tests") {
    const Course course;
    index_row(course);
    course.write("docs/talks.tsv", "N22\tN\tIt spirals, $a<b$.\tNot always.\tgrows\n");
    course.write("tests/library/b.cpp", "TEST_CASE(\"x < y\", \"[N22]\") {\n}\n");
    const std::string page = talks(course);
    for (const char* part :
         {"<tr id=\"row_N22\">",
          "It spirals, \\f$a<b\\f$.<br><span class=\"erratum\"><b>Erratum.</b> Not always.</span>",
          "<a href=\"chapter_03.html#ch3_steps\">Steps</a>", "<a href=\"chapter_03.html#fig-spiral\">spiral</a>",
          // All but the first are folded away.
          "<a href=\"source:chapters/03_springs/study/growth.cpp#l00040\">the amplitude grows</a><details>"
          "<summary>and 2 more</summary><a href=\"source:tests/chapters/a.cpp#l00003\">it grows as &#36;n&#36;</a><br>"
          "<a href=\"source:tests/library/b.cpp#l00001\">x &lt; y</a></details>"})
        CHECK_THAT(page, ContainsSubstring(part));
}

TEST_CASE("a claimed row without its text, section or evidence is an error, and so is an unknown check") {
    const Course course;
    const auto error = [&](const std::string& file, const std::string& content) {
        index_row(course);
        course.write("docs/talks.tsv", "N22\tN\tIt spirals.\t\t\n");
        course.write(file, content);
        return talks(course);
    };
    CHECK_THAT(error("docs/talks.tsv", "N23\tN\tOther.\t\t\n"),
               ContainsSubstring("N22 is claimed, but docs/talks.tsv does not say"));
    CHECK_THAT(error("tests/chapters/a.cpp", "TEST_CASE(\"other\", \"[N23]\") {\n}\n"),
               ContainsSubstring("docs/talks.tsv names no check of it, and no test is tagged [N22]"));
    CHECK_THAT(error("index/03_springs.tsv", "N22\tfigure\tchapter_03.html\tfig-spiral\tspiral\n"),
               ContainsSubstring("N22 is claimed, but no section teaches it"));
    CHECK_THAT(error("docs/talks.tsv", "N23\tN\tOther.\t\t\nN22\tN\tIt spirals.\t\tshrinks\n"),
               ContainsSubstring("docs/talks.tsv:2: the run of 03_springs made no check \"shrinks\""));
}
