#include "terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include <sys/ioctl.h>
#include <unistd.h>

#include "stop.hpp"

namespace course {

namespace {

bool continues_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}

// The first `width` characters.
std::string cut(const std::string& text, std::size_t width) {
    std::size_t end = 0;
    for (std::size_t seen = 0; end < text.size(); ++end)
        if (!continues_character(text[end]) && ++seen > width) break;
    return text.substr(0, end);
}

}  // namespace

std::size_t columns() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20 ? size.ws_col : 80u;
}

bool on_terminal() {
    return isatty(STDOUT_FILENO) == 1;
}

std::string bold(const std::string& text) {
    return on_terminal() ? "\033[1m" + text + "\033[0m" : text;
}

std::size_t width_of(const std::string& text) {
    return text.size() -
           static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

// Terminals obey 0x80 to 0x9F, too: as bytes of their own, and as the characters C2 80 to C2 9F.
std::string harmless(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool low = (byte < ' ' && text[i] != '\n' && text[i] != '\t') || byte == 0x7F;
        const bool high = (byte & 0xE0) == 0x80;
        const bool after_c2 = high && i > 0 && text[i - 1] == '\xC2';
        if (after_c2) text[i - 1] = '?';
        if (low || after_c2 || (high && (i == 0 || !(text[i - 1] & 0x80)))) text[i] = '?';
    }
    return text;
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

void flush() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        throw Stop(Status::bad_use, "standard output: cannot be written");
}

void ProgressLine::say(const std::string& line) {
    clear();
    std::fprintf(stderr, "%s\n", line.c_str());
}

void ProgressLine::now(const std::string& line) {
    line_ = line;
    tick();
}

void ProgressLine::tick() {
    if (isatty(STDERR_FILENO) != 1 || line_.empty()) return;
    const auto gone = std::chrono::steady_clock::now() - begin_;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(gone).count();
    std::fprintf(stderr, "\r\033[K%s",
                 cut("  " + std::to_string(seconds) + " s  " + line_, columns() - 1).c_str());
}

void ProgressLine::clear() {
    if (isatty(STDERR_FILENO) == 1 && !line_.empty()) std::fprintf(stderr, "\r\033[K");
    line_.clear();
}

}  // namespace course
