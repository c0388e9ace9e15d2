// How a source is taken apart.
#include "scanner.hpp"

#include "course.hpp"

#include "text.hpp"

#include <catch2/catch_test_macros.hpp>

using page::scan;
using Kind = page::Piece::Kind;

TEST_CASE("text, formulas, code and directives are told apart") {
    const std::string caption = "figure a.svg: {{x}}, $\\frac{a}{\\sqrt{b}}$ and `}}`";
    const struct {
        std::string source;
        Kind kind;
        std::string text;
    } cases[] = {
        {"$x$", Kind::formula, "x"},
        {"$a \\$ b$", Kind::formula, "a \\$ b"},
        {"$a\n= b$", Kind::formula, "a\n= b"},
        {"$$\na\n= b\n$$", Kind::display, "\na\n= b\n"},
        {"`$x {{y}}`", Kind::code, "`$x {{y}}`"},
        {"``a ` $ b``", Kind::code, "``a ` $ b``"},
        {"```cpp\n$x {{y}}\n# no heading\n```", Kind::code, "```cpp\n$x {{y}}\n# no heading\n```"},
        {"~~~\n```\n$\n~~~", Kind::code, "~~~\n```\n$\n~~~"},
        {"5 \\$ and \\$", Kind::text, "5 \\$ and \\$"},
        {"5 $ is cheap", Kind::text, "5 $ is cheap"},
        {"#include", Kind::text, "#include"},
        // A caption holds numbers, code and formulas with braces of their own.
        {"{{" + caption + "}}", Kind::directive, caption},
    };
    for (const auto& [source, kind, text] : cases) {
        CAPTURE(source);
        const auto pieces = scan(source, "page.md");
        REQUIRE(pieces.size() == 1);
        CHECK(pieces[0].kind == kind);
        CHECK(pieces[0].text == text);
    }
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

TEST_CASE("what is opened and never closed is an error at its line") {
    const char* const cases[][2] = {{"\n$x\n\nb$", "page.md:2: this formula has no closing $ (write \\$ for a dollar)"},
                                    {"a\n$$x", "page.md:2: this formula has no closing $$ (write \\$ for a dollar)"},
                                    {"{{x\n\n}}", "page.md:1: this {{ has no closing }}"},
                                    {"a `b\n\nc`", "page.md:1: this inline code has no closing backtick"},
                                    {"\n\n```\ncode\n``", "page.md:3: this code fence has no end"}};
    for (const auto& each : cases) CHECK(message_of([&] { scan(each[0], "page.md"); }) == each[1]);
}
