// A chapter's page: what is put in, and every way in which it can be wrong.
#include "course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "context.hpp"
#include "error.hpp"
#include "directives.hpp"
#include "fill.hpp"

using Catch::Matchers::ContainsSubstring;

TEST_CASE("a number stands with its unit, its meaning at hand") {
    const Course course;
    CHECK_THAT(course.fill_paragraph("to {{amplitude}}."),
               ContainsSubstring("to <span class=\"number\" title=\"after two seconds\">5.18\u202fm</span>."));
    CHECK_THAT(course.fill_paragraph("{{amplitude.value}}"), ContainsSubstring(">5.18</span>"));
    CHECK_THAT(course.fill_paragraph("{{03_springs/winner}}"), ContainsSubstring(">RK4\\_x</span>"));
    // A quote would end the attribute, a bar a table's cell.
    CHECK_THAT(course.fill_paragraph("{{tiny}}"), ContainsSubstring("title=\"left over, < 1 \u2223 'small'\""));
}

TEST_CASE("formulas become Doxygen's, with numbers in TeX, safe in tables") {
    const Course course;
    CHECK_THAT(course.fill_paragraph("$a\n= {{tiny}}$"),
               ContainsSubstring("\\f$a = -3.2\\times 10^{-16}\\,\\mathrm{m/s^2}\\f$"));
    CHECK_THAT(course.fill_paragraph("$$\na\n$$"), ContainsSubstring("\\f[\na\n\\f]"));
    CHECK_THAT(course.fill_paragraph("| $|a|$ |\n|--|"), ContainsSubstring("| \\f$\\vert a\\vert \\f$ |"));
    CHECK_THAT(course.fill_paragraph("`$a$ {{b}}`"), ContainsSubstring("`$a$ {{b}}`"));
}

TEST_CASE("what could not be measured is not on the page, and a sentence cannot hold it") {
    const Course course;
    const std::string numbers = "runs/03_springs/run/numbers.tsv";
    course.write(numbers, course.read(numbers) + "counted\t\t\tinstructions a step\n");
    CHECK_THAT(course.paragraph_error("It takes {{counted}}."),
               ContainsSubstring("\"counted\" is not measured here; what needs it stands between {{where counted}}"));
    const std::string around = "Before.\n\n{{where counted}}\nIt takes {{counted}}.\n{{end}}\n\nAfter.";
    const std::string without = course.fill_paragraph(around);
    CHECK(without.find("It takes") == std::string::npos);
    CHECK_THAT(without, ContainsSubstring("After."));

    CHECK_THAT(course.fill_paragraph("{{where amplitude}}\nIt is {{amplitude}}.\n{{end}}"),
               ContainsSubstring("It is <span"));
    CHECK_THAT(course.paragraph_error("{{where amplitude}}\nIt is."), ContainsSubstring("without its {{end}}"));
    CHECK_THAT(course.paragraph_error("It is.\n\n{{end}}"), ContainsSubstring("{{end}} without a {{where"));
    CHECK_THAT(course.paragraph_error("{{where amplitude}}\n{{where tiny}}\n{{end}}"),
               ContainsSubstring("within another one"));
    CHECK_THAT(course.paragraph_error("It {{where amplitude}} is."), ContainsSubstring("on a line of its own"));
    CHECK_THAT(course.paragraph_error("{{where nothing_such}}\nIt is.\n{{end}}"), ContainsSubstring("nothing_such"));
}

TEST_CASE("a check mark tells what the run has confirmed") {
    const Course course;
    CHECK_THAT(course.fill_paragraph("It grows {{check grows}}."),
               ContainsSubstring("data-statement=\"the amplitude grows\">✓</span>."));
    const std::string three =
        course.fill_paragraph("It grows {{check grows}}\n{{check grows}} {{check grows}}, and {{check grows}}.");
    CHECK_THAT(
        three,
        ContainsSubstring(
            "It grows\u00a0<span class=\"check\" tabindex=\"0\" role=\"note\" aria-label=\"The run confirms: the "
            "amplitude grows; "
            "the amplitude grows; the amplitude grows\" data-statement=\"the amplitude grows; the amplitude grows; "
            "the amplitude grows\">✓</span>, and\u00a0<span") &&
            ContainsSubstring("data-statement=\"the amplitude grows\">✓</span>."));
}

