#include "nearest.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace course {

std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before, row(b.size() + 1), next(b.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            next[j] = std::min({row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), row[j] + 1, next[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                next[j] = std::min(next[j], before[j - 2] + 1);
        }
        before = row;
        row = next;
    }
    return row.back();
}

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
    if (word.empty() || word.size() > 100) return {};
    std::string plain;
    for (const char c : word) plain += c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::string found;
    const std::size_t most = std::min(std::max<std::size_t>(2, plain.size() / 3), plain.size() - 1);
    std::pair<std::size_t, std::size_t> least{most + 1, 0};
    for (const auto& name : names) {
        const std::size_t away = distance(plain, name);
        const bool begins = plain.size() > 3 && name.starts_with(plain);  // of several the shortest
        if (const std::pair now{begins ? 1 : away, away}; now < least) {
            found = name;
            least = now;
        }
    }
    return found;
}

}  // namespace course
