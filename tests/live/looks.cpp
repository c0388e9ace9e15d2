// Does a method look in the panels as it does in the figures?  looks style.gp
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "colours.hpp"

// What style.gp calls a method, and its name in the panels.
const std::map<std::string, std::string> names{
    {"ink", "ink"},
    {"soft", "soft"},
    {"exact", "exact"},
    {"faint", "faint"},
    {"first", "first"},
    {"second", "second"},
    {"third", "third"},
    {"fourth", "fourth"},
    {"forward_difference", "forward"},
    {"central_difference", "central"},
    {"explicit_euler", "explicit Euler"},
    {"implicit_euler", "implicit Euler"},
    {"semi_implicit_euler", "semi-implicit Euler"},
    {"new_damping", "semi-implicit Euler, new damping"},
    {"verlet", "Verlet"},
    {"velocity_verlet", "velocity Verlet"},
    {"constant_acceleration", "constant acceleration"},
    {"midpoint", "midpoint"},
    {"heun", "Heun"},
    {"runge_kutta_4", "Runge-Kutta 4"},
    {"bdf2", "BDF2"},
    {"implicit_midpoint", "implicit midpoint"},
    {"explicit_gyroscopic", "explicit"},
    {"no_gyroscopic", "dropped"},
    {"lagged_inertia", "momentum, lagged inertia"},
    {"implicit_gyroscopic", "one Newton step"},
    {"converged_gyroscopic", "implicit, converged"},
    {"passive_gyroscopic", "passive"},
    {"half_step_jacobian", "half-step Jacobian"},
    {"calm_half_step", "calm half-step"},
    {"cayley_gyroscopic", "Cayley"},
    {"strang_splitting", "Strang splitting"},
    {"ball_and_remainder_2", "ball and remainder 2"},
    {"ball_and_remainder_4", "ball and remainder 4"},
};
// No panel draws them.
const std::set<std::string> unseen{"adams_bashforth", "sdirk_3", "backward_difference", "five_point",
                                   "jolt_gyroscopic"};

int main(int count, char** words) {
    std::ifstream style(count == 2 ? words[1] : "");
    int compared = 0, wrong = 0;
    const std::regex line(R"re(^(\w+) *= "(?:lc rgb '(#\w+)' lw [\d.]+ dt (\S+)|(#\w+))"$)re");
    for (std::string text; std::getline(style, text);) {
        std::smatch found;
        if (!std::regex_match(text, found, line)) continue;
        const std::string colour = found[2].matched ? found[2] : found[4];
        std::string dashes = found[3];
        dashes = dashes.size() > 2 ? dashes.substr(1, dashes.size() - 2) : "";
        bool known = false;
        for (const auto& look : live::looks) {
            if (names.count(found[1]) == 0 || names.at(found[1]) != look.name) continue;
            known = true;
            if (colour != look.colour || dashes != look.dashes) {
                std::cout << look.name << ": " << look.colour << " (" << look.dashes << "), in the figures " << colour
                          << " (" << dashes << ")\n";
                ++wrong;
            }
        }
        if (!known && unseen.count(found[1]) == 0) std::cout << found[1] << " has no look in the panels\n", ++wrong;
        ++compared;
    }
    std::cout << compared << " compared\n";
    return wrong > 0 || compared < 20;
}
