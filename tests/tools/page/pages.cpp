// A chapter's page: what is put in, and every way in which it can be wrong.
#include "course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "context.hpp"
#include "text.hpp"
#include "directives.hpp"

using Catch::Matchers::ContainsSubstring;

namespace {

const std::string chapter = "chapters/03_springs/chapter.md", run = "runs/03_springs/run/",
                  about = "chapters/03_springs/about.json";

}  // namespace

TEST_CASE("a directive is replaced by what the run or a source has for it") {
    const Course course;
    course.write("tools/figures/style.gp",
                 "dropped = \"lc rgb '#b15a98' lw 2.5 dt (14,5)\"\nkept    = \"lc rgb '#009e73' lw 2 dt 1\"\n");
    course.write(run + "bars.tsv", "what\n|R| = 1 where $|x| < 2$\n");
    course.write(run + "factors.tsv", "what\tleft\tshare\nEuler\t× 1.5\t57 %\nRK4\tgone\t–\n");
    course.write(run + "wrong.txt", "$ c++ wrong.cpp\nwrong.cpp:1: error: a < b {{x}}\n");
    course.shows({
        {"to {{amplitude}}.", "to <span class=\"number\" title=\"after two seconds\">5.18\u202fm</span>."},
        {"{{amplitude.value}}", ">5.18</span>"},
        {"{{03_springs/winner}}", ">RK4\\_x</span>"},
        // A quote would end the attribute, a bar a table's cell.
        {"{{tiny}}", "title=\"left over, < 1 \u2223 'small'\""},
        {"$a\n= {{tiny}}$", "\\f$a = -3.2\\times 10^{-16}\\,\\mathrm{m/s^2}\\f$"},
        {"$$\na\n$$", "\\f[\na\n\\f]"},
        {"| $|a|$ |\n|--|", "| \\f$\\vert a\\vert \\f$ |"},
        {"`$a$ {{b}}`", "`$a$ {{b}}`"},
        {"It grows {{check grows}}.", "data-statement=\"the amplitude grows\">✓</span>."},
        {"It {{check grows}}\n{{check grows}}, and", "data-statement=\"the amplitude grows; the amplitude grows\">✓</"},
        {"{{table costs.tsv}}",
         "| method | time step |\n|---|---:|\n| Euler \\f$x\\vert y\\f$ | 10<sup>\u22126</sup> |\n| RK4 | 20\u202f000 "
         "|\n"},
        {"{{table bars.tsv}}", "\\|R\\| = 1 where"},
        // Factors and percentages are numbers, flush right beside words, too.
        {"{{table factors.tsv}}", "|---|---:|---:|\n| Euler | ×\u00a01.5 | 57\u202f% |\n| RK4 | gone |"},
        {"", "<a href=\"source:include/step.hpp#l00003\">include/step.hpp</a>"},
        {"", "```cpp\nvoid step() {\n    x += h * v;\n}\n```"},
        {"{{code include/step.hpp step: x += h * v}}", "<figure class=\"listing\" data-line=\"2\">"},
        {"", "$ ./course run 3</span>\nIt has x &lt; 3\n"},
        {"{{run: Order}}", "$ ./course run 3 --study</span>\nOrder\n-----\n  1.00\n</pre>"},
        {"{{said wrong.txt}}", "<pre class=\"run said\">$ c++ wrong.cpp\nwrong.cpp:1: error: a &lt; b {{x}}\n</pre>"},
        {"a {{line kept}} b", "a <span class=\"line\" style=\"border-top: 3px solid #009e73\"></span> b"},
        {"{{line dropped}}", "3px dashed #b15a98"},
        {"{{ask: Is 1 < 2?}}\n\nTo {{amplitude}}.\n\n{{answered}}",
         "<details class=\"ask\"><summary>Is 1 &lt; 2?</summary><div>\\endhtmlonly"},
        {"{{where amplitude}}\nIt is {{amplitude}}.\n{{end}}", "It is <span"},
    });
}

