// How a source is taken apart.
#include "scanner.hpp"

#include "error.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

using page::scan;
using Kind = page::Piece::Kind;
using Catch::Matchers::Message;

namespace {

std::vector<Kind> kinds(const std::string& source) {
    std::vector<Kind> found;
    for (const page::Piece& piece : scan(source, "page.md")) found.push_back(piece.kind);
    return found;
}

}  // namespace

TEST_CASE("text, formulas, code and directives are told apart") {
    const auto pieces = scan("a $x$ `b` {{c}}\n", "page.md");
    REQUIRE(pieces.size() == 7);
    CHECK(pieces[1].kind == Kind::formula);
    CHECK(pieces[1].text == "x");
    CHECK(pieces[3].kind == Kind::code);
    CHECK(pieces[3].text == "`b`");
    CHECK(pieces[5].kind == Kind::directive);
    CHECK(pieces[5].text == "c");
}

TEST_CASE("code is left alone, whatever stands in it") {
    CHECK(kinds("```cpp\n$x {{y}}\n# no heading\n```") == std::vector{Kind::code});
    CHECK(kinds("~~~\n```\n$\n~~~") == std::vector{Kind::code});
    CHECK(kinds("`$x {{y}}`") == std::vector{Kind::code});
    CHECK(kinds("``a ` $ b``") == std::vector{Kind::code});
}

TEST_CASE("a dollar is a dollar when escaped or before a blank") {
    CHECK(kinds("5 \\$ and \\$") == std::vector{Kind::text});
    CHECK(kinds("5 $ is cheap") == std::vector{Kind::text});
    CHECK(scan("$a \\$ b$", "page.md").front().text == "a \\$ b");
}

TEST_CASE("a display formula may span lines, a formula a paragraph") {
    CHECK(scan("$$\na\n= b\n$$", "page.md").front().kind == Kind::display);
    CHECK(scan("$a\n= b$", "page.md").front().text == "a\n= b");
}

TEST_CASE("a caption holds numbers, code and formulas with braces of their own") {
    const std::string caption = "figure a.svg: {{x}}, $\\frac{a}{\\sqrt{b}}$ and `}}`";
    const auto pieces = scan("{{" + caption + "}}", "page.md");
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0].text == caption);
}

TEST_CASE("pieces know their line, and whether they have it to themselves") {
    const auto pieces = scan("one\ntwo {{a}}\n  {{b}}  \n| {{c}} |\n", "page.md", 10);
    REQUIRE(pieces.size() == 7);
    CHECK(pieces[1].line == 11);
    CHECK_FALSE(pieces[1].own_line);
    CHECK(pieces[3].line == 12);
    CHECK(pieces[3].own_line);
    CHECK_FALSE(pieces[3].in_table);
    CHECK(pieces[5].in_table);
}

TEST_CASE("a heading's level, title and id") {
    const page::Heading heading = page::parse_heading("### The spiral {#ch3_spiral}");
    CHECK(heading.level == 3);
    CHECK(heading.title == "The spiral");
    CHECK(heading.id == "ch3_spiral");
    CHECK(page::parse_heading("# Title").id.empty());
    CHECK(kinds("#include") == std::vector{Kind::text});
}

TEST_CASE("what is opened and never closed is an error at its line") {
    const auto message = [](const std::string& source) -> std::string {
        try {
            scan(source, "page.md");
            return "no error";
        } catch (const page::Error& wrong) {
            return wrong.what();
        }
    };
    CHECK(message("\n$x\n\nb$") == "page.md:2: this formula has no closing $ (write \\$ for a dollar)");
    CHECK(message("a\n$$x") == "page.md:2: this formula has no closing $$ (write \\$ for a dollar)");
    CHECK(message("{{x\n\n}}") == "page.md:1: this {{ has no closing }}");
    CHECK(message("a `b\n\nc`") == "page.md:1: this inline code has no closing backtick");
    CHECK(message("\n\n```\ncode\n``") == "page.md:3: this code fence has no end");
}
