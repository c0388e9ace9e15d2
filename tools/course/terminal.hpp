#pragma once
/// \file
/// What people see: colours and a line that is rewritten on a terminal, plain lines elsewhere.

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

/// `text` with "?" in place of what a terminal would obey: control characters but newline and tab,
/// signs that turn the direction of writing, and what is no UTF-8.
std::string sanitized(const std::string& text);

/// The same in one line.
std::string sanitized_line(const std::string& text);

/// `text`, with "…" for what follows after `most` characters.
std::string shortened(const std::string& text, std::size_t most);

/// Is this character of UTF-8 one that people see, and that no terminal and no format takes for more? A blank is.
bool is_seen(const std::string& character);

/// How many bytes the character has that begins there in `text`; 0 where none does in UTF-8.
std::size_t character_at(const std::string& text, std::size_t at);

/// Number of characters of UTF-8 text.
std::size_t width_of(const std::string& text);

/// Puts `by` in the place of every `what`.
void replace_all(std::string& text, const std::string& what, const std::string& by);

/// How many letters one word is away from another: changed, left out, too many, or two that changed places.
std::size_t distance(const std::string& a, const std::string& b);

/// The name that is nearest to `word`, whose capitals and hyphens do not count; "" where none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& names);

/// Writes out what has been printed. Throws Stop(bad_use) where nobody gets it: a full disk.
void flush();

/// While it lives, people are told what they wait for (see Wait).
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
    /// Something worth a line of its own, wherever it is read.
    void say(const std::string& line);
    /// How far it is: rewritten in place on a terminal, elsewhere told where a minute brought no line.
    void now(const std::string& line);
    /// Shows the same line again with the seconds that have gone by.
    void tick();
    void clear();

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now(), told_ = begin_;
    std::string line_;  // drawn at this moment, if any
};

/// Tells what is waited for, once a second has gone by without it, where there is a TellWaits: on a terminal in a line
/// that goes when the wait is over, elsewhere in one that stays.
class Wait {
public:
    /// "" tells nothing.
    explicit Wait(std::string what) : what_(std::move(what)) {}
    /// To be called now and then.
    void look();

private:
    std::string what_;
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    ProgressLine line_;
};

}  // namespace course