TEST_CASE("a name that does not exist is an error at its line") {
    const Course course;
    course.write("tools/figures/style.gp", "");
    course.write(run + "empty.txt", "\n");
    course.refuses({
        {"{{none}}", "chapter.md:5: the run of 03_springs has no number \"none\""},
        {"a\nb {{check none}}", "chapter.md:6: the run of 03_springs made no check \"none\""},
        {"$x = {{none}}$", "chapter.md:5: the run of 03_springs has no number \"none\""},
        {"{{04_more/x}}", "chapter.md:5: there is no run of 04_more"},
        {"{{table none.tsv}}", "chapter.md:5: the run of 03_springs left no none.tsv"},
        {"{{said empty.txt}}", "chapter.md:5: empty.txt holds no word"},
        {"{{run: None}}", "chapter.md:5: the run of 03_springs prints no heading \"None\""},
        {"{{code include/none.hpp}}", "chapter.md:5: there is no file include/none.hpp"},
        {"{{code include/step.hpp step: no words}}", "chapter.md:5: 0 of the quoted lines hold \"no words\", instead"},
        {"{{figure none.svg: a\nb}}", "chapter.md:5: none.svg is not among the figures in " + about},
        {"{{figure sweep.gif: a}}", "chapter.md:30: sweep.gif is shown twice on this page"},
        {"{{figure sweep.gif: a\nb {{none}}}}", "chapter.md:6: the run of 03_springs has no number"},
        {"{{see none.svg}}", "chapter.md:5: none.svg is no figure of this page nor of its chapter's"},
        {"{{line lost}}", "chapter.md:5: tools/figures/style.gp draws no line \"lost\""},
        {"{{claims N23}}", "chapter.md:5: \"N23\" is none of this chapter's claims"},
        {"{{live none: Pull.}}", "chapter.md:5: chapters/03_springs/live/none.cpp: there is no such panel"},
    });
}

TEST_CASE("what is misused is named with the line that wrote it") {
    const Course course;
    course.write(run + "costs.tsv", "method\ttime\n");
    course.refuses({
        {"{{lost}}",
         "chapter.md:5: the number \"lost\" is \"nan\" (written at chapters/03_springs/study/growth.cpp:31)"},
        {"{{grows}}",
         "has no number \"grows\", but a check of that name (written at chapters/03_springs/study/growth.cpp:40)"},
        {"{{check amplitude}}",
         "made no check \"amplitude\", but has a number of that name (written at "
         "chapters/03_springs/study/growth.cpp:12)"},
        {"{{table costs.tsv}}", "is a table without rows (written at chapters/03_springs/study/costs.cpp:7)"},
    });
}

TEST_CASE("a directive in the wrong form is an error") {
    const Course course;
    course.refuses({
        {"{{}}", "chapter.md:5: there is nothing between {{ and }}"},
        {"{{ampli tude}}", "chapter.md:5: there is no {{ampli …}}"},
        {"a {{run}}", "chapter.md:5: {{run …}} must stand on a line of its own"},
        {"{{figure sweep.gif:}}", "chapter.md:5: a figure is {{figure file.svg N22: caption}}"},
        {"{{compile}}", "no line of the program begins with \"//   c++ \""},
        {"text\n\n{{claims N22}}", "chapter.md:7: {{claims N22 N24}} stands directly below a heading that has an id"},
        {"### The $x$ {#ch3_x}", "chapter.md:5: a heading stands in the tree and in the search as plain text"},
        {"{{answered}}", "come by turns"},
        {"{{ask: a}}\n\nb", "without its {{answered}}"},
        {"{{where amplitude}}\nIt is.", "without its {{end}}"},
        {"It is.\n\n{{end}}", "{{end}} without a {{where"},
        {"It {{where amplitude}} is.", "on a line of its own"},
    });
}

TEST_CASE("what could not be measured is not on the page, and a sentence cannot hold it") {
    const Course course;
    course.write(run + "numbers.tsv", course.read(run + "numbers.tsv") + "counted\t\t\tinstructions a step\n");
    course.refuses({{"It takes {{counted}}.",
                     "\"counted\" is not measured here; what needs it stands between {{where counted}}"}});
    CHECK_THAT(course.fill_paragraph("{{where counted}}\nIt takes {{counted}}.\n{{end}}\n\nAfter."),
               ContainsSubstring("After.") && !ContainsSubstring("It takes"));
}

