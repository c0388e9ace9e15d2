// Code quoted from sources.
#include "course.hpp"
#include "directives.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

using Catch::Matchers::Message;

TEST_CASE("a snippet stands at the margin, without marks of other snippets and blank lines at its ends") {
    const Course course;
    course.write("a.hpp", "// [a]\n\n  one\n  // [b]\n\n    two\n  // [b]\n\n// [a]\n");
    CHECK(page::quote(course / "", "a.hpp", "a").code == "one\n\n  two\n");
    CHECK(page::quote(course / "", "a.hpp", "b").code == "two\n");
    CHECK(page::quote(course / "", "a.hpp", "b").first_line == 6);
}

TEST_CASE("only a bracketed word alone in a comment is a marker") {
    const char* const cases[][2] = {{"    /// [first order]  ", "first order"},
                                    {"//! [step]", "step"},
                                    {"# [style]", "style"},
                                    {"// [0, 1] is closed", ""},
                                    {"// [m/s]", ""},
                                    {"[step]", ""},
                                    {"x[i] = 0;  // [step]", ""}};
    for (const auto& [line, tag] : cases) CHECK(page::marker_tag(line) == tag);
}

TEST_CASE("a tag must stand exactly twice, with something between") {
    const Course course;
    const char* const cases[][2] = {{"// [a]\nint x;\n", "[a] stands 1 times in a.hpp instead of twice"},
                                    {"// [a]\nx\n// [a]\n// [a]\n", "[a] stands 3 times in a.hpp instead of twice"},
                                    {"// [a]\n\n// [a]\n", "nothing stands between the two [a] in a.hpp"}};
    for (const auto& [content, message] : cases) {
        course.write("a.hpp", content);
        CHECK_THROWS_MATCHES(page::quote(course / "", "a.hpp", "a"), std::out_of_range, Message(message));
    }
}
