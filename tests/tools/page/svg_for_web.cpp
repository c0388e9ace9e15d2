// Figures on the pages: in the dark as on white, and no larger than what is seen of them.
#include "course.hpp"
#include "svg_for_web.hpp"
#include "text.hpp"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::EndsWith;
using page::for_pages;
using page::on_dark_ground;

namespace {

/// WCAG 2's contrast of two colours `#rrggbb`.
double contrast(const std::string& a, const std::string& b) {
    const auto luminance = [](const std::string& colour) {
        constexpr std::array<double, 3> weight{0.2126, 0.7152, 0.0722};
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double part = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
            sum += weight[i] * (part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
        }
        return sum + 0.05;
    };
    const double one = luminance(a), other = luminance(b);
    return one > other ? one / other : other / one;
}

const std::string ground = on_dark_ground("#ffffff");

std::string drawing(const std::string& body) {
    return "<?xml version='1.0'?>\n<svg\n width=\"640\" height=\"480\"\n>\n<title>Gnuplot</title>\n" + body +
           "</svg>\n";
}

}  // namespace

TEST_CASE("greys have the contrast in the dark that they have on white") {
    CHECK(contrast(ground, "#000000") < 1.3);
    for (const char* grey : {"#dddddd", "#8a8a8a", "#666666", "#333333"}) {
        CHECK(contrast(on_dark_ground(grey), ground) == Catch::Approx(contrast(grey, "#ffffff")).epsilon(0.03));
    }
    CHECK(contrast(on_dark_ground("#000000"), ground) > 12);
}

TEST_CASE("every colour of the palette can be read in the dark, and stays what it is") {
    for (const std::string colour :
         {"#d55e00", "#0072b2", "#009e73", "#b15a98", "#e69f00", "#56b4e9", "#7a4a1e", "#2f4b7c", "#882255"}) {
        const std::string dark = on_dark_ground(colour);
        CAPTURE(colour, dark);
        CHECK(contrast(dark, ground) >= 4.45);
        CHECK(contrast(dark, ground) <= std::max(6.8, contrast(colour, ground)));
        // Its strongest part stays the strongest, the weakest the weakest.
        for (std::size_t i = 1; i < 7; i += 2) {
            for (std::size_t j = 1; j < 7; j += 2) {
                if (colour.substr(i, 2) > colour.substr(j, 2)) {
                    CHECK(dark.substr(i, 2) >= dark.substr(j, 2));
                }
            }
        }
    }
    CHECK(on_dark_ground("#e69f00") == "#e69f00");  // light enough as it is
    CHECK(on_dark_ground("#000001") == "#000001");  // words on a painted cell
}

