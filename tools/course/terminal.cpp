#include "terminal.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <iterator>
#include <numeric>
#include <sstream>
#include <utility>

#include <unistd.h>
#if __has_include(<sys/ioctl.h>)
#include <sys/ioctl.h>
#endif

#include "stop.hpp"

namespace course {

namespace {

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

// The first `width` characters.
std::string cut(const std::string& text, std::size_t width) {
    std::size_t end = 0;
    for (std::size_t seen = 0; end < text.size(); ++end)
        if (!continues_character(text[end]) && ++seen > width) break;
    return text.substr(0, end);
}

}  // namespace

std::size_t character_at(const std::string& text, std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t size = first < 0x80                     ? 1u
                             : first >= 0xC2 && first < 0xE0  ? 2u
                             : first >= 0xE0 && first < 0xF0  ? 3u
                             : first >= 0xF0 && first <= 0xF4 ? 4u
                                                              : 0u;
    for (std::size_t i = 1; i < size; ++i)
        if (at + i >= text.size() || !continues_character(text[at + i])) return 0;
    // Written longer than it need be; a half of a pair of UTF-16's; beyond the last.
    const auto second = static_cast<unsigned char>(size > 1 ? text[at + 1] : 0);
    const bool none = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                      (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
    return none ? 0 : size;
}

// The blanks, control and format characters of Unicode that a text is likely to hold, and what is no character.
bool is_seen(const std::string& character) {
    static const std::pair<char32_t, char32_t> unseen[]{
        {0x00, 0x1F},     {0x7F, 0xA0},     {0xAD, 0xAD},       {0x2000, 0x200F}, {0x2028, 0x202F},
        {0x205F, 0x206F}, {0x3000, 0x3000}, {0xE000, 0xF8FF},   {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF},
        {0xFFA0, 0xFFA0}, {0xFFF0, 0xFFFF}, {0xE0000, 0x10FFFF}};
    const std::size_t size = character.empty() ? 0 : character_at(character, 0);
    if (size == 0 || size != character.size()) return false;
    const auto first = static_cast<unsigned char>(character[0]);
    char32_t code = size == 1 ? first : first & (0x7Fu >> size);
    for (std::size_t i = 1; i < size; ++i) code = code << 6 | (static_cast<unsigned char>(character[i]) & 0x3Fu);
    return (code & 0xFFFE) != 0xFFFE && std::none_of(std::begin(unseen), std::end(unseen), [&](const auto& range) {
               return code >= range.first && code <= range.second;
           });
}

std::size_t columns() {
#ifdef TIOCGWINSZ
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20) return size.ws_col;
#endif
    return 80;
}

bool on_terminal() { return isatty(STDOUT_FILENO) == 1; }

std::string bold(const std::string& text) { return on_terminal() ? "\033[1m" + text + "\033[0m" : text; }

std::size_t width_of(const std::string& text) {
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

std::string sanitized(const std::string& text) {
    std::string safe;
    for (std::size_t i = 0; i < text.size();) {
        const std::string character = text.substr(i, std::max<std::size_t>(character_at(text, i), 1));
        const bool plain = character == " " || character == "\n" || character == "\t" || is_seen(character);
        safe += plain ? character : std::string(character.size(), '?');
        i += character.size();
    }
    return safe;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

std::string sanitized_line(const std::string& text) {
    std::string line = sanitized(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\t'; }, '?');
    return line;
}

std::string shortened(const std::string& text, std::size_t most) {
    const std::string head = cut(text, most);
    return head.size() < text.size() ? head + "…" : text;
}

std::string padded(const std::string& text, std::size_t width) {
    const std::size_t taken = width_of(text);
    return taken < width ? text + std::string(width - taken, ' ') : text;
}

std::string wrapped(const std::string& text, std::size_t indent) {
    std::istringstream words(text);
    std::string lines, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && indent + width_of(line) + 1 + width_of(word) > 80) {
            lines += std::string(indent, ' ') + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return line.empty() ? lines : lines + std::string(indent, ' ') + line + "\n";
}

// Edits from one word to another: a letter changed, missing or added.
static std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1), next(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
            next[j] = std::min({row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), row[j] + 1, next[j - 1] + 1});
        std::swap(row, next);
    }
    return row.back();
}

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
    if (word.empty() || word.size() > 100) return {};
    std::string plain, found;
    for (const char c : word) plain += c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::size_t least = 1 + std::min(std::max<std::size_t>(2, plain.size() / 3), plain.size() - 1);
    for (const auto& name : names)
        if (const std::size_t away = distance(plain, name); away < least) {
            found = name;
            least = away;
        }
    return found;
}

void flush() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        throw Stop(Status::bad_use, "standard output: cannot be written");
}

namespace {
bool waits_are_told = false;
}

TellWaits::TellWaits() { waits_are_told = true; }
TellWaits::~TellWaits() { waits_are_told = false; }

void Wait::look() {
    const auto now = std::chrono::steady_clock::now();
    if (!waits_are_told || what_.empty() || now < next_) return;
    next_ = now + std::chrono::seconds(1);
    if (isatty(STDERR_FILENO) == 1) return line_.now(what_);
    line_.say(what_);
    what_.clear();
}

void ProgressLine::say(const std::string& line) {
    clear();
    std::fprintf(stderr, "%s\n", line.c_str());
    told_ = std::chrono::steady_clock::now();
}

void ProgressLine::now(const std::string& line) {
    line_ = line;
    tick();
}

void ProgressLine::tick() {
    if (line_.empty()) return;
    using namespace std::chrono;
    const auto now = steady_clock::now();
    const auto seconds = duration_cast<std::chrono::seconds>(now - begin_).count();
    const std::string text = "  " + std::to_string(seconds) + " s  " + line_;
    if (isatty(STDERR_FILENO) == 1) {
        std::fprintf(stderr, "\r\033[K%s", cut(text, columns() - 1).c_str());
    } else if (now - told_ > minutes(1)) {
        std::fprintf(stderr, "%s\n", text.c_str());
        told_ = now;
    }
}

void ProgressLine::clear() {
    if (isatty(STDERR_FILENO) == 1 && !line_.empty()) std::fprintf(stderr, "\r\033[K");
    line_.clear();
}

}  // namespace course
