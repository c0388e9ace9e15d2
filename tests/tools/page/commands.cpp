// The programs as commands: what they leave behind, and what they do not.
#include "course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::EndsWith;
namespace fs = std::filesystem;

namespace {

Outcome make_page(const Course& course, const std::string& more = "") {
    const std::string root = (course / "").string();
    return run_command(std::string{PAGE} + " --source " + root + " --runs " + root +
                       "runs --chapter 03_springs --input " + root + "chapters/03_springs/chapter.md --output " + root +
                       "out/page.md --index " + root + "out/index.tsv --figures " + root + "out/figures --depfile " +
                       root + "out/page.d" + more);
}

}  // namespace

TEST_CASE("page leaves the page, the index, the figures and what it depends on") {
    const Course course;
    const Outcome outcome = make_page(course);
    CHECK(outcome.words.empty());
    REQUIRE(outcome.status == 0);
    CHECK(course.read("out/page.md").starts_with("# 3 · Springs"));
    CHECK(course.read("out/index.tsv") ==
          "N22\tsection\tchapter_03.html\tch3_steps\tSteps\n"
          "N22\tfigure\tchapter_03.html\tfig-spiral\tspiral\n");
    CHECK_THAT(course.read("out/figures/03_springs/spiral.svg"), ContainsSubstring("prefers-color-scheme:dark"));
    CHECK(fs::exists(course / "out/figures/03_springs/sweep.still.gif"));
    CHECK(!fs::exists(course / "out/figures/03_springs/sweep.gif"));  // nobody could ask for it
    // Its frames as a script: "R0lGODlh" is GIF89a.
    const std::string film = course.read("out/figures/03_springs/sweep.gif.js");
    CHECK(film.starts_with("pageBytes[\"figures/03_springs/sweep.gif\"] = \"R0lGODlh"));
    CHECK(film.ends_with("\";\n"));
    CHECK_THAT(course.read("out/page.d"), ContainsSubstring((course / "include/step.hpp").string()));
}

TEST_CASE("page that fails says where, and leaves neither a page nor an older one") {
    const Course course;
    REQUIRE(make_page(course).status == 0);
    course.replace("chapters/03_springs/chapter.md", "{{amplitude}}", "{{amplitud}}");
    const Outcome outcome = make_page(course);
    CHECK(outcome.status == 2);
    CHECK(outcome.words ==
          "chapters/03_springs/chapter.md:5: the run of 03_springs has no number "
          "\"amplitud\"\n");
    CHECK_FALSE(fs::exists(course / "out/page.md"));
    CHECK_FALSE(fs::exists(course / "out/index.tsv"));
}

TEST_CASE("source_filter takes the markers from headers, line for line, and hides the rest") {
    const Course course;
    const std::string filter =
        std::string{SOURCE_FILTER} + " " + (course / "include").string() + " " + (course / "groups.tsv").string() + " ";
    course.write("groups.tsv", "# a comment\nlib/run.hpp\tlibrary_2\n");
    CHECK(run_command(filter + (course / "include/step.hpp").string()).words ==
          "struct S {\n\n    void step() {\n        x += h * v;\n    }\n\n};\n");
    CHECK(run_command(filter + (course / "chapters/03_springs/springs.cpp").string()).words.empty());
    CHECK(run_command(filter + (course / "include/none.hpp").string()).status == 2);
    course.write("include/lib/run.hpp",
                 "#pragma once\n/// \\file\n/// Runs.\nnamespace timestep {\nint x;\n}  // namespace timestep\n");
    CHECK(run_command(filter + (course / "include/lib/run.hpp").string()).words ==
          "/// \\file\n/// \\ingroup library_2\n/// Runs.\nnamespace timestep { /** \\addtogroup library_2 */ /** \\{ "
          "*/\nint x;\n"
          "/** \\} */ }  // namespace timestep\n");
}

namespace {

/// A site as Doxygen leaves it, and what finish_site makes of its page p.html.
class Site {
public:
    Site() {
        course.write("tags", "");
        course.write("library/units.tsv", "");
        course.write("library/groups.tsv", "");
    }
    Outcome finish(const std::string& more = "") const {
        return run_command(std::string{FINISH_SITE} + " " + (course / "site").string() + " " +
                           (course / "tags").string() + " " + (course / "library").string() + more);
    }
    std::string page(const std::string& html, const std::string& more = "") const {
        course.write("site/p.html", html);
        REQUIRE(finish(more).words.empty());
        return course.read("site/p.html");
    }
    Course course;
};

}  // namespace

TEST_CASE("finish_site leads to the source pages, and fails where there is none") {
    const Site site;
    site.course.write("site/step_8hpp_source.html", "<title>Timestep: include/step.hpp Source File</title>");
    CHECK(site.page("<a href=\"source:include/step.hpp#l00003\">x</a><a href=\"b.html\">") ==
          "<a href=\"step_8hpp_source.html#l00003\">x</a><a href=\"b.html\">");
    CHECK(site.page("<a href=\"source:tests/none.cpp\">x</a>", " tests/") == "<a >x</a>");
    site.course.write("site/p.html", "<a href=\"source:tests/none.cpp\">x</a>");
    CHECK(site.finish().words == "p.html:1: links to tests/none.cpp, which the site does not show\n");
    CHECK(site.finish().status == 2);
}

TEST_CASE("finish_site puts a unit beside every parameter, and refuses one without") {
    const Site site;
    const std::string groups = "timestep/run.hpp\tlibrary_2\n";
    site.course.write("tags",
                      "<compound kind=\"file\">\n<name>run.hpp</name>\n<path>include/timestep/</path>\n</compound>\n");
    const auto make = [&](const std::string& units, const std::string& of_groups) {
        site.course.write(
            "site/p.html",
            "<td class=\"memname\">double timestep::A&lt; X &gt;::step </td><td class=\"paramname\"><em>h</em>, </td>"
            "<td class=\"paramname\"><em>x</em></td><td class=\"paramname\"></td><em>y</em>");
        site.course.write("library/units.tsv", units);
        site.course.write("library/groups.tsv", of_groups);
        return site.finish().words;
    };
    CHECK(make("h\ts\t\nx\trad\tA<\n", groups).empty());
    CHECK_THAT(site.course.read("site/p.html"),
               ContainsSubstring("<em>h</em><span class=\"unit\">s</span>, ") &&
                   ContainsSubstring("<em>x</em><span class=\"unit\">rad</span></td>") && EndsWith("<em>y</em>"));
    CHECK_THAT(make("h\ts\t\nx\tm\t\nx\trad\tA<\n", groups), ContainsSubstring("no function has a parameter x there"));
    CHECK(make("h\ts\t\n", groups) ==
          "docs/library/units.tsv:1: has no unit for the parameter x of double timestep::A< X >::step\n");
    CHECK_THAT(make("h\ts\t\nx\t\t\n", ""), EndsWith("groups.tsv:1: has no group for timestep/run.hpp\n"));
    CHECK_THAT(make("h\ts\t\nx\t\t\n", groups + groups),
               ContainsSubstring("groups.tsv:2: there is no second header timestep/run.hpp"));
}