TEST_CASE("a figure has a size, words for those who cannot see it, and a caption") {
    const Course course;
    const std::string page = course.fill();
    CHECK_THAT(page, ContainsSubstring("<figure id=\"fig-spiral\""));
    CHECK_THAT(page, ContainsSubstring("<a class=\"card\" href=\"figures/03_springs/spiral.svg\"><img "
                                       "src=\"figures/03_springs/spiral.svg\" alt=\"Out.\" width=\"640\" "
                                       "height=\"480\" loading=\"lazy\"></a>"));
    CHECK_THAT(page, ContainsSubstring("**Out.** It reaches <span"));
    CHECK_THAT(page, ContainsSubstring("\\f$x^2\\f$.\n\\htmlonly[block]</figcaption>"));
    CHECK_THAT(page, ContainsSubstring("<a class=\"card\" href=\"figures/03_springs/sweep.still.gif\"><img "
                                       "src=\"figures/03_springs/sweep.still.gif\""));
}

TEST_CASE("figures are numbered in the order of the page, and can be referred to by their names") {
    const Course course;
    course.write("runs/03_springs/run/turn.svg", course.read("runs/03_springs/run/spiral.svg"));
    course.replace("chapters/03_springs/about.json", "\"sweep.gif\"", "\"sweep.gif\", \"turn.svg\"");
    const std::string page = course.fill_paragraph(
        "See {{see sweep.gif}} and {{see 03_springs/spiral.svg}}.\n\n{{figure turn.svg: Round.}}");
    CHECK_THAT(page, ContainsSubstring("<span class=\"figure-number\">Figure\u00a03.1.</span> Round."));
    CHECK_THAT(page, ContainsSubstring("<span class=\"figure-number\">Figure\u00a03.2.</span> **Out.**"));
    CHECK_THAT(
        page,
        ContainsSubstring(
            "See <a href=\"#fig-sweep-film\">Figure\u00a03.3</a> and <a href=\"#fig-spiral\">Figure\u00a03.2</a>."));
    CHECK(course.paragraph_error("{{see turn.svg}}") ==
          "chapter.md:5: turn.svg is no figure of this page nor of its chapter's");
    CHECK_THAT(course.paragraph_error("{{see}}"), ContainsSubstring("{{see file.svg}}"));
}

TEST_CASE("a figure that is drawn for phones, too, is narrow there") {
    const Course course;
    const std::string run = "runs/03_springs/run/";
    course.write(run + "narrow/spiral.svg", "<svg width=\"480\" height=\"400\"></svg>");
    CHECK_THAT(
        course.fill(),
        ContainsSubstring("<a class=\"card\" href=\"figures/03_springs/spiral.svg\"><picture><source "
                          "srcset=\"figures/03_springs/narrow/spiral.svg\" media=\"screen and (max-width: 560px)\" "
                          "width=\"480\" height=\"400\"><img src=\"figures/03_springs/spiral.svg\""));
    course.remove(run + "narrow/spiral.svg");
    CHECK_THAT(course.fill_error(), ContainsSubstring("narrow/spiral.svg"));
}

TEST_CASE("a live panel stands as a picture, and names its module where there is one") {
    const Course course;
    const std::string still = "runs/03_springs/live/swing.svg", module = "runs/03_springs/live/swing.wasm";
    const std::string panel = "{{live swing: **Pull** at it. It swings to {{amplitude}}.}}";
    CHECK(course.paragraph_error(panel) == "chapter.md:5: chapters/03_springs/live/swing.cpp: there is no such panel");
    course.write("chapters/03_springs/live/swing.cpp", "// Swing.\n");
    CHECK_THAT(course.paragraph_error(panel), ContainsSubstring("swing.svg"));
    course.write(still, course.read("runs/03_springs/run/spiral.svg"));
    const std::string stands = course.fill_paragraph(panel);
    CHECK_THAT(stands, ContainsSubstring("<figure id=\"live-swing\" class=\"picture live\" style=\"--width:640px\">"));
    CHECK_THAT(stands, ContainsSubstring("src=\"figures/03_springs/live_swing.svg\" alt=\"Pull at it.\""));
    CHECK_THAT(stands, ContainsSubstring("It swings to <span"));
    CHECK_THAT(stands, ContainsSubstring("Its C++"));

    course.write(module, "bytes");
    CHECK_THAT(course.fill_paragraph(panel), ContainsSubstring("data-live=\"03_springs/swing\" "
                                                               "data-module=\"figures/03_springs/live_swing.wasm\""));
    CHECK_THAT(course.fill_paragraph("{{live 03_springs/swing: Pull.}}"), ContainsSubstring("live-swing"));
    CHECK_THAT(course.paragraph_error(panel + "\n\n{{live 03_springs/swing: Again.}}"),
               ContainsSubstring("swing is shown twice"));
    for (const char* wrong : {"{{live swing}}", "{{live swing: }}", "{{live: Pull.}}", "{{live swing N22: Pull.}}"})
        CHECK_THAT(course.paragraph_error(wrong), ContainsSubstring("a live panel is {{live panel: caption}}"));
}

