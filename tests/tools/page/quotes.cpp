// Code quoted from sources, and about.json.
#include "course.hpp"
#include "error.hpp"
#include "json.hpp"
#include "snippet.hpp"

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

TEST_CASE("about.json: strings and lists of strings") {
    const page::Json json = page::parse_json(R"({"a": "x \"y\" \\", "b": [], "c": ["d", "e"]})", "f");
    CHECK(json.at("a") == std::vector<std::string>{"x \"y\" \\"});
    CHECK(json.at("b").empty());
    CHECK(json.at("c") == std::vector<std::string>{"d", "e"});
}

TEST_CASE("about.json: numbers, true and false, and objects within") {
    const page::Json json =
        page::parse_json(R"({"a": -1.5e3, "b": true, "c": {"d": "e", "f": {"g": ["h"]}}, "i": {}})", "f");
    CHECK(json.at("a") == std::vector<std::string>{"-1500.0"});
    CHECK(json.at("b") == std::vector<std::string>{"true"});
    CHECK(json.at("c.d") == std::vector<std::string>{"e"});
    CHECK(json.at("c.f.g") == std::vector<std::string>{"h"});
    CHECK(json.size() == 4);
}

TEST_CASE("about.json: anything else is an error at its line") {
    const auto error = [](const std::string& text) -> std::string {
        try {
            page::parse_json(text, "about.json");
        } catch (const page::Error& wrong) {
            return wrong.what();
        }
        return "none";
    };
    using Catch::Matchers::StartsWith;
    CHECK_THAT(error("{\n\"a\": b}"), StartsWith("about.json:2: syntax error while parsing value - invalid literal"));
    CHECK_THAT(error("{\"a\" \"b\"}"), StartsWith("about.json:1: syntax error while parsing object separator"));
    CHECK_THAT(error("{\"a\":\n\n[\"b\"}"), StartsWith("about.json:3: syntax error while parsing array"));
    CHECK_THAT(error("{\"a\": \"b\n\""), StartsWith("about.json:1: syntax error while parsing value - invalid string"));
    CHECK_THAT(error("{} {}"), StartsWith("about.json:1: syntax error while parsing value"));
    CHECK_THAT(error(""), StartsWith("about.json:1: "));  // in the library's words, of which later ones differ
    CHECK(error("[]") == "about.json:1: must be an object: { … }");
    for (const char* value : {"null", "[1]", "[[\"b\"]]"})
        CHECK(error(std::string{"{\"a\": {\"b\": "} + value + "}}") ==
              "about.json:1: \"a.b\" must be words, a list of them, a number, true or false");
    CHECK(error("{\"a\": \"b\"}") == "none");
}
