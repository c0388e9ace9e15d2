#pragma once
// What a method looks like, in every picture: the colours and dashes of tools/figures/style.gp, by the names that
// the library gives its methods. A test (tests/live/looks.cpp) holds the two equal.

#include <string_view>

namespace live {

struct Look {
    const char* name;  // in the library
    const char* colour;
    const char* dashes;  // lengths of strokes and gaps, or nothing
};

inline constexpr Look looks[] = {
    {"ink", "#333333", ""},
    {"soft", "#dddddd", ""},
    {"paper", "#ffffff", ""},
    {"exact", "#8a8a8a", ""},
    {"faint", "#8a8a8a", "4,4"},
    {"first", "#0072b2", ""},
    {"second", "#d55e00", "14,5"},
    {"third", "#009e73", "4,4"},
    {"fourth", "#b15a98", "10,4,3,4"},

    {"forward", "#d55e00", "14,5"},
    {"central", "#b15a98", "10,4,3,4"},
    {"variable time step", "#d55e00", ""},
    {"fixed time step", "#0072b2", ""},

    {"explicit Euler", "#d55e00", ""},
    {"implicit Euler", "#0072b2", "14,5"},
    {"semi-implicit Euler", "#009e73", ""},
    {"semi-implicit Euler, new damping", "#009e73", "14,5"},
    {"Verlet", "#b15a98", "6,4"},
    {"velocity Verlet", "#b15a98", ""},
    {"constant acceleration", "#808000", "3,4"},
    {"midpoint", "#e69f00", "10,4,3,4"},
    {"Heun", "#56b4e9", "3,3"},
    {"Runge-Kutta 4", "#7a4a1e", ""},
    {"BDF2", "#2f4b7c", "18,4,3,4"},
    {"implicit midpoint", "#000000", "8,4"},

    {"explicit", "#d55e00", ""},
    {"dropped", "#b15a98", "14,5"},
    {"momentum, lagged inertia", "#e69f00", "6,4"},
    {"one Newton step", "#0072b2", "10,4,3,4"},
    {"implicit, converged", "#56b4e9", "3,4"},
    {"passive", "#009e73", ""},
    {"half-step Jacobian", "#332288", ""},
    {"calm half-step", "#332288", "3,4"},
    {"Cayley", "#a08400", ""},
    {"Strang splitting", "#44aa99", "6,4"},
    {"ball and remainder 2", "#882255", "14,5"},
    {"ball and remainder 4", "#882255", ""},
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