TEST_CASE("a question folds its answer") {
    const Course course;
    const std::string page = course.fill_paragraph("{{ask: Is 1 < 2?}}\n\nTo {{amplitude}}.\n\n{{answered}}");
    CHECK_THAT(page, ContainsSubstring("<details class=\"ask\"><summary>Is 1 &lt; 2?</summary><div>\\endhtmlonly"));
    CHECK_THAT(page, ContainsSubstring("\\htmlonly[block]</div></details>"));
    for (const char* wrong : {"{{answered}}", "{{ask}}", "{{ask: a}}\n\n{{ask: b}}", "{{ask: a}}\n\n{{answered: b}}"})
        CHECK_THAT(course.paragraph_error(wrong), ContainsSubstring("come by turns"));
    CHECK_THAT(course.paragraph_error("{{ask: a}}\n\nb"), ContainsSubstring("without its {{answered}}"));
}

TEST_CASE("a bar in a table's cell does not end the cell") {
    Course course;
    course.write("runs/03_springs/run/bars.tsv", "what\n|R| = 1 where $|x| < 2$\n");
    CHECK(course.fill_paragraph("{{table bars.tsv}}").find("\\|R\\| = 1 where") != std::string::npos);
}

TEST_CASE("factors and percentages are numbers, flush right also beside words") {
    Course course;
    course.write("runs/03_springs/run/factors.tsv", "what\tleft\tshare\nEuler\t× 1.5\t57 %\nRK4\tgone\t–\n");
    CHECK_THAT(course.fill_paragraph("{{table factors.tsv}}"),
               ContainsSubstring("|---|---:|---:|\n| Euler | ×\u00a01.5 | 57\u202f% |\n| RK4 | gone |"));
}

TEST_CASE("code, the run and tables are quoted") {
    const Course course;
    const std::string page = course.fill_paragraph("{{run: Order}}\n\n{{table costs.tsv}}");
    CHECK_THAT(page, ContainsSubstring("<a href=\"source:include/step.hpp#l00003\">include/step.hpp</a>"));
    CHECK_THAT(page, ContainsSubstring("```cpp\nvoid step() {\n    x += h * v;\n}\n```"));
    CHECK_THAT(page, ContainsSubstring("$ ./course run 3</span>\nIt has x &lt; 3\n"));
    CHECK_THAT(page, ContainsSubstring("$ ./course run 3 --study</span>\nOrder\n-----\n  1.00\n</pre>"));
    CHECK_THAT(page, ContainsSubstring("| method | time step |\n|---|---:|\n"
                                       "| Euler \\f$x\\vert y\\f$ | 10<sup>\u22126</sup> |\n"
                                       "| RK4 | 20\u202f000 |\n"));
}

TEST_CASE("the page shows its program in parts, each line once and in order, and then whole") {
    const Course course;
    const std::string page = course.fill();
    const std::size_t first = page.find("```cpp\n// Springs\nint x;\n```"),
                      second = page.find("```cpp\nint main() {}\n```");
    CHECK(first < second);
    CHECK(second <
          page.find(
              "<summary>The whole program</summary>\\endhtmlonly\n\n```cpp\n// Springs\nint x;\n\nint main() {}\n```"));
    CHECK_THAT(page, ContainsSubstring("<a href=\"source:chapters/03_springs/springs.cpp#l00004\">"));

    const auto error = [](const std::string& from, const std::string& to) {
        const Course other;
        other.replace("chapters/03_springs/chapter.md", from, to);
        return other.fill_error();
    };
    CHECK_THAT(error("{{program: // Springs}}", ""), ContainsSubstring("the program does not begin with \"int main\""));
    CHECK_THAT(error("{{program: int main}}", "{{program: int many}}"),
               ContainsSubstring("the rest of the program has no line that begins with \"int many\""));
    CHECK_THAT(error("{{program: int main}}", "{{program: int main}}\n\n{{program: int x}}"),
               ContainsSubstring("\"int x\""));
    CHECK_THAT(error("\n{{program}}\n", "\n"), ContainsSubstring("does not show the chapter's program"));
    CHECK_THAT(error("{{program}}", "{{program springs}}"), ContainsSubstring("{{program: its first words}}"));
}

