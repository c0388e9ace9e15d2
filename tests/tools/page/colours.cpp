// One colour a method: every plot whose title is a method's name draws it in the colour that tools/figures/style.gp
// has.
#include "text.hpp"

#include <catch2/catch_test_macros.hpp>

#include <filesystem>
#include <map>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;

/// Titles, and what style.gp calls them.
const std::map<std::string, std::string> methods{{"exact", "exact"},
                                                 {"explicit", "explicit_euler"},
                                                 {"explicit Euler", "explicit_euler"},
                                                 {"implicit", "implicit_euler"},
                                                 {"implicit Euler", "implicit_euler"},
                                                 {"semi-implicit", "semi_implicit_euler"},
                                                 {"semi-implicit Euler", "semi_implicit_euler"},
                                                 {"Verlet", "verlet"},
                                                 {"velocity Verlet", "velocity_verlet"},
                                                 {"constant acceleration", "constant_acceleration"},
                                                 {"midpoint", "midpoint"},
                                                 {"Heun", "heun"},
                                                 {"RK4", "runge_kutta_4"},
                                                 {"BDF2", "bdf2"},
                                                 {"implicit midpoint", "implicit_midpoint"},
                                                 {"Adams–Bashforth", "adams_bashforth"},
                                                 {"SDIRK, order 3", "sdirk_3"},
                                                 {"forward", "forward_difference"},
                                                 {"backward", "backward_difference"},
                                                 {"central", "central_difference"},
                                                 {"forward difference", "forward_difference"},
                                                 {"backward difference", "backward_difference"},
                                                 {"central difference", "central_difference"},
                                                 {"dropped", "no_gyroscopic"},
                                                 {"lagged inertia", "lagged_inertia"},
                                                 {"one Newton step", "implicit_gyroscopic"},
                                                 {"converged", "converged_gyroscopic"},
                                                 {"passive", "passive_gyroscopic"},
                                                 {"half-step Jacobian", "half_step_jacobian"},
                                                 {"calm half-step", "calm_half_step"},
                                                 {"Cayley", "cayley_gyroscopic"},
                                                 {"Strang", "strang_splitting"},
                                                 {"ball + remainder 2", "ball_and_remainder_2"},
                                                 {"ball + remainder 4", "ball_and_remainder_4"}};

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
                const auto method = methods.find((*each)[2]);
                const std::string drawn = (*each)[1];
                std::smatch found;
                if (method == methods.end() || !std::regex_search(drawn, found, look)) continue;
                const auto style = here.find(found[1]);
                const std::string colour = found[2].matched      ? std::string{found[2]}
                                           : style == here.end() ? ""
                                                                 : style->second;
                CAPTURE(entry.path().string(), method->first, drawn);
                CHECK(colour == table.at(method->second));
                ++compared;
            }
        }
    }
    CHECK(compared > 90);
}
