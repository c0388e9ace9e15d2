#include "forbidden_includes.hpp"

#include <fstream>
#include <iterator>
#include <string_view>

#include "paths.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

bool is_gap(char c) { return c == ' ' || c == '\t'; }

// A name as it is, which make's lists quote: a backslash before a blank or a tab, and the
// backslashes before it twice; before # one backslash; $ twice.
std::string unquoted(std::string_view raw) {
    std::string name;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        std::size_t slashes = 0;
        while (i < raw.size() && raw[i] == '\\') ++slashes, ++i;
        const char c = i < raw.size() ? raw[i] : '\0';
        if (is_gap(c))
            slashes /= 2;
        else if (c == '#' && slashes > 0)
            --slashes;
        name += std::string(slashes, '\\');
        if (i < raw.size()) name += c;
        if (c == '$' && i + 1 < raw.size() && raw[i + 1] == '$') ++i;
    }
    return name;
}

// All that the words of a list for make may mean. It does not tell a name that ends in a backslash
// from one that goes on with a blank, nor a line's end from a name's: there both are taken for
// names, and all from one such place to another. A blank without a backslash before it is none of a
// name's.
std::vector<std::string> names_in(std::string_view list) {
    const std::size_t longest = 10'000;  // of a name, quoted
    std::vector<std::string> names;
    std::vector<std::size_t> begins;  // of what may be names, since the last place that is sure
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= list.size(); ++i) {
        const char c = i < list.size() ? list[i] : '\n';
        if (!is_gap(c) && c != '\n') continue;
        begins.push_back(begin);
        for (const std::size_t from : begins)
            if (from < i && i - from < longest) names.push_back(unquoted(list.substr(from, i - from)));
        if (is_gap(c) && (i == 0 || list[i - 1] != '\\')) begins.clear();
        begin = i + 1;
    }
    return names;
}

// What exercise.hpp itself includes of the library. The rest of it holds what exercises ask for.
bool is_for_answers(const fs::path& header) {
    std::error_code none;
    const fs::path library = fs::canonical(paths().source / "include/timestep", none);
    return header == library / "state.hpp" || header == library / "real.hpp";
}

}  // namespace

std::vector<fs::path> files_in(const std::vector<fs::path>& lists) {
    std::vector<fs::path> files;
    for (const auto& list : lists) {
        std::ifstream in(list);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        for (const auto& name : names_in(text)) files.emplace_back(name);
    }
    return files;
}

std::string forbidden_include(const std::vector<fs::path>& files, const fs::path& answer) {
    std::error_code none;
    for (const auto& file : files) {
        const fs::path real = fs::canonical(file, none);
        if (none || real == answer || is_for_answers(real)) continue;
        for (const auto& hidden :
             {paths().source / "solutions", paths().source / "include", paths().source / "tests",
              paths().build / "tests", paths().build / "exercises/hidden", paths().build / "exercises/check",
              paths().build / "exercises/self_test", paths().source / "kit"}) {
            const fs::path below = real.lexically_relative(fs::canonical(hidden, none));
            if (!below.empty() && *below.begin() != "..")
                return "The file includes " + real.lexically_relative(fs::canonical(paths().source)).string() +
                       ". An answer is to be one's own.\n";
        }
    }
    return {};
}

}  // namespace course