TEST_CASE("the command at the program's top stands in a block of its own") {
    const Course course;
    CHECK_THAT(course.paragraph_error("{{compile}}"),
               ContainsSubstring("no line of the program begins with \"//   c++ \""));
    course.replace("chapters/03_springs/springs.cpp", "int x;",
                   "//   c++ -O2 -Iinclude chapters/03_springs/springs.cpp -o springs && ./springs\nint x;");
    CHECK_THAT(
        course.fill_paragraph("{{compile}}"),
        ContainsSubstring(
            "```sh\nc++ -O2 -Iinclude \\\n    chapters/03_springs/springs.cpp -o springs \\\n    && ./springs\n```"));
    CHECK_THAT(course.paragraph_error("{{compile: this}}"), ContainsSubstring("{{compile}} takes nothing"));
    CHECK_THAT(course.paragraph_error("Type {{compile}}."), ContainsSubstring("on a line of its own"));
}

TEST_CASE("the page stands under its title, with badges of the talks' rows") {
    const Course course;
    const std::string page = course.fill();
    CHECK(page.starts_with("# 3 · Springs {#chapter_03}\n\n[TOC]\n"));
    CHECK_THAT(page, !ContainsSubstring("\n# Springs"));
    CHECK_THAT(page, ContainsSubstring(
                         "<div class=\"facts\">Chapter 3 of 1 · 5 minutes to read · <code>./course run 3</code>: "));
    CHECK_THAT(page, ContainsSubstring("runs in 0.42\u202fs"));
    CHECK_THAT(page, ContainsSubstring("<a class=\"row\" href=\"talks.html#row_N22\">N22</a>"));
}

TEST_CASE("chapters know their neighbours") {
    const Course course;
    course.write("chapters/04_more/about.json",
                 R"({"title": "More", "question": "?", "claims": [], "picture": "a.svg", "figures": ["a.svg"]})");
    const std::string page = course.fill();
    CHECK_THAT(page, ContainsSubstring("<span class=\"next\">\\ref chapter_04 \"4 · More\"</span>"));
    CHECK_THAT(page, !ContainsSubstring("class=\"previous\""));
}

TEST_CASE("exercises stand in order on the chapter's page, and in full on pages of their own") {
    const Course course;
    CHECK_THAT(course.fill_paragraph("{{exercises}}"), !ContainsSubstring("| exercise |"));  // none yet
    const std::string about = R"JSON("level": "easy", "practises": "a * b",
        "declaration": "double f(double x)", "hints": ["Look.", "Look < closer."]})JSON";
    std::string of_second = about;
    of_second.replace(of_second.find("double f(double x)"), 18,
                      "int long_one(const std::map<int, double>& all, double first, double second)");
    course.write("tests/exercises/03_springs/second/about.json",
                 "{\"number\": 2, \"title\": \"The \\\"second\\\"\"," + of_second);
    course.write("tests/exercises/03_springs/first/about.json", "{\"number\": 1, \"title\": \"The first\"," + about);
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
    CHECK(course.paragraph_error("{{exercises}}") ==
          "tests/exercises/03_springs/first/about.json:1: \"title\" must be a string");
}

TEST_CASE("a name that the run does not know is an error at its line") {
    const Course course;
    CHECK(course.paragraph_error("{{none}}") == "chapter.md:5: the run of 03_springs has no number \"none\"");
    CHECK(course.paragraph_error("a\nb {{check none}}") ==
          "chapter.md:6: the run of 03_springs made no check \"none\"");
    CHECK(course.paragraph_error("$x = {{none}}$") == "chapter.md:5: the run of 03_springs has no number \"none\"");
    CHECK(course.paragraph_error("{{04_more/x}}") == "chapter.md:5: there is no run of 04_more");
    CHECK(course.paragraph_error("{{table none.tsv}}") == "chapter.md:5: the run of 03_springs left no none.tsv");
    CHECK(course.paragraph_error("{{run: None}}") == "chapter.md:5: the run of 03_springs prints no heading \"None\"");
    CHECK(course.paragraph_error("{{code include/step.hpp none}}") ==
          "chapter.md:5: [none] stands 0 times in include/step.hpp instead of twice");
    CHECK(course.paragraph_error("{{figure none.svg: a\nb}}") ==
          "chapter.md:5: none.svg is not among the figures in chapters/03_springs/about.json");
    CHECK(course.paragraph_error("{{figure sweep.gif: a}}") == "chapter.md:30: sweep.gif is shown twice on this page");
    CHECK(course.paragraph_error("{{figure sweep.gif: a\n\nb}}") == "chapter.md:5: this {{ has no closing }}");
    CHECK(course.paragraph_error("{{figure sweep.gif: a\nb {{none}}}}") ==
          "chapter.md:6: the run of 03_springs has no number \"none\"");
}

