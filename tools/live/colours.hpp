#pragma once
// What a method looks like, in every picture: the colours and dashes of tools/figures/style.gp, by the names that
// the library gives its methods. A test (tests/tools/page/svg_for_web.cpp) holds the two equal.

#include <string_view>

namespace live {

struct Look {
    const char* name;   // in the library
    const char* style;  // in tools/figures/style.gp, or nothing
    const char* colour;
    const char* dashes;  // lengths of strokes and gaps, or nothing
};

inline constexpr Look looks[] = {
    {"ink", "ink", "#333333", ""},
    {"soft", "soft", "#dddddd", ""},
    {"paper", "", "#ffffff", ""},
    {"exact", "exact", "#8a8a8a", ""},
    {"faint", "faint", "#8a8a8a", "4,4"},
    {"first", "first", "#0072b2", ""},
    {"second", "second", "#d55e00", "14,5"},
    {"third", "third", "#009e73", "4,4"},
    {"fourth", "fourth", "#b15a98", "10,4,3,4"},

    {"forward", "forward_difference", "#d55e00", "14,5"},
    {"central", "central_difference", "#b15a98", "10,4,3,4"},
    {"variable time step", "", "#d55e00", ""},
    {"fixed time step", "", "#0072b2", ""},

    {"explicit Euler", "explicit_euler", "#d55e00", ""},
    {"implicit Euler", "implicit_euler", "#0072b2", "14,5"},
    {"semi-implicit Euler", "semi_implicit_euler", "#009e73", ""},
    {"semi-implicit Euler, new damping", "new_damping", "#009e73", "14,5"},
    {"Verlet", "verlet", "#b15a98", "6,4"},
    {"velocity Verlet", "velocity_verlet", "#b15a98", ""},
    {"constant acceleration", "constant_acceleration", "#808000", "3,4"},
    {"midpoint", "midpoint", "#e69f00", "10,4,3,4"},
    {"Heun", "heun", "#56b4e9", "3,3"},
    {"Runge-Kutta 4", "runge_kutta_4", "#7a4a1e", ""},
    {"BDF2", "bdf2", "#2f4b7c", "18,4,3,4"},
    {"implicit midpoint", "implicit_midpoint", "#000000", "8,4"},

    {"explicit", "explicit_gyroscopic", "#d55e00", ""},
    {"dropped", "no_gyroscopic", "#b15a98", "14,5"},
    {"momentum, lagged inertia", "lagged_inertia", "#e69f00", "6,4"},
    {"one Newton step", "implicit_gyroscopic", "#0072b2", "10,4,3,4"},
    {"implicit, converged", "converged_gyroscopic", "#56b4e9", "3,4"},
    {"passive", "passive_gyroscopic", "#009e73", ""},
    {"half-step Jacobian", "half_step_jacobian", "#332288", ""},
    {"calm half-step", "calm_half_step", "#332288", "3,4"},
    {"Cayley", "cayley_gyroscopic", "#a08400", ""},
    {"Strang splitting", "strang_splitting", "#44aa99", "6,4"},
    {"ball and remainder 2", "ball_and_remainder_2", "#882255", "14,5"},
    {"ball and remainder 4", "ball_and_remainder_4", "#882255", ""},
};

inline constexpr bool is_look(std::string_view name) {
    for (const Look& look : looks)
        if (name == look.name) return true;
    return false;
}

// What is in no list is drawn in ink.
inline constexpr const Look& look_of(std::string_view name) {
    for (const Look& look : looks)
        if (name == look.name) return look;
    return looks[0];
}

}  // namespace live