TEST_CASE("a panel's colours are in the dark those of the figures") {
    const std::filesystem::path root = SOURCE;
    std::string panels;
    for (const char* folder : {"chapters", "tools/live"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
            if (entry.path().string().find("/live/") != std::string::npos && entry.is_regular_file())
                panels += page::read_file(entry.path());
    const std::string script = page::read_file(root / "docs/theme/live.js");
    std::size_t seen = 0;
    for (std::size_t at = 0; (at = panels.find("\"#", at)) != std::string::npos; ++at, ++seen) {
        const std::string colour = panels.substr(at + 1, 7);
        if (colour.find_first_not_of("0123456789abcdef", 1) != std::string::npos) continue;  // "#fff"
        const std::string dark = on_dark_ground(colour);
        CAPTURE(colour);
        if (dark == colour) {
            CHECK_THAT(script, !ContainsSubstring('"' + colour + "\":"));
        } else {
            CHECK_THAT(script, ContainsSubstring('"' + colour + "\": \"" + dark + '"'));
        }
    }
    CHECK(seen > 20);
}

TEST_CASE("a figure is dark where the page is") {
    const std::string shown =
        for_pages(drawing("<rect fill=\"#FFFFFF\"/><path stroke='rgb( 51,  51,  51)' d='M1.00,2.00 L3.00,4.00 '/>"
                          "<text fill=\"black\">a &lt; b</text>"));
    CHECK_THAT(shown, ContainsSubstring("<style>@media(prefers-color-scheme:dark){"));
    CHECK_THAT(shown, ContainsSubstring("[fill=\"#ffffff\"]{fill:" + ground + "}"));
    CHECK_THAT(shown, ContainsSubstring("[fill=\"#000000\"]{fill:" + on_dark_ground("#000000") + "}"));
    CHECK_THAT(shown, ContainsSubstring("[stroke=\"#333333\"]{stroke:" + on_dark_ground("#333333") + "}"));
    CHECK_THAT(shown, ContainsSubstring("<rect fill=\"#ffffff\"/><path stroke=\"#333333\" d=\"M1,2L3,4\"/>"));
    CHECK_THAT(shown, ContainsSubstring(">a &lt; b</text></svg>"));
}

TEST_CASE("a map keeps the colours of its scale") {
    const std::string shown =
        for_pages(drawing("<image xlink:href='data:'/><polygon fill = 'rgb( 42,  12,   0)' points = '12.82,5.00 '/>"));
    CHECK_THAT(shown, ContainsSubstring("<polygon fill=\"rgb( 42,  12,   0)\" points=\"12.8,5\"/>"));
}

TEST_CASE("the still picture of a panel is dark, too, but for light and shadow on bodies") {
    const std::string shown = for_pages(
        "<svg width=\"64\" height=\"9\" font-family=\"sans-serif\">\n<rect fill=\"#fff\"/>"
        "<path d=\"M1.25 2L3 4Z\" fill=\"#333333\" stroke=\"none\" opacity=\"0.3\"/></svg>\n");
    CHECK_THAT(shown, ContainsSubstring("<svg width=\"64\" height=\"9\" font-family=\"sans-serif\"><style>"));
    CHECK_THAT(shown, ContainsSubstring("<rect fill=\"#ffffff\"/><path d=\"M1.25 2L3 4Z\" fill=\"rgb(51,51,51)\""));
}

TEST_CASE("what no eye sees is left out of a figure") {
    const auto path = [](const std::string& data) {
        const std::string shown = for_pages(drawing("<path d='" + data + "'/>"));
        const std::size_t at = shown.find("d=\"") + 3;
        return shown.substr(at, shown.find('"', at) - at);
    };
    // On the line between their neighbours, or less than a tenth of a pixel beside it; then a corner.
    CHECK(path("M0.00,0.00 L1.00,0.05 L2.00,0.00 L2.00,7.00  ") == "M0,0L2,0 2,7");
    CHECK(path("M0.00,0.00 L1.00,0.25 L2.00,0.00 ") == "M0,0L1,0.3 2,0");
    CHECK(path("M-0.04,-3.16 L5.00,5.00 M9.00,9.00 M1.00,1.00 L2.00,2.00 ") == "M0,-3.2L5,5M1,1L2,2");
    CHECK(path("M1.00,1.00 L1.00,1.00 ") == "M1,1L1,1");  // a dot
    CHECK(path("M0,1.330 L1.265,0.411 z") == "M0,1.330 L1.265,0.411 z");
    CHECK(for_pages(drawing("<g fill=\"none\">\n</g>\n<g id='a'>\n<rect/></g>\n"))
              .ends_with("<g id=\"a\"><rect/></g></svg>\n"));
    const std::string points =
        "<circle id='gpPt5' r='1'/><use xlink:href='#gpPt5' id='gpPt6'/><rect id='gpPt3'/><use xlink:href='#gpPt3' "
        "id='gpPt11'/>";
    CHECK_THAT(for_pages(drawing("<defs>" + points + "</defs><use xlink:href='#gpPt6'/>")),
               EndsWith("<defs><circle id=\"gpPt5\" r=\"1\"/><use xlink:href=\"#gpPt5\" id=\"gpPt6\"/></defs><use "
                        "xlink:href=\"#gpPt6\"/></svg>\n"));
    CHECK_THROWS_AS(path("M1.00 L2.00,3.00"), std::invalid_argument);
    CHECK_THROWS_AS(for_pages("<svg width=\"3\">"), std::invalid_argument);
    CHECK_THROWS_AS(for_pages(drawing("<rect fill='none/>")), std::invalid_argument);
}