TEST_CASE("what is misused is named with the line that wrote it") {
    const Course course;
    CHECK(course.paragraph_error("{{lost}}") ==
          "chapter.md:5: the number \"lost\" is \"nan\" (written at chapters/03_springs/study/growth.cpp:31)");
    CHECK(course.paragraph_error("{{grows}}") ==
          "chapter.md:5: the run of 03_springs has no number \"grows\", but a check of that name "
          "(written at chapters/03_springs/study/growth.cpp:40)");
    CHECK(course.paragraph_error("{{check amplitude}}") ==
          "chapter.md:5: the run of 03_springs made no check \"amplitude\", but has a number of that name "
          "(written at chapters/03_springs/study/growth.cpp:12)");
    course.write("runs/03_springs/run/costs.tsv", "method\ttime\n");
    CHECK_THAT(course.paragraph_error("{{table costs.tsv}}"),
               ContainsSubstring("is a table without rows (written at chapters/03_springs/study/costs.cpp:7)"));
    // A run that does not say, as one from elsewhere.
    course.write("runs/03_springs/run/places.tsv", "");
    CHECK(course.paragraph_error("{{lost}}") == "chapter.md:5: the number \"lost\" is \"nan\"");
}

TEST_CASE("a directive in the wrong form is an error") {
    const Course course;
    CHECK(course.paragraph_error("{{}}") == "chapter.md:5: there is nothing between {{ and }}");
    CHECK(course.paragraph_error("{{ampli tude}}") == "chapter.md:5: there is no {{ampli …}}");
    CHECK(course.paragraph_error("a {{run}}") == "chapter.md:5: {{run …}} must stand on a line of its own");
    CHECK(course.paragraph_error("{{figure sweep.gif:}}") ==
          "chapter.md:5: a figure is {{figure file.svg N22: caption}}");
    CHECK(course.paragraph_error("{{code}}") ==
          "chapter.md:5: a quotation is {{code file tag}}, or {{code file}} for all of it");
    CHECK(course.paragraph_error("{{code include/none.hpp}}") == "chapter.md:5: there is no file include/none.hpp");
    CHECK(course.paragraph_error("{{code include/step.hpp step: no such words}}") ==
          "chapter.md:5: 0 of the quoted lines hold \"no such words\", instead of the one that matters");
    CHECK_THAT(course.fill_paragraph("{{code include/step.hpp step: x += h * v}}"),
               ContainsSubstring("<figure class=\"listing\" data-line=\"2\">"));
    CHECK(course.paragraph_error("text\n\n{{claims N22}}") ==
          "chapter.md:7: {{claims N22 N24}} stands directly below a heading that has an id");
    CHECK(course.paragraph_error("{{claims N23}}") == "chapter.md:5: \"N23\" is none of this chapter's claims");
    CHECK(course.paragraph_error("### The $x$ {#ch3_x}") ==
          "chapter.md:5: a heading stands in the tree and in the search as plain text: no formula "
          "and "
          "no number in it");
}

TEST_CASE("a method's line looks as in the figures") {
    const Course course;
    course.write("tools/figures/style.gp",
                 "dropped = \"lc rgb '#b15a98' lw 2.5 dt (14,5)\"\nkept    = \"lc rgb '#009e73' lw 2 dt 1\"\n");
    CHECK_THAT(course.fill_paragraph("a {{line kept}} b"),
               ContainsSubstring("a <span class=\"line\" style=\"border-top: 3px solid #009e73\"></span> b"));
    CHECK_THAT(course.fill_paragraph("{{line dropped}}"), ContainsSubstring("3px dashed #b15a98"));
    CHECK(course.paragraph_error("{{line lost}}") == "chapter.md:5: tools/figures/style.gp draws no line \"lost\"");
}

