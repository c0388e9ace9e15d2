// A chapter's second page, more.md: filled as the chapter is, with figures that go on from the
// chapter's.
#include "course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "context.hpp"
#include "text.hpp"
#include "directives.hpp"

using Catch::Matchers::ContainsSubstring;

namespace {

const std::string chapter = "chapters/03_springs/chapter.md", more = "chapters/03_springs/more.md";
const std::string title = "# More on chapter 3 {#more_03}\n\n";
const std::string sweep = "{{figure sweep.gif: A sweep.}}";

// The course, whose chapter has a second page that says this below its title.
void write_more(const Course& course, const std::string& text) { course.write(more, title + text + "\n"); }

// Its film stands on the second page.
void move_sweep(const Course& course) {
    course.replace(chapter, sweep, "");
    write_more(course, sweep);
}

std::string fill_more(const Course& course, std::vector<page::IndexEntry>* index = nullptr) {
    page::Context context{course / "", course / "runs"};
    context.set_chapter("03_springs", more);
    const std::string filled = page::fill(context, course.read(more), "more.md");
    if (index != nullptr) *index = context.index;
    return filled;
}

std::string more_error(const Course& course) {
    return message_of([&] { fill_more(course); });
}

std::string error_of(const Course& course, const std::string& text) {
    write_more(course, text);
    return more_error(course);
}

}  // namespace

TEST_CASE("a second page has its own title and sections, and leads back to its chapter") {
    const Course course;
    course.write("chapters/04_more/about.json",
                 R"({"title": "More", "question": "?", "claims": [], "picture": "a.svg", "figures": ["a.svg"]})");
    write_more(course, "First.\n\n## Limits {#more3_limits}\n\n### Of one {#more3_one}");
    const std::string page = fill_more(course);
    CHECK(page.starts_with("# More on chapter 3 {#more_03}\n\n[TOC]\n"));
    CHECK_THAT(page, ContainsSubstring("<div class=\"neighbours\"><span class=\"previous\">\\ref "
                                       "chapter_03 \"3 · Springs\"</span><span class=\"next\">"));
    CHECK_THAT(page, !ContainsSubstring("class=\"facts\"") && !ContainsSubstring("Springs {#"));

    for (const char* heading : {"## Limits {#ch3_limits}", "### Limits"})
        CHECK(error_of(course, heading) == "more.md:3: a section must have an id that begins {#more3_");
    CHECK_THAT(error_of(course, "# Limits {#more3_limits}"), ContainsSubstring("more.md:3: the first heading, and no"));
    for (const char* text : {"# More {#chapter_03}\n", "More.\n"}) {
        course.write(more, text);
        CHECK_THAT(more_error(course), ContainsSubstring("more.md:1: ") && ContainsSubstring("id {#more_03}"));
    }
    CHECK(error_of(course, "It is {{none}}.") == "more.md:3: the run of 03_springs has no number \"none\"");
}

TEST_CASE("a figure may stand on a chapter's second page, and numbers go on there") {
    const Course course;
    course.write("runs/03_springs/run/turn.svg", course.read("runs/03_springs/run/spiral.svg"));
    course.replace("chapters/03_springs/about.json", "\"sweep.gif\"", "\"turn.svg\", \"sweep.gif\"");
    move_sweep(course);
    course.replace(more, sweep, "{{figure turn.svg: Round.}}\n\n" + sweep);
    CHECK_THAT(course.fill(),
               ContainsSubstring("Figure\u00a03.1.</span> **Out.**") && !ContainsSubstring("fig-sweep-film"));
    const std::string second = fill_more(course);
    CHECK_THAT(second, ContainsSubstring("Figure\u00a03.2.</span> Round."));
    CHECK_THAT(second, ContainsSubstring("<figure id=\"fig-sweep-film\"") &&
                           ContainsSubstring("Figure\u00a03.3.</span> A sweep."));

    course.replace(more, sweep, "");
    CHECK(course.fill_error() == "chapters/03_springs/about.json:1: the page does not show sweep.gif");
    // A section behind a {{where …}} that was not measured is absent: heading, figure and the figure's number.
    const std::string numbers = "runs/03_springs/run/numbers.tsv";
    course.write(numbers, course.read(numbers) + "counted\t\t\tinstructions a step\n");
    course.write(more, title + "{{where counted}}\n## Peers {#more3_peers}\n\n" + sweep +
                           "\n{{end}}\n\n{{figure turn.svg: Round.}}\n");
    CHECK_THAT(fill_more(course),
               ContainsSubstring("Figure\u00a03.2.</span> Round.") && !ContainsSubstring("more3_peers"));
    course.replace(numbers, "counted\t\t\t", "counted\t7\t\t");
    CHECK_THAT(fill_more(course),
               ContainsSubstring("Figure\u00a03.3.</span> Round.") && ContainsSubstring("more3_peers"));
}

