// Code quoted from sources, and about.json.
#include "course.hpp"
#include "error.hpp"
#include "directives.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using Catch::Matchers::Message;
using page::marker_tag;

TEST_CASE("a snippet is moved to the margin and knows its first line") {
    const Course course;
    const page::Snippet snippet = page::quote(course / "", "include/step.hpp", "step");
    CHECK(snippet.code == "void step() {\n    x += h * v;\n}\n");
    CHECK(snippet.first_line == 3);
}

TEST_CASE("markers of other snippets are left out, blank lines at the ends too") {
    const Course course;
    course.write("a.hpp", "// [a]\n\n  one\n  // [b]\n\n    two\n  // [b]\n\n// [a]\n");
    CHECK(page::quote(course / "", "a.hpp", "a").code == "one\n\n  two\n");
    CHECK(page::quote(course / "", "a.hpp", "b").code == "two\n");
}

TEST_CASE("only a bracketed word alone in a comment is a marker") {
    CHECK(marker_tag("    /// [first order]  ") == "first order");
    CHECK(marker_tag("//! [step]") == "step");
    CHECK(marker_tag("# [style]") == "style");
    CHECK(marker_tag("// [0, 1] is closed").empty());
    CHECK(marker_tag("// [m/s]").empty());
    CHECK(marker_tag("[step]").empty());
    CHECK(marker_tag("x[i] = 0;  // [step]").empty());
}

TEST_CASE("a tag must stand exactly twice, with something between") {
    const Course course;
    const auto quoting = [&](const std::string& content) {
        course.write("a.hpp", content);
        return page::quote(course / "", "a.hpp", "a");
    };
    CHECK_THROWS_MATCHES(quoting("int x;\n"), std::out_of_range,
                         Message("[a] stands 0 times in a.hpp instead of twice"));
    CHECK_THROWS_MATCHES(quoting("// [a]\nint x;\n"), std::out_of_range,
                         Message("[a] stands 1 times in a.hpp instead of twice"));
    CHECK_THROWS_MATCHES(quoting("// [a]\nx\n// [a]\n// [a]\n"), std::out_of_range,
                         Message("[a] stands 3 times in a.hpp instead of twice"));
    CHECK_THROWS_MATCHES(quoting("// [a]\n\n// [a]\n"), std::out_of_range,
                         Message("nothing stands between the two [a] in a.hpp"));
    CHECK_THROWS_MATCHES(page::quote(course / "", "none.hpp", "a"), std::out_of_range,
                         Message("there is no file none.hpp"));
}