TEST_CASE("a chapter needs a title and no section; a section's id says whose it is") {
    const Course course;
    const std::string file = "chapters/03_springs/chapter.md";
    course.replace(file, "## In the talk {#ch3_in_the_talk}\n", "");
    course.replace(file, "## The code {#ch3_code}\n", "## Steps of a spring {#ch3_spring}\n");
    CHECK(course.fill_error() == "no error");
    course.replace(file, "{#ch3_spring}", "{#spring}");
    CHECK(course.fill_error() == "chapter.md:12: a ## section must have an id that begins {#ch3_");
    course.replace(file, "# Springs", "# Strings");
    CHECK(course.fill_error() == "chapter.md:1: the page's title must be that of about.json: Springs");
}

TEST_CASE("a chapter shows all its figures and teaches all its rows") {
    const Course course;
    const std::string file = "chapters/03_springs/chapter.md";
    course.replace(file, "{{figure sweep.gif: A sweep.}}", "");
    CHECK(course.fill_error() == "chapters/03_springs/about.json:1: the page does not show sweep.gif");
    course.replace(file, "{{claims N22}}", "");
    course.replace("chapters/03_springs/about.json", ", \"sweep.gif\"", "");
    CHECK(course.fill_error() ==
          "chapters/03_springs/about.json:1: N22 is claimed, but no section of "
          "the page teaches it ({{claims N22}})");
}

TEST_CASE("words that a run left stand on the page as they are") {
    const Course course;
    course.write("runs/03_springs/run/wrong.txt", "$ c++ wrong.cpp\nwrong.cpp:1: error: a < b {{x}}\n");
    const std::string page = course.fill_paragraph("{{said wrong.txt}}");
    CHECK(page.find("<pre class=\"run said\">$ c++ wrong.cpp\nwrong.cpp:1: error: a &lt; b {{x}}\n</pre>") !=
          std::string::npos);
    CHECK(course.paragraph_error("{{said none.txt}}") == "chapter.md:5: the run of 03_springs left no none.txt");
    CHECK(course.paragraph_error("{{said}}") == "chapter.md:5: what a program said is {{said file.txt}}");
    CHECK(course.paragraph_error("a {{said wrong.txt}}") == "chapter.md:5: {{said …}} must stand on a line of its own");
    course.write("runs/03_springs/run/empty.txt", "\n");
    CHECK(course.paragraph_error("{{said empty.txt}}") == "chapter.md:5: empty.txt holds no word");
}

TEST_CASE("a draft has gaps where something comes from a run that is still to be made") {
    const Course course;
    std::filesystem::remove_all(course / "runs/03_springs");
    const auto draft = [&] {
        page::Context context{course / "", course / "runs"};
        context.draft = true;
        context.set_chapter("03_springs");
        return page::fill(context, course.read("chapters/03_springs/chapter.md"), "chapter.md");
    };
    const std::string page = draft();
    CHECK_THAT(page, ContainsSubstring("<b>This page is being made.</b>"));
    CHECK_THAT(page, ContainsSubstring("It grows to <span class=\"gap\">(…)</span>."));
    CHECK_THAT(page, ContainsSubstring("<div class=\"gap\" id=\"fig-spiral\">Not there yet"));
    CHECK_THAT(page, ContainsSubstring("## Break it {#ch3_break_it}"));
    CHECK_THAT(page, ContainsSubstring("x += h * v;"));
    // What is misspelt is not taken for what is still to come.
    course.replace("chapters/03_springs/chapter.md", "include/step.hpp step", "include/step.hpp stop");
    CHECK_THROWS_AS(draft(), page::Error);
}

TEST_CASE("a draft of what is all there is the page itself, and a misspelt number is an error in it") {
    const Course course;
    course.write("runs/03_springs/run/done", "");
    const auto draft = [&] {
        page::Context context{course / "", course / "runs"};
        context.draft = true;
        context.set_chapter("03_springs");
        return page::fill(context, course.read("chapters/03_springs/chapter.md"), "chapter.md");
    };
    CHECK(draft() == course.fill());
    course.replace("chapters/03_springs/chapter.md", "It grows to {{amplitude}}", "It grows to {{amplitud}}");
    CHECK_THROWS_AS(draft(), page::Error);
}
