#pragma once
/// \file
/// What a grading has found: kept as it comes, and written for people and for other programs.

#include <filesystem>
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
    std::string says;     ///< what a learner would be told
    std::uint64_t seed = 0;
    double seconds = 0;
    bool in_time = true;  ///< false where compiler or answer had not come to an end

    bool passed() const { return verdict == "pass"; }
    bool could_not_be_checked() const { return verdict == "course_error"; }
};

/// The grades of a run, kept in a file as they come, so that a run that was stopped goes on where it
/// was. Everything in it belongs to one edition of the course; another empties it.
class Journal {
public:
    /// Throws Stop(bad_use) where the file cannot be read or written.
    Journal(const std::filesystem::path& file, const std::string& edition);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// The grade of this answer, if it was given before. `answer` is the text of the file. One that could
    /// not be checked is none until that has happened `most_failures` times: an answer that breaks the checker
    /// is not to do so for ever.
    const Grade* find(const std::string& submission, const std::string& exercise, const std::string& answer) const;
    /// Throws Stop(bad_use) where it cannot be kept.
    void keep(const Grade& grade, const std::string& answer);

private:
    static constexpr int most_failures = 3;
    std::filesystem::path file_;
    std::map<std::string, Grade> known_;  // by submission, exercise and text
    std::map<std::string, int> failures_;
    int out_ = -1;
};

/// A number for a text that no other text is likely to have.
std::string mark_of(const std::string& text);

/// grades.json, grades.csv and junit.xml, and for a single submission results.json, as Gradescope
/// reads it. `grades` stand in the order of the submissions. Throws Stop(bad_use).
void write_grades(const std::filesystem::path& folder, const std::vector<Exercise>& exercises,
                  const std::vector<Grade>& grades, bool single);

}  // namespace course
