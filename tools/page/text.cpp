#include "text.hpp"

#include <cctype>
#include <fstream>
#include <sstream>
#include <system_error>

namespace page {

std::string read_file(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    std::ostringstream content;
    // Opening a folder succeeds on POSIX; reading it is what fails.
    if (!file || std::filesystem::is_directory(path) || (content << file.rdbuf(), file.bad()))
        throw Error{path.string(), 1, "cannot be read"};
    return content.str();
}

void write_file(const std::filesystem::path& path, std::string_view content) {
    std::error_code failed;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
    std::filesystem::path draft = path;
    draft += ".part";
    std::ofstream file{draft, std::ios::binary};
    file << content;
    file.close();
    if (file) std::filesystem::rename(draft, path, failed);
    if (!file || failed) {
        std::filesystem::remove(draft, failed);
        throw Error{path.string(), 1, "cannot be written"};
    }
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    std::size_t start = 0;
    while (true) {
        const std::size_t end = text.find(separator, start);
        parts.emplace_back(text.substr(start, end - start));
        if (end == std::string_view::npos) return parts;
        start = end + 1;
    }
}

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines = split(text, '\n');
    if (lines.back().empty()) lines.pop_back();
    for (std::string& line : lines) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
    }
    return lines;
}

std::vector<std::string> split_words(std::string_view text) {
    std::istringstream stream{std::string{text}};
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

std::vector<Row> rows_of(const std::filesystem::path& file, std::size_t cells) {
    std::vector<Row> rows;
    int line = 0;
    for (const std::string& text : split_lines(read_file(file))) {
        ++line;
        if (text.empty() || text.starts_with('#')) continue;
        rows.push_back({split(text, '\t'), line});
        if (cells == 0) cells = rows.front().cells.size();
        if (rows.back().cells.size() != cells)
            throw Error{file.string(), line, "must have " + std::to_string(cells) + " cells with tabs between"};
    }
    return rows;
}

std::string between(const std::string& text, const std::string& open, const std::string& close, std::size_t from) {
    const std::size_t begin = text.find(open, from);
    const std::size_t end = begin == std::string::npos ? begin : text.find(close, begin + open.size());
    return end == std::string::npos ? "" : text.substr(begin + open.size(), end - begin - open.size());
}

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string_view trim(std::string_view text) {
    const char* blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string replace_all(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

std::string escape_html(std::string_view text) {
    std::string escaped;
    for (const char c : text)
        escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string{c};
    return escaped;
}

std::string escape_markdown(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (std::string_view{R"(\@&$#<>%"*_`[]|)"}.find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string attribute(std::string_view text) {
    return replace_all(replace_all(std::string{text}, "\"", "'"), "|", "\u2223");
}

std::string base64(std::string_view bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8u | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

bool is_row(std::string_view word) {
    return word.size() == 3 && (word[0] == 'N' || word[0] == 'I') &&
           std::isdigit(static_cast<unsigned char>(word[1])) != 0 &&
           std::isdigit(static_cast<unsigned char>(word[2])) != 0;
}

}  // namespace page