TEST_CASE("a figure has a number, a size, words for those who cannot see it, and a caption") {
    const Course course;
    course.write(run + "turn.svg", course.read(run + "spiral.svg"));
    course.replace(about, "\"sweep.gif\"", "\"sweep.gif\", \"turn.svg\"");
    const std::string page = course.fill_paragraph(
        "See {{see sweep.gif}} and {{see 03_springs/spiral.svg}}.\n\n{{figure turn.svg: Round.}}");
    for (const char* part :
         {"<span class=\"figure-number\">Figure\u00a03.1.</span> Round.", "<figure id=\"fig-spiral\"",
          "<a class=\"card\" href=\"figures/03_springs/spiral.svg\"><img src=\"figures/03_springs/spiral.svg\" "
          "alt=\"Out.\" width=\"640\" height=\"480\" loading=\"lazy\"></a>",
          "<span class=\"figure-number\">Figure\u00a03.2.</span> **Out.** It reaches <span",
          "\\f$x^2\\f$.\n\\htmlonly[block]</figcaption>",
          "<a class=\"card\" href=\"figures/03_springs/sweep.still.gif\"><img",
          "See <a href=\"#fig-sweep-film\">Figure\u00a03.3</a> and <a href=\"#fig-spiral\">Figure\u00a03.2</a>."})
        CHECK_THAT(page, ContainsSubstring(part));
}

TEST_CASE("a figure that is drawn for phones, too, is narrow there") {
    const Course course;
    course.write(run + "narrow/spiral.svg", "<svg width=\"480\" height=\"400\"></svg>");
    CHECK_THAT(course.fill(),
               ContainsSubstring("<picture><source srcset=\"figures/03_springs/narrow/spiral.svg\" media=\"screen and "
                                 "(max-width: 560px)\" width=\"480\" height=\"400\"><img src=\"figures/03_springs/"));
    course.remove(run + "narrow/spiral.svg");
    CHECK_THAT(course.fill_error(), ContainsSubstring("narrow/spiral.svg"));
}

TEST_CASE("a live panel stands as a picture, and names its module where there is one") {
    const Course course;
    const std::string panel = "{{live swing: **Pull** at it. It swings to {{amplitude}}.}}";
    course.write("chapters/03_springs/live/swing.cpp", "// Swing.\n");
    course.refuses({{panel, "swing.svg"}});
    course.write("runs/03_springs/live/swing.svg", course.read(run + "spiral.svg"));
    course.shows({{panel, "<figure id=\"live-swing\" class=\"picture live\" style=\"--width:640px\">"},
                  {panel, "src=\"figures/03_springs/live_swing.svg\" alt=\"Pull at it.\""},
                  {panel, "It swings to <span"},
                  {panel, "Its C++"}});
    course.write("runs/03_springs/live/swing.wasm", "bytes");
    course.shows({{"{{live 03_springs/swing: Pull.}}",
                   "data-live=\"03_springs/swing\" data-module=\"figures/03_springs/live_swing.wasm\""}});
    course.refuses({{panel + "\n\n{{live 03_springs/swing: Again.}}", "swing is shown twice"}});
}

