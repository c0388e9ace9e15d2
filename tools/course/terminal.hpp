#pragma once
/// \file
/// Text for people: safe to print, wrapped, padded; and progress, as one rewritten line on a terminal, as lines
/// elsewhere.

#include <chrono>
#include <string>
#include <vector>

namespace course {

/// Is standard output a terminal?
bool on_terminal();

/// `text` in bold on a terminal, as it is elsewhere.
std::string bold(const std::string& text);

/// `text`, padded with blanks to `width` characters (not bytes).
std::string padded(const std::string& text, std::size_t width);

/// The width of the terminal; 80 where there is none.
std::size_t columns();

/// `text` in lines of at most 80 characters, each after `indent` blanks and with its end.
std::string wrapped(const std::string& text, std::size_t indent);

/// `text` with "?" in place of what is not seen (see is_seen), apart from blank, newline and tab: a terminal may obey
/// it.
std::string sanitized(const std::string& text);

/// `sanitized` text in one line: newlines and tabs become "?", too.
std::string sanitized_line(const std::string& text);

/// `text`, with "…" for what follows after `most` characters.
std::string shortened(const std::string& text, std::size_t most);

/// Is this UTF-8 character visible? Blanks, control and format characters are not.
bool is_seen(const std::string& character);

/// Number of bytes of the UTF-8 character that begins at `at`; 0 if none does.
std::size_t character_at(const std::string& text, std::size_t at);

/// Number of characters of UTF-8 text.
std::size_t width_of(const std::string& text);

/// Puts `by` in the place of every `what`.
void replace_all(std::string& text, const std::string& what, const std::string& by);

/// The name that is nearest to `word`, whose capitals and hyphens do not count; "" where none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& names);

/// Flushes standard output. Throws Stop(bad_use) if that fails, as on a full disk.
void flush();

/// While one exists, Wait prints what people wait for.
class TellWaits {
public:
    TellWaits();
    ~TellWaits();
    TellWaits(const TellWaits&) = delete;
    TellWaits& operator=(const TellWaits&) = delete;
};

/// Shows that work goes on, on standard error, so that standard output holds results only.
class ProgressLine {
public:
    ~ProgressLine() { clear(); }
    /// Prints a line that stays.
    void say(const std::string& line);
    /// Shows how far the work is: in place on a terminal; elsewhere in a line, at most one per minute.
    void now(const std::string& line);
    /// Shows that line again, with the seconds since the beginning.
    void tick();
    void clear();

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now(), told_ = begin_;
    std::string line_;  // drawn at this moment, if any
};

/// After one second prints what is waited for, if there is a TellWaits: on a terminal in a line that goes when the wait
/// is over, elsewhere in a line that stays.
class Wait {
public:
    /// "" prints nothing.
    explicit Wait(std::string what) : what_(std::move(what)) {}
    /// To be called now and then.
    void look();

private:
    std::string what_;
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    ProgressLine line_;
};

}  // namespace course
