#pragma once
/// \file
/// The grades of a run: kept as they come, and written for people and for other programs.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "exercises.hpp"

namespace course {

/// One answer of one submission.
struct Grade {
    std::string submission;  ///< its name, in one line
    std::string exercise;
    std::string verdict;  ///< as check's, or `missing` (nothing handed in), or `refused`
    std::string says;     ///< the words that a learner would read
    std::uint64_t seed = 0;
    double seconds = 0;
    bool in_time = true;  ///< false if the compiler or the answer was stopped

    bool passed() const { return verdict == "pass"; }
    bool could_not_be_checked() const { return verdict == "course_error"; }
};

/// The grades of a run, kept in a file as they come, so that a stopped run goes on where it was. Everything in the file
/// belongs to one edition of the course; another edition empties it.
class Journal {
public:
    /// Throws Stop(bad_use) if the file cannot be read or written.
    Journal(const std::filesystem::path& file, const std::string& edition);

    /// The earlier grade of this answer; null if there is none. `answer` is the text of the file. A check that failed
    /// counts as a grade only after `most_failures` failures, so that an answer that breaks the checker is not checked
    /// for ever.
    const Grade* find(const std::string& submission, const std::string& exercise, const std::string& answer) const;
    /// Throws Stop(bad_use) if it cannot be kept.
    void keep(const Grade& grade, const std::string& answer);

private:
    static constexpr int most_failures = 3;
    std::filesystem::path file_;
    std::map<std::string, Grade> known_;  // by submission, exercise and text
    std::map<std::string, int> failures_;
    std::ofstream out_;
};

/// A hash of a text.
std::string mark_of(const std::string& text);

/// Writes grades.json, grades.csv and junit.xml, and for a single submission results.json, as Gradescope reads it.
/// `grades` are in the order of the submissions. Throws Stop(bad_use).
void write_grades(const std::filesystem::path& folder, const std::vector<Exercise>& exercises,
                  const std::vector<Grade>& grades, bool single);

}  // namespace course
