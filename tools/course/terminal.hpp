#pragma once
/// \file
/// What people see: colours and a line that is rewritten on a terminal, plain lines elsewhere.

#include <string>

namespace course {

/// Is standard output a terminal?
bool on_terminal();

/// `text` in bold on a terminal, as it is elsewhere.
std::string bold(const std::string& text);

/// `text`, padded with blanks to `width` characters (not bytes).
std::string padded(const std::string& text, std::size_t width);

/// Number of characters of UTF-8 text.
std::size_t width_of(const std::string& text);

/// Shows that work goes on, on standard error, so that standard output holds results only.
class Progress {
public:
    ~Progress() { clear(); }
    /// Something worth a line of its own, wherever it is read.
    void say(const std::string& line);
    /// What is done at this moment: rewritten in place on a terminal, left out elsewhere.
    void now(const std::string& line);
    void clear();

private:
    bool drawn_ = false;
};

}  // namespace course
