// One colour a method: every plot whose title is a method's name draws it in the colour that tools/figures/style.gp
// has.
#include "colours.hpp"
#include "text.hpp"

#include <catch2/catch_test_macros.hpp>

#include <filesystem>
#include <map>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;

/// Titles of plots that are no panel's name of the method, and what style.gp calls them.
const std::map<std::string, std::string> short_titles{{"explicit", "explicit_euler"},
                                                      {"implicit", "implicit_euler"},
                                                      {"semi-implicit", "semi_implicit_euler"},
                                                      {"RK4", "runge_kutta_4"},
                                                      {"Adams–Bashforth", "adams_bashforth"},
                                                      {"SDIRK, order 3", "sdirk_3"},
                                                      {"backward", "backward_difference"},
                                                      {"forward difference", "forward_difference"},
                                                      {"backward difference", "backward_difference"},
                                                      {"central difference", "central_difference"},
                                                      {"lagged inertia", "lagged_inertia"},
                                                      {"converged", "converged_gyroscopic"},
                                                      {"Strang", "strang_splitting"},
                                                      {"ball + remainder 2", "ball_and_remainder_2"},
                                                      {"ball + remainder 4", "ball_and_remainder_4"}};

std::string style_of(const std::string& title) {
    const auto found = short_titles.find(title);
    return found != short_titles.end() ? found->second : live::is_look(title) ? live::look_of(title).style : "";
}

std::map<std::string, std::string> colours(const std::string& text, std::map<std::string, std::string> known) {
    static const std::regex entry{"(\\w+) *= \"lc rgb '(#[0-9a-f]{6})'"}, derived{"(\\w+) = colour_of\\((\\w+)\\)"};
    for (std::sregex_iterator each{text.begin(), text.end(), entry}, end; each != end; ++each)
        known[(*each)[1]] = (*each)[2];
    for (std::sregex_iterator each{text.begin(), text.end(), derived}, end; each != end; ++each)
        known[(*each)[1]] = known[(*each)[2]];
    return known;
}

}  // namespace

TEST_CASE("a method has one colour in all figures") {
    const fs::path root{SOURCE};
    const auto table = colours(page::read_file(root / "tools/figures/style.gp"), {});
    const std::regex plot{"with (?:lines|points|linespoints) ([^,\n]*?(?:\\([^)]*\\)[^,\n]*?)?)title \"([^\"]*)\""};
    const std::regex look{"@(\\w+)|lc rgb [\"'](#[0-9a-f]{6})"};
    int compared = 0;
    for (const char* folder : {"chapters", "engines"}) {
        for (const auto& entry : fs::recursive_directory_iterator{root / folder}) {
            if (entry.path().extension() != ".gp") continue;
            const std::string text = page::read_file(entry.path());
            const auto here = colours(text, table);
            for (std::sregex_iterator each{text.begin(), text.end(), plot}, end; each != end; ++each) {
                const std::string title = (*each)[2], method = style_of(title);
                const std::string drawn = (*each)[1];
                std::smatch found;
                if (method.empty() || !std::regex_search(drawn, found, look)) continue;
                const auto style = here.find(found[1]);
                const std::string colour = found[2].matched      ? std::string{found[2]}
                                           : style == here.end() ? ""
                                                                 : style->second;
                CAPTURE(entry.path().string(), title, drawn);
                CHECK(colour == table.at(method));
                ++compared;
            }
        }
    }
    CHECK(compared > 90);
}

TEST_CASE("a method looks in the panels as it does in the figures") {
    const std::string style = page::read_file(fs::path{SOURCE} / "tools/figures/style.gp");
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
