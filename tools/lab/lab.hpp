#pragma once
/// \file
/// What a study hands to a page: data for the figures, numbers, and checks; and its options. Standard C++ only.

#include <algorithm>
#include <deque>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace lab {

/// A method's name as it stands in file names and numbers: "semi-implicit Euler" becomes
/// "semi_implicit_euler".
std::string id(const std::string& name);

/// The processor's name, where the system tells it.
std::string processor();
/// The compiler that made this program.
std::string compiler();

/// A line of a source. As the default of an argument it is the caller's (clang 14 has no std::source_location).
struct Place {
    const char* file;
    int line;
    static constexpr Place here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return {file, line};
    }
};

/// One cell of a data file: a number, or a word.
using Cell = std::variant<double, std::string>;

/// A data file in the making: named columns, one row after the other.
class Table {
public:
    Table(std::string file, std::vector<std::string> columns);
    /// Adds a row; throws `std::logic_error` when it has not one cell per column.
    void row(std::vector<Cell> cells);
    /// A blank line: gnuplot lifts its pen.
    void gap() { text_ += "\n"; }

    const std::string& file() const { return file_; }
    const std::string& text() const { return text_; }
    bool finite() const { return finite_; }  ///< all of its numbers

private:
    bool finite_ = true;
    std::string file_;
    std::size_t columns_;
    std::string text_;
};

/// What a run found: its data files, the numbers that the page names, and the checks that the page's sentences rest on.
/// All of it stays in memory until the run is over. places.tsv says which line wrote each: the line of the call, or the
/// one that a function has been given as `from` and passes on.
class Findings {
public:
    /// Prints a heading; `{{run: title}}` on a page quotes what is printed below it.
    void section(const std::string& title);
    /// A number for the page, rounded to `digits` significant digits. Integers stand in full.
    void number(const std::string& name, double value, const std::string& unit, const std::string& meaning,
                int digits = 3, Place from = Place::here());
    /// Words for the page, such as the name of the method that won.
    void text(const std::string& name, const std::string& words, const std::string& meaning,
              Place from = Place::here());
    /// Something the page says and this run confirms.
    void check(const std::string& name, bool holds, const std::string& statement, Place from = Place::here());
    /// A data file with the columns named.
    Table& table(const std::string& file, std::vector<std::string> columns, Place from = Place::here());

    const std::vector<std::string>& failed() const { return failed_; }
    /// Is every number and every cell finite? In the page's own run they must be.
    bool finite() const {
        return finite_ &&
               std::all_of(tables_.begin(), tables_.end(), [](const Table& table) { return table.finite(); });
    }
    /// Writes every file into `folder`, each of them whole. A full disk changes no file there. Throws
    /// `std::runtime_error`.
    void save(const std::string& folder) const;

private:
    void add_number(const std::string& name, const std::string& value, const std::string& unit,
                    const std::string& meaning, Place from);
    void add_place(const char* kind, const std::string& name, Place from);
    bool finite_ = true;
    std::deque<Table> tables_;  // a deque: references to its tables stay good
    std::vector<std::string> names_, failed_;
    std::string numbers_ = "name\tvalue\tunit\tmeaning\n";
    std::string checks_ = "name\tstatement\n";
    std::string places_ = "name\tkind\tplace\n";
};

/// The rule that an option's number must obey.
struct Rule {
    bool (*holds)(double);
    const char* words;
};
extern const Rule any_number, above_zero, zero_or_more;

/// A chapter's program: its options and its exit status.
///
///     int main(int argc, char** argv) {
///         double omega = 1;
///         lab::Program program("spring", "one line on what it shows");
///         program.option("--omega", omega, lab::above_zero, "angular frequency, rad/s");
///         return program.run(argc, argv, [&](lab::Findings& out) { … });
///     }
///
/// Exit status: 0 all is well; 1 a check failed with the page's options; 2 bad input, or the files could not be
/// written, with one line on standard error and no file half-written.
class Program {
public:
    Program(std::string name, std::string summary);
    void option(const std::string& flag, double& value, Rule rule, const std::string& help);
    /// A whole number between `least` and `most`.
    void option(const std::string& flag, long& value, long least, long most, const std::string& help);
    /// One of a few words.
    void option(const std::string& flag, std::string& value, std::vector<std::string> choices, const std::string& help);
    int run(int argc, char** argv, const std::function<void(Findings&)>& body);

private:
    struct Option {
        std::string flag, help, rule, initial;
        std::function<std::string(const std::string&)> set;  // what is wrong with the text
    };
    bool parse(int argc, char** argv);  // false: --help was asked for
    bool set_folder(const std::string& text);
    void print_help() const;

    std::string name_, summary_, folder_;
    std::vector<Option> options_;
    bool changed_ = false;
};

}  // namespace lab
