#pragma once
// A course of one small chapter in a folder of its own, for tests of the tools that make pages.

#include <filesystem>
#include <initializer_list>
#include <string>

#include "text.hpp"

/// A paragraph of a page's source, and what is expected of it.
struct Case {
    std::string paragraph, expected;
};

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
    /// Fills the chapter's page after replacing its first paragraph, in line 5.
    std::string fill_paragraph(const std::string& paragraph) const;
    std::string paragraph_error(const std::string& paragraph) const;

    /// Checks for each paragraph what the filled page contains.
    void shows(std::initializer_list<Case> cases) const;
    /// Checks for each paragraph what the message contains with which filling fails.
    void refuses(std::initializer_list<Case> cases) const;

private:
    std::filesystem::path folder_;
};

/// The message of the page::Error that an action ends in, or "no error".
template <class Action>
std::string message_of(Action action) {
    try {
        action();
        return "no error";
    } catch (const page::Error& wrong) {
        return wrong.what();
    }
}

/// A command's exit status and all that it printed.
struct Outcome {
    int status;
    std::string words;
};
Outcome run_command(const std::string& command);
