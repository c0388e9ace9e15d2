#pragma once
/// \file
/// The exercises, as their folders say.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "files.hpp"

namespace course {

/// A mistake that the course knows: what it is, and the way out.
struct Misconception {
    std::string says, hint;
};

struct Exercise {
    std::string name;     ///< `velocity_now`, the learner's function; unique in the course
    std::string chapter;  ///< `01_derivatives`
    int number = 0;       ///< its place in the chapter
    std::string title, level, practises;
    std::string declaration;
    bool eigen = false;
    std::vector<std::string> hints;
    std::string learned;

    /// What is told of it, about.json.
    std::filesystem::path about() const;
    /// What the build has made of mistakes.diff, for those who tell the learner.
    std::filesystem::path told() const;
    /// The mistakes that are known, by their names. Throws Stop(bad_use).
    std::map<std::string, Misconception> mistakes() const;

    /// 1.1
    std::string place() const;
    /// The learner's file, `exercises/01_derivatives/velocity_now.cpp` in the checkout.
    std::filesystem::path file() const;
    /// The same, as it is before the learner has touched it.
    std::filesystem::path stub() const;
    /// Its declaration, which is read before the learner's file.
    std::filesystem::path declared() const;
    /// The course's answer, which is not in every learner's edition.
    std::filesystem::path solution() const;
    bool has_solution() const;
};

/// Is this the learner's edition, which has no tests, and solutions only where the teacher has packed them?
bool is_kit();

/// All exercises, in the order of the course. Throws Stop(bad_use) naming an about.json that cannot
/// be used.
std::vector<Exercise> read_exercises();

/// The exercise meant by `velocity_now`, `1.1` or its file, if there is one.
std::optional<Exercise> exercise_of(const std::string& name);

/// The same. Throws Stop(bad_use), with the name that is nearest, where there is none.
Exercise find_exercise(const std::string& name);

/// Is the learner's file as it was before the learner has touched it?
bool untouched(const Exercise& exercise);

/// The text of an answer. Throws Stop(bad_use), one clear line, where it cannot be read.
std::string answer_in(const Exercise& exercise, const std::filesystem::path& file);

}  // namespace course
