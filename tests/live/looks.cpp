// Does a method look in the panels as it does in the figures?  looks style.gp
#include <fstream>
#include <iostream>
#include <regex>
#include <string>

#include "colours.hpp"

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
            if (found[1] != look.style) continue;
            known = true;
            if (colour != look.colour || dashes != look.dashes) {
                std::cout << look.name << ": " << look.colour << " (" << look.dashes << "), in the figures " << colour
                          << " (" << dashes << ")\n";
                ++wrong;
            }
        }
        if (!known) std::cout << found[1] << " has no look in the panels\n", ++wrong;
        ++compared;
    }
    std::cout << compared << " compared\n";
    return wrong > 0 || compared < 20;
}
