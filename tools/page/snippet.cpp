#include "snippet.hpp"

#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace page {
namespace {

/// Takes away the blanks that every line begins with.
std::string join_at_margin(const std::vector<std::string>& lines) {
    std::size_t margin = std::string::npos;
    for (const std::string& line : lines) {
        margin = std::min(margin, line.find_first_not_of(' '));
    }
    std::string code;
    for (const std::string& line : lines) {
        code += (line.size() > margin ? line.substr(margin) : "") + "\n";
    }
    return code;
}

}  // namespace

std::string marker_tag(std::string_view line) {
    line = trim(line);
    const std::size_t comment = line.find_first_not_of("/!#");
    if (comment == std::string_view::npos || comment == 0) {
        return {};
    }
    line = trim(line.substr(comment));
    if (!line.starts_with('[') || !line.ends_with(']') || line.find(']') + 1 != line.size()) {
        return {};
    }
    // An interval or a unit in brackets is a remark, no tag.
    const std::string_view tag = line.substr(1, line.size() - 2);
    const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == ' '; };
    return std::all_of(tag.begin(), tag.end(), fits) ? std::string{tag} : std::string{};
}

Snippet quote(const std::filesystem::path& root, const std::string& file, const std::string& tag) {
    if (!std::filesystem::is_regular_file(root / file)) {
        throw std::out_of_range{"there is no file " + file};
    }
    std::vector<std::string> lines;
    int first_line = 0, line = 0, markers = 0;
    for (const std::string& text : split_lines(read_file(root / file))) {
        ++line;
        const std::string found = marker_tag(text);
        if (found == tag) {
            ++markers;
            first_line = markers == 1 ? line + 1 : first_line;
        } else if (markers == 1 && found.empty()) {
            lines.push_back(text);
        }
    }
    if (markers != 2) {
        throw std::out_of_range{"[" + tag + "] stands " + std::to_string(markers) + " times in " + file +
                                " instead of twice"};
    }
    while (!lines.empty() && trim(lines.front()).empty()) {
        lines.erase(lines.begin());
        ++first_line;
    }
    while (!lines.empty() && trim(lines.back()).empty()) {
        lines.pop_back();
    }
    if (lines.empty()) {
        throw std::out_of_range{"nothing stands between the two [" + tag + "] in " + file};
    }
    return {join_at_margin(lines), first_line};
}

}  // namespace page
