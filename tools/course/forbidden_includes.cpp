// Does an answer include the course's answers, tests or library?

#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "paths.hpp"
#include "terminal.hpp"
#include "verdict.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// The names in a list for make, where a backslash stands before a blank and before #, and $ stands twice.
std::vector<std::string> names_in(const fs::path& list) {
    std::ifstream stream(list);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::string blank = "\1";
    for (const auto& [quoted, sign] : {std::pair{"\\ ", blank.c_str()}, {"\\#", "#"}, {"$$", "$"}})
        replace_all(text, quoted, sign);
    std::istringstream words(text);
    std::vector<std::string> names;
    for (std::string name; words >> name; names.push_back(name)) replace_all(name, blank, " ");
    return names;
}

// What exercise.hpp itself includes of the library. The rest of it holds what exercises ask for.
bool is_for_answers(const fs::path& header) {
    std::error_code none;
    const fs::path library = fs::canonical(paths().source / "include/timestep", none);
    return header == library / "state.hpp" || header == library / "real.hpp";
}

}  // namespace

std::string forbidden_include(const fs::path& list, const fs::path& answer) {
    std::error_code none;
    for (const fs::path file : names_in(list)) {
        const fs::path real = fs::canonical(file, none);
        if (none || real == answer || is_for_answers(real)) continue;
        for (const auto& hidden :
             {paths().source / "solutions", paths().source / "include", paths().source / "tests",
              paths().build / "tests", paths().build / "exercises/hidden", paths().source / "kit"}) {
            const fs::path below = real.lexically_relative(fs::canonical(hidden, none));
            if (!below.empty() && *below.begin() != "..")
                return "The file includes " + real.lexically_relative(fs::canonical(paths().source)).string() +
                       ". An answer is to be one's own.\n";
        }
    }
    return {};
}

}  // namespace course
