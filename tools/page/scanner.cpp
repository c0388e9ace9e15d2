#include "scanner.hpp"

#include "text.hpp"

#include <algorithm>
#include <cctype>

namespace page {
namespace {

using Kind = Piece::Kind;
constexpr std::size_t npos = std::string_view::npos;

class Scanner {
public:
    Scanner(std::string_view source, const std::string& file, int first_line)
        : source_{source}, file_{file}, first_line_{first_line} {}

    std::vector<Piece> pieces() {
        while (at_ < source_.size()) {
            const bool line_begins = at_ == 0 || source_[at_ - 1] == '\n';
            if (line_begins && fence_length() > 0) {
                take(Kind::code, end_of_fence());
            } else if (line_begins && is_heading()) {
                take(Kind::heading, end_of_line(at_));
            } else if (source_[at_] == '\\' && at_ + 1 < source_.size()) {
                at_ += 2;  // \$ is a dollar, \` a backtick
            } else if (source_[at_] == '`') {
                take(Kind::code, end_of_inline_code(at_));
            } else if (looking_at("$$")) {
                take(Kind::display, end_of_formula(at_, "$$"), 2);
            } else if (opens_formula(at_)) {
                take(Kind::formula, end_of_formula(at_, "$"), 1);
            } else if (looking_at("{{")) {
                take(Kind::directive, end_of_directive(), 2);
            } else {
                ++at_;
            }
        }
        take_text();
        return std::move(pieces_);
    }

private:
    /// Ends the text before the cursor, then takes what runs up to `end`, less its delimiters.
    void take(Kind kind, std::size_t end, std::size_t delimiter = 0) {
        take_text();
        const std::string_view inner = source_.substr(at_ + delimiter, end - at_ - 2 * delimiter);
        const std::size_t begin = begin_of_line(at_);
        const bool own_line = trim(source_.substr(begin, at_ - begin)).empty() &&
                              trim(source_.substr(end, end_of_line(end) - end)).empty();
        pieces_.push_back({kind, std::string{inner}, line_of(at_), own_line, in_table(at_)});
        at_ = text_begin_ = end;
    }

    void take_text() {
        if (at_ > text_begin_) {
            pieces_.push_back({Kind::text, std::string{source_.substr(text_begin_, at_ - text_begin_)},
                               line_of(text_begin_), false, in_table(text_begin_)});
        }
        text_begin_ = at_;
    }

    bool looking_at(std::string_view word) const { return source_.substr(at_).starts_with(word); }

    /// A fence is a line that begins with three or more backticks or tildes.
    std::size_t fence_length() const {
        const char mark = source_[at_];
        if (mark != '`' && mark != '~') return 0;
        const std::size_t length = std::min(source_.find_first_not_of(mark, at_), source_.size()) - at_;
        return length >= 3 ? length : 0;
    }

    std::size_t end_of_fence() const {
        const std::string fence(fence_length(), source_[at_]);
        for (std::size_t line = end_of_line(at_); line < source_.size(); line = end_of_line(line + 1)) {
            if (source_.substr(line + 1).starts_with(fence)) return end_of_line(line + 1);
        }
        fail(at_, "this code fence has no end");
    }

    bool is_heading() const {
        const std::size_t level = std::min(source_.find_first_not_of('#', at_), source_.size()) - at_;
        return level >= 1 && level <= 6 && source_.substr(at_ + level).starts_with(' ');
    }

    std::size_t end_of_inline_code(std::size_t from) const {
        const std::size_t ticks = std::min(source_.find_first_not_of('`', from), source_.size()) - from;
        const std::size_t end = source_.find(std::string(ticks, '`'), from + ticks);
        if (end == npos || end > end_of_paragraph(from)) fail(from, "this inline code has no closing backtick");
        return end + ticks;
    }

    /// A dollar opens a formula unless a blank follows it.
    bool opens_formula(std::size_t at) const {
        return source_[at] == '$' && at + 1 < source_.size() &&
               std::isspace(static_cast<unsigned char>(source_[at + 1])) == 0;
    }

    std::size_t end_of_formula(std::size_t from, std::string_view dollars) const {
        std::size_t end = from + dollars.size();
        do {
            end = source_.find(dollars, end);
            if (end == npos || end > end_of_paragraph(from))
                fail(from, "this formula has no closing " + std::string{dollars} + " (write \\$ for a dollar)");
            end += dollars.size();
        } while (source_[end - dollars.size() - 1] == '\\');
        return end;
    }

    /// Directives nest ({{figure …: {{number}} …}}), and their captions hold formulas and code,
    /// in which braces mean nothing.
    std::size_t end_of_directive() const {
        const std::size_t limit = end_of_paragraph(at_);
        int depth = 0;
        std::size_t i = at_;
        while (i < limit) {
            if (source_.substr(i).starts_with("{{")) {
                ++depth;
                i += 2;
            } else if (source_.substr(i).starts_with("}}")) {
                --depth;
                i += 2;
                if (depth == 0) return i;
            } else if (source_[i] == '`') {
                i = end_of_inline_code(i);
            } else if (opens_formula(i)) {
                i = end_of_formula(i, "$");
            } else {
                ++i;
            }
        }
        fail(at_, "this {{ has no closing }}");
    }

    std::size_t begin_of_line(std::size_t at) const {
        const std::size_t before = at == 0 ? npos : source_.rfind('\n', at - 1);
        return before == npos ? 0 : before + 1;
    }

    std::size_t end_of_line(std::size_t at) const { return std::min(source_.find('\n', at), source_.size()); }

    /// The next blank line, or the end.
    std::size_t end_of_paragraph(std::size_t at) const {
        std::size_t line = end_of_line(at);
        while (line < source_.size()) {
            const std::size_t next = end_of_line(line + 1);
            if (trim(source_.substr(line, next - line)).empty()) return line;
            line = next;
        }
        return source_.size();
    }

    bool in_table(std::size_t at) const {
        const std::size_t begin = begin_of_line(at);
        return trim(source_.substr(begin, end_of_line(begin) - begin)).starts_with('|');
    }

    int line_of(std::size_t at) const {
        const auto end = source_.begin() + static_cast<std::ptrdiff_t>(at);
        return first_line_ + static_cast<int>(std::count(source_.begin(), end, '\n'));
    }

    [[noreturn]] void fail(std::size_t at, const std::string& message) const {
        throw Error{file_, line_of(at), message};
    }

    std::string_view source_;
    const std::string& file_;
    int first_line_;
    std::size_t at_ = 0, text_begin_ = 0;
    std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> scan(std::string_view source, const std::string& file, int first_line) {
    return Scanner{source, file, first_line}.pieces();
}

Heading parse_heading(std::string_view line) {
    Heading heading{};
    while (line.starts_with('#')) {
        ++heading.level;
        line.remove_prefix(1);
    }
    line = trim(line);
    const std::size_t id = line.rfind("{#");
    if (id != npos && line.ends_with('}')) {
        heading.id = line.substr(id + 2, line.size() - id - 3);
        line = trim(line.substr(0, id));
    }
    heading.title = line;
    return heading;
}

}  // namespace page
