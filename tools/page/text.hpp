#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace page {

/// What a page does wrong, and where: `file:line: message`, as compilers say it.
class Error : public std::runtime_error {
public:
    Error(const std::string& file, int line, const std::string& message)
        : std::runtime_error{file + ":" + std::to_string(line) + ": " + message} {}
};

/// The whole file. Throws Error (line 1) when it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Writes the file whole or not at all: beside its place first, then moved there. Throws Error.
void write_file(const std::filesystem::path& path, std::string_view content);

std::vector<std::string> split(std::string_view text, char separator);

/// The lines without their line ends ("\n" or "\r\n").
std::vector<std::string> split_lines(std::string_view text);

/// The words between blanks.
std::vector<std::string> split_words(std::string_view text);

/// The rows of a table of tab-separated cells, without empty lines and those that begin with #. Throws Error for a row
/// that has not so many cells, or not as many as the first.
struct Row {
    std::vector<std::string> cells;
    int line;
};
std::vector<Row> rows_of(const std::filesystem::path& file, std::size_t cells = 0);

/// The text between `open` and the next `close`; empty where they are not there.
std::string between(const std::string& text, const std::string& open, const std::string& close, std::size_t from = 0);

/// May it stand in a name of C++?
bool in_word(char c);

std::string_view trim(std::string_view text);

std::string replace_all(std::string text, std::string_view from, std::string_view to);

/// For text between HTML tags and in attributes: & < > " are escaped.
std::string escape_html(std::string_view text);

/// For text that Doxygen's Markdown shall show as it is.
std::string escape_markdown(std::string_view text);

/// For an attribute of an HTML tag that stands in Markdown. Doxygen escapes the value itself: only what would end the
/// value, or a table's cell, is replaced.
std::string attribute(std::string_view text);

/// Any bytes as text: a script may hand them to a page that is opened from its file, which may read no other file.
std::string base64(std::string_view bytes);

/// Is it a claim's id, N or I and two digits?
bool is_row(std::string_view word);

}  // namespace page
