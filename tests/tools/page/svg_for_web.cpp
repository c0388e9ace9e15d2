// Figures on the pages: in the dark as on white, and in no more points than are seen.
#include "svg_for_web.hpp"
#include "colours.hpp"
#include "text.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <regex>
#include <stdexcept>

using Catch::Matchers::ContainsSubstring;

namespace {

const std::map<std::string, std::string> dark =
    page::load_dark_colours(std::string{SOURCE} + "/tools/figures/dark.tsv");

std::string shown(const std::string& body) {
    return page::svg_for_web("<?xml version='1.0'?>\n<svg\n width=\"640\" height=\"480\"\n>\n" + body + "</svg>\n",
                             dark);
}

}  // namespace

TEST_CASE("a panel's colours are in the dark those of the figures") {
    const std::string script = page::read_file(std::string{SOURCE} + "/docs/theme/live.js");
    const std::string table = page::between(script, "const onDark = {", "}");
    int seen = 0;
    for (std::size_t at = 0; (at = table.find("\"#", at)) != std::string::npos; at += 20, ++seen) {
        CAPTURE(table.substr(at, 20));
        CHECK(dark.at(table.substr(at + 1, 7)) == table.substr(at + 12, 7));
    }
    CHECK(seen > 10);
}

TEST_CASE("a figure is dark where the page is, and a colour that nobody has thought of breaks the build") {
    const std::string figure =
        shown("<g color=\"black\"><path stroke='rgb( 51,  51,  51)' fill = '#FFFFFF'/></g><text>a = '</text>");
    CHECK_THAT(figure, ContainsSubstring("<style>@media(prefers-color-scheme:dark){"));
    for (const char* rule : {"[color=\"#000000\"]{color:#ededed}", "[stroke=\"#333333\"]{stroke:#dfdfdf}",
                             "[fill=\"#ffffff\"]{fill:#1c1d1f}", "stroke='#333333'", "<text>a = '</text>"})
        CHECK_THAT(figure, ContainsSubstring(rule));
    CHECK_THROWS_AS(shown("<path stroke='#123456'/>"), std::invalid_argument);
    CHECK_THROWS_AS(page::svg_for_web("<svg width=\"3\">", dark), std::invalid_argument);
    // A map keeps the colours of its scale; light and shadow on a panel's bodies stay.
    CHECK_THAT(shown("<image/><polygon fill='#123456'/><path fill='#333333'/>"),
               ContainsSubstring("[fill=\"#333333\"]:not(polygon){fill:#dfdfdf}"));
    CHECK_THAT(shown("<path class=\"veil\" fill=\"#333333\"/><path fill=\"#333333\"/>"),
               ContainsSubstring("[fill=\"#333333\"]:not(.veil){fill:#dfdfdf}"));
}

TEST_CASE("points that nobody sees are left out of a figure") {
    const auto path = [](const std::string& data) {
        return page::between(shown("<path d='" + data + "'/>"), " d='", "'");
    };
    // Points on the line between their neighbours, or less than a tenth of a pixel beside it; then a corner.
    CHECK(path("M0.00,0.00 L1.00,0.05 L2.00,0.00 L2.00,7.00  ") == "M0,0L2,0 2,7");
    CHECK(path("M0.00,0.00 L1.00,0.25 L2.00,0.00 ") == "M0,0L1,0.3 2,0");
    CHECK(path("M-0.04,-3.16 L5.00,5.00 M9.00,9.00 M1.00,1.00 L2.00,2.00 ") == "M0,-3.2L5,5M1,1L2,2");
    CHECK(path("M1.00,1.00 L1.00,1.00 ") == "M1,1L1,1");  // a dot
    CHECK(path("M0,1.330 L1.265,0.411 z") == "M0,1.330 L1.265,0.411 z");
}

TEST_CASE("a method looks in the panels as it does in the figures") {
    const std::string style = page::read_file(std::string{SOURCE} + "/tools/figures/style.gp");
    for (const live::Look& look : live::looks) {
        if (*look.style == '\0') continue;
        CAPTURE(look.name);
        const std::regex line{"(?:^|\n)" + std::string{look.style} +
                              " *= \"(?:lc rgb '(#\\w+)' lw [\\d.]+ dt (\\S+)|(#\\w+))\"\n"};
        std::smatch found;
        REQUIRE(std::regex_search(style, found, line));
        const std::string dashes = found[2];
        CHECK(look.colour == (found[1].matched ? found[1] : found[3]).str());
        CHECK(look.dashes == (dashes.size() > 2 ? dashes.substr(1, dashes.size() - 2) : ""));
    }
}
