#include "included.hpp"

#include <fstream>

#include "places.hpp"

namespace course {

namespace fs = std::filesystem;

// Words, with a backslash before a blank that belongs to one, and before the end of a line.
std::vector<fs::path> files_in(const std::vector<fs::path>& lists) {
    std::vector<fs::path> files;
    for (const auto& list : lists) {
        std::ifstream in(list);
        std::string word;
        for (char c; in.get(c);) {
            if (c == '\\' && (in.peek() == ' ' || in.peek() == '#'))
                word += static_cast<char>(in.get());
            else if (c == ' ' || c == '\n' || (c == '\\' && in.peek() == '\n')) {
                if (!word.empty()) files.emplace_back(word);
                word.clear();
            } else
                word += c;
        }
    }
    return files;
}

std::string not_ones_own(const std::vector<fs::path>& files, const fs::path& answer) {
    std::error_code none;
    for (const auto& file : files) {
        const fs::path real = fs::canonical(file, none);
        if (none || real == answer) continue;
        for (const auto& hidden :
             {places().source / "solutions", places().source / "tests", places().build / "tests",
              places().build / "exercises/check", places().build / "exercises/self_test",
              places().source / "kit"}) {
            const fs::path below = real.lexically_relative(fs::canonical(hidden, none));
            if (!below.empty() && *below.begin() != "..")
                return "The file includes " +
                       real.lexically_relative(fs::canonical(places().source)).string() +
                       ". An answer is to be one's own.\n";
        }
    }
    return {};
}

}  // namespace course
