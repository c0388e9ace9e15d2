#pragma once
// A course of one small chapter in a folder of its own, for tests of the tools that make pages.

#include <filesystem>
#include <string>

/// Made when a test begins, gone when it ends.
class Course {
public:
    Course();
    ~Course();
    Course(const Course&) = delete;
    Course& operator=(const Course&) = delete;

    std::filesystem::path operator/(const std::string& file) const { return folder_ / file; }

    void write(const std::string& file, const std::string& content) const;
    std::string read(const std::string& file) const;
    void remove(const std::string& file) const { std::filesystem::remove(folder_ / file); }
    /// Replaces the first `from` in a file; a test that replaces nothing is wrong itself.
    void replace(const std::string& file, const std::string& from, const std::string& to) const;

    /// Fills the chapter's page. Throws page::Error.
    std::string fill() const;
    /// The message with which filling fails, or "no error".
    std::string fill_error() const;
    /// Fills the chapter's page after replacing its first paragraph.
    std::string fill_paragraph(const std::string& paragraph) const;
    std::string paragraph_error(const std::string& paragraph) const;

private:
    std::filesystem::path folder_;
};

/// A command's exit status and all that it printed.
struct Outcome {
    int status;
    std::string words;
};
Outcome run_command(const std::string& command);
