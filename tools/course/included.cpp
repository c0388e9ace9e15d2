#include "included.hpp"

#include <fstream>
#include <iterator>

#include "places.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// The words of a list for make, as its writers quote them: a backslash before a blank or a tab of a
// name, and the backslashes before it twice; before # one backslash; $ twice; one at the end of a
// line is none of a name's.
std::vector<std::string> words_in(const std::string& list) {
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::size_t slashes = 0;
        while (i < list.size() && list[i] == '\\') ++slashes, ++i;
        const char c = i < list.size() ? list[i] : '\n';
        const bool blank = c == ' ' || c == '\t', quoted = blank && slashes % 2 == 1;
        const bool end = (blank && !quoted) || c == '\n';
        if (slashes > 0 && (c == '#' || c == '\n')) --slashes;
        words.back() += std::string(quoted ? slashes / 2 : slashes, '\\');
        if (end)
            words.emplace_back();
        else
            words.back() += c;
        if (c == '$' && i + 1 < list.size() && list[i + 1] == '$') ++i;
    }
    return words;
}

// What exercise.hpp itself includes of the library. The rest of it holds what exercises ask for.
bool is_for_answers(const fs::path& header) {
    std::error_code none;
    const fs::path library = fs::canonical(places().source / "include/timestep", none);
    return header == library / "state.hpp" || header == library / "real.hpp";
}

}  // namespace

std::vector<fs::path> files_in(const std::vector<fs::path>& lists) {
    std::vector<fs::path> files;
    for (const auto& list : lists) {
        std::ifstream in(list);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        for (const auto& word : words_in(text))
            if (!word.empty()) files.emplace_back(word);
    }
    return files;
}

std::string not_ones_own(const std::vector<fs::path>& files, const fs::path& answer) {
    std::error_code none;
    for (const auto& file : files) {
        const fs::path real = fs::canonical(file, none);
        if (none || real == answer || is_for_answers(real)) continue;
        for (const auto& hidden :
             {places().source / "solutions", places().source / "include", places().source / "tests",
              places().build / "tests",
              places().build / "exercises/hidden", places().build / "exercises/check", places().build / "exercises/self_test",
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