TEST_CASE("figures are found on both of a chapter's pages, from each of them and from elsewhere") {
    const Course course;
    move_sweep(course);
    course.replace(chapter, "It grows to {{amplitude}}.", "See {{see spiral.svg}}, {{see sweep.gif}}.");
    course.replace(more, sweep, sweep + "\n\nSee {{see spiral.svg}}, {{see 03_springs/sweep.gif}}.");
    const std::string spiral = "<a href=\"#fig-spiral\">Figure\u00a03.1</a>",
                      film = "<a href=\"#fig-sweep-film\">Figure\u00a03.2</a>";
    const std::string spiral_there = "<a href=\"chapter_03.html#fig-spiral\">Figure\u00a03.1</a>";
    const std::string film_there = "<a href=\"more_03.html#fig-sweep-film\">Figure\u00a03.2</a>";
    CHECK_THAT(course.fill(), ContainsSubstring("See " + spiral + ", " + film_there + "."));
    CHECK_THAT(fill_more(course), ContainsSubstring("See " + spiral_there + ", " + film + "."));

    const std::string see = "See {{see 03_springs/spiral.svg}}, {{see 03_springs/sweep.gif}}.\n";
    page::Context elsewhere{course / "", course / "runs"};
    CHECK_THAT(page::fill(elsewhere, see, "start.md"),
               ContainsSubstring("See " + spiral_there + ", " + film_there + "."));
    CHECK(elsewhere.inputs.count(course / more) == 1);  // so that it is filled anew when the numbers change
}

TEST_CASE("a figure stands on one of a chapter's two pages") {
    const Course course;
    write_more(course, sweep);
    CHECK(course.fill_error() ==
          "chapter.md:30: sweep.gif stands on the page more_03, too: a figure stands on one of a "
          "chapter's two");
    CHECK(more_error(course) ==
          "more.md:3: sweep.gif stands on the page chapter_03, too: a figure stands on one of a "
          "chapter's two");
}

TEST_CASE("a claim may be taught and drawn on the second page, and the talks lead there") {
    const Course course;
    move_sweep(course);
    course.replace(chapter, "{{claims N22}}\n", "");
    course.replace(chapter, "{{figure spiral.svg N22:", "{{figure spiral.svg:");
    CHECK_THAT(course.fill_error(), ContainsSubstring("N22 is claimed, but no section of the page teaches it"));
    write_more(course, "## Steps {#more3_steps}\n{{claims N22}}\n\n{{figure sweep.gif N22: A sweep.}}");
    CHECK(course.fill_error() == "no error");
    std::vector<page::IndexEntry> index;
    CHECK_THAT(fill_more(course, &index), ContainsSubstring("<a class=\"row\" href=\"talks.html#row_N22\">N22</a>"));
    REQUIRE(index.size() == 2);
    CHECK((index[0].kind == "section" && index[0].page == "more_03.html" && index[0].anchor == "more3_steps"));
    CHECK((index[1].kind == "figure" && index[1].page == "more_03.html" && index[1].anchor == "fig-sweep-film"));
}