TEST_CASE("the page shows its program in parts, each line once and in order, and then whole") {
    const Course course;
    const std::string page = course.fill();
    const std::size_t first = page.find("```cpp\n// Springs\nint x;\n```"),
                      second = page.find("```cpp\nint main() {}\n```"),
                      whole = page.find(
                          "The whole program</summary>\\endhtmlonly\n\n```cpp\n// Springs\nint x;\n\n"
                          "int main() {}\n```");
    CHECK((first < second && second < whole && whole < page.size()));
    CHECK_THAT(page, ContainsSubstring("<a href=\"source:chapters/03_springs/springs.cpp#l00004\">"));
    const std::string cases[][3] = {
        {"{{program: // Springs}}", "", "the program does not begin with \"int main\""},
        {"{{program: int main}}", "{{program: int many}}", "the rest of the program has no line that begins with"},
        {"{{program: int main}}", "{{program: int main}}\n\n{{program: int x}}", "\"int x\""},
        {"\n{{program}}\n", "\n", "does not show the chapter's program"},
        {"{{program}}", "{{program springs}}", "{{program: its first words}}"}};
    for (const auto& [from, to, error] : cases) {
        const Course other;
        other.replace(chapter, from, to);
        CHECK_THAT(other.fill_error(), ContainsSubstring(error));
    }
    course.replace("chapters/03_springs/springs.cpp", "int x;",
                   "//   c++ -O2 -Iinclude chapters/03_springs/springs.cpp -o springs && ./springs\nint x;");
    course.shows({{"{{compile}}",
                   "```sh\nc++ -O2 -Iinclude \\\n    chapters/03_springs/springs.cpp -o springs \\\n    && "
                   "./springs\n```"}});
}

TEST_CASE("the page stands under its title, with its facts, badges of the talks' rows and its neighbours") {
    const Course course;
    course.write("chapters/04_more/about.json",
                 R"({"title": "More", "question": "?", "claims": [], "picture": "a.svg", "figures": ["a.svg"]})");
    const std::string page = course.fill();
    CHECK(page.starts_with("# 3 · Springs {#chapter_03}\n\n[TOC]\n"));
    CHECK_THAT(page, !ContainsSubstring("\n# Springs") && !ContainsSubstring("class=\"previous\""));
    for (const char* part : {"<div class=\"facts\">Chapter 3 of 2 · 5 minutes to read · <code>./course run 3</code>: ",
                             "runs in 0.42\u202fs", "<a class=\"row\" href=\"talks.html#row_N22\">N22</a>",
                             "<span class=\"next\">\\ref chapter_04 \"4 · More\"</span>"})
        CHECK_THAT(page, ContainsSubstring(part));
}

TEST_CASE("a chapter needs its title and no section, and shows all that its about.json names") {
    const Course course;
    const auto change = [&](const std::string& file, const std::string& from, const std::string& to) {
        course.replace(file, from, to);
        return course.fill_error();
    };
    CHECK(change(chapter, "## The code {#ch3_code}\n", "## Steps of a spring {#ch3_spring}\n") == "no error");
    CHECK(change(chapter, "{#ch3_spring}", "{#spring}") ==
          "chapter.md:12: a section must have an id that begins {#ch3_");
    CHECK(change(chapter, "# Springs", "# Strings") ==
          "chapter.md:1: the page's title must be that of about.json: Springs");
    course.replace(chapter, "# Strings", "# Springs");
    course.replace(chapter, "{#spring}", "{#ch3_spring}");
    CHECK(change(chapter, "{{figure sweep.gif: A sweep.}}", "") == about + ":1: the page does not show sweep.gif");
    course.replace(about, ", \"sweep.gif\"", "");
    CHECK(change(chapter, "{{claims N22}}", "") ==
          about + ":1: N22 is claimed, but no section of the page teaches it ({{claims N22}})");
}

