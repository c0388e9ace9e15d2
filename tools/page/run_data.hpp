#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace page {

/// A number (or a word) that a chapter's program found.
struct Number {
    std::string value, unit, meaning;
};

/// A data file: the columns' names, then the rows.
using Table = std::vector<std::vector<std::string>>;

/// The run has not been made, or is not over yet. A draft of the page leaves a gap there.
class NotYet : public std::out_of_range {
public:
    using std::out_of_range::out_of_range;
};

/// What one run left behind in its folder. Files are read when they are first asked for; a thing
/// that does not exist is a std::out_of_range whose what() is one clear sentence.
class RunData {
public:
    RunData(std::string chapter, std::filesystem::path folder);

    Number number(const std::string& name);
    /// The statement that the run confirmed.
    std::string check(const std::string& name);
    Table table(const std::string& file) const;
    /// The line that wrote the number, check or data file, "chapters/…/energy.cpp:42". Empty where the run does not
    /// say.
    std::string place_of(const std::string& name, const std::string& kind) const;
    /// The same for the end of a message: " (written at chapters/…/energy.cpp:42)", or nothing.
    std::string written_at(const std::string& name, const std::string& kind) const;
    /// What the program printed, or what stands in the study's output below a heading, heading included.
    std::string printed(const std::string& heading = "") const;
    /// A file's path; it exists.
    std::filesystem::path existing(const std::string& file) const;
    /// Milliseconds that the program took.
    long milliseconds() const;

private:
    /// The row of that name in a file of named records; nothing where there is none.
    const std::vector<std::string>* find_record(const std::string& file, std::size_t cells, const std::string& name);

    std::string chapter_;
    std::filesystem::path folder_;
    std::map<std::string, std::map<std::string, std::vector<std::string>>> records_;  ///< by their file
};

}  // namespace page
