#include "tagged_tests.hpp"

#include "text.hpp"

#include <algorithm>
#include <cctype>

namespace page {
namespace {

/// Reads adjacent string literals, "so" " much", as the one that the compiler makes of them.
/// `at` goes behind them; nothing is read where there is none.
std::string read_literal(std::string_view text, std::size_t& at) {
    std::string word;
    while (true) {
        std::size_t next = at;
        while (next < text.size() && std::isspace(static_cast<unsigned char>(text[next])) != 0) {
            ++next;
        }
        if (next >= text.size() || text[next] != '"') {
            return word;
        }
        for (++next; next < text.size() && text[next] != '"'; ++next) {
            if (text[next] == '\\') {
                ++next;
            }
            word += text.substr(next, 1);
        }
        at = std::min(next + 1, text.size());
    }
}

/// "[N22][ch3]" names the row N22.
std::vector<std::string> rows_in(const std::string& tags) {
    std::vector<std::string> rows;
    for (std::size_t open = tags.find('['); open != std::string::npos; open = tags.find('[', open + 1)) {
        const std::string tag = tags.substr(open + 1, tags.find(']', open) - open - 1);
        if (is_row(tag)) {
            rows.push_back(tag);
        }
    }
    return rows;
}

}  // namespace

std::vector<TestPlace> tagged_tests(std::string_view text, const std::string& file) {
    std::vector<TestPlace> tests;
    int line = 0;
    for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
        ++line;
        const std::string_view rest = text.substr(begin);
        // TEST_CASE( or TEMPLATE_TEST_CASE( and the like, at the beginning of a line.
        const std::size_t word = rest.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_");
        if (word != std::string_view::npos && rest[word] == '(' &&
            rest.substr(0, word).find("TEST_CASE") != std::string_view::npos) {
            std::size_t at = begin + word + 1;
            const std::string name = read_literal(text, at);
            if (at < text.size() && text[at] == ',') {
                const std::string tags = read_literal(text, ++at);
                for (const std::string& row : rows_in(tags)) {
                    tests.push_back({row, name, file, line});
                }
            }
        }
        if (text.find('\n', begin) == std::string_view::npos) {
            break;
        }
    }
    return tests;
}

std::vector<std::filesystem::path> test_sources(const std::filesystem::path& root) {
    std::vector<std::filesystem::path> sources;
    for (const char* folder : {"tests/advise", "tests/chapters", "tests/library"}) {
        if (!std::filesystem::is_directory(root / folder)) {
            continue;
        }
        for (const auto& entry : std::filesystem::directory_iterator{root / folder}) {
            const bool hidden = entry.path().filename().string().starts_with(".");
            if (entry.path().extension() == ".cpp" && !hidden) {
                sources.push_back(entry.path());
            }
        }
    }
    std::sort(sources.begin(), sources.end());
    return sources;
}

std::vector<TestPlace> load_tests(const std::filesystem::path& root) {
    std::vector<TestPlace> tests;
    for (const std::filesystem::path& source : test_sources(root)) {
        const std::string file = std::filesystem::proximate(source, root).generic_string();
        const std::vector<TestPlace> found = tagged_tests(read_file(source), file);
        tests.insert(tests.end(), found.begin(), found.end());
    }
    return tests;
}

}  // namespace page