TEST_CASE("exercises stand in order on the chapter's page, and in full on pages of their own") {
    const Course course;
    CHECK_THAT(course.fill_paragraph("{{exercises}}"), !ContainsSubstring("| exercise |"));  // none yet
    const std::string rest = R"JSON("level": "easy", "practises": "a * b",
        "declaration": "double f(double x)", "hints": ["Look.", "Look < closer."]})JSON";
    std::string of_second = rest;
    of_second.replace(of_second.find("double f(double x)"), 18,
                      "int long_one(const std::map<int, double>& all, double first, double second)");
    course.write("tests/exercises/03_springs/second/about.json",
                 "{\"number\": 2, \"title\": \"The \\\"second\\\"\"," + of_second);
    course.write("tests/exercises/03_springs/first/about.json", "{\"number\": 1, \"title\": \"The first\"," + rest);
    for (const char* name : {"first", "second"})
        course.write(
            "solutions/03_springs/" + std::string(name) + ".cpp",
            "// Title\n//\n// You have\n// $a < b$ < `f(*x)`:\n//\n//     y = |x| h_{old}\n//\n//   x     in m,\n//"
            "         $|x| size (1)$ below 1\n//   y, z  in s\n//\n// Example:\n"
            "// $\\sin x = \\text{for all }n$.\n\nint code;\n// no task\n");
    const std::string brief = course.fill_paragraph("{{exercises}}");
    CHECK_THAT(brief, ContainsSubstring("| 3.1 | \\ref exercise_first \"The first\" | a \\* b | easy |\n"
                                        "| 3.2 | \\ref exercise_second \"The 'second'\" |"));

    page::Context context{course / "", course / "runs"};
    const std::string full = page::fill(context, "# E {#e}\n\n{{exercises}}\n", "e.md");
    CHECK_THAT(full, ContainsSubstring("\\subpage exercises_3 \"3 · Springs\""));
    CHECK_THAT(full, ContainsSubstring("| 3.1 | \\ref exercise_first \"The first\" |"));
    REQUIRE(context.pages.size() == 1);
    const std::string tasks = context.pages.at("exercises_3.md");
    CHECK(tasks.rfind("# Exercises: 3 · Springs {#exercises_3}\n", 0) == 0);
    CHECK_THAT(tasks, ContainsSubstring("## 3.1 The first {#exercise_first}"));
    CHECK_THAT(tasks, ContainsSubstring("```cpp\ndouble f(double x)\n```"));
    CHECK_THAT(tasks, ContainsSubstring(
                          "You have \\f$a < b\\f$ \\< `f(*x)`:\n\n\\f[\\begin{aligned}&y = \\vert x\\vert  "
                          "h_{\\mathit{old}}\n\\end{aligned}\\f]\n\n| name | what it is |\n|---|---|\n| `x` | in m, "
                          "\\f$\\vert x\\vert  \\mathit{size}\\, (1)\\f$ below 1 |\n| `y, z` | in s |\n\nExample: "
                          "\\f$\\sin x = \\text{for all }n\\f$.\n"));
    CHECK_THAT(tasks,
               ContainsSubstring("```cpp\nint long_one(\n    const std::map<int, double>& all,\n    double first,\n"
                                 "    double second)\n```"));
    CHECK_THAT(tasks, ContainsSubstring("Look \\< closer."));
    CHECK_THAT(tasks, !ContainsSubstring("code") && !ContainsSubstring("no task"));
    CHECK(context.inputs.count(course / "solutions/03_springs/first.cpp") == 1);

    course.write("tests/exercises/03_springs/first/about.json", "{\"number\": 1}");
    CHECK_THAT(course.paragraph_error("{{exercises}}"),
               ContainsSubstring("tests/exercises/03_springs/first/about.json:1: ") && ContainsSubstring("'title'"));
}

TEST_CASE("a draft has gaps where something comes from a run that is still to be made") {
    const Course course;
    const auto draft = [&] {
        page::Context context{course / "", course / "runs"};
        context.draft = true;
        context.set_chapter("03_springs");
        return page::fill(context, course.read(chapter), "chapter.md");
    };
    // What is there is the page itself, and a misspelt number is an error in it.
    course.write(run + "done", "");
    CHECK(draft() == course.fill());
    course.replace(chapter, "to {{amplitude}}", "to {{amplitud}}");
    CHECK_THROWS_AS(draft(), page::Error);
    course.replace(chapter, "{{amplitud}}", "{{amplitude}}");

    std::filesystem::remove_all(course / "runs/03_springs");
    const std::string page = draft();
    for (const char* part :
         {"<b>This page is being made.</b>", "It grows to <span class=\"gap\">(…)</span>.",
          "<div class=\"gap\" id=\"fig-spiral\">Not there yet", "## Break it {#ch3_break_it}", "x += h * v;"})
        CHECK_THAT(page, ContainsSubstring(part));
    course.replace(chapter, "include/step.hpp step", "include/step.hpp stop");
    CHECK_THROWS_AS(draft(), page::Error);
}
