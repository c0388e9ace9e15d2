#pragma once
/// \file
/// The exercises, read from their folders.

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

    /// Its about.json.
    std::filesystem::path about() const;
    /// What the build has made of mistakes.diff: what is said to the learner.
    std::filesystem::path told() const;
    /// The known mistakes, by name. Throws Stop(bad_use).
    std::map<std::string, Misconception> mistakes() const;

    /// 1.1
    std::string place() const;
    /// The learner's file, `exercises/01_derivatives/velocity_now.cpp` in the checkout.
    std::filesystem::path file() const;
    /// The learner's file as it is at the beginning.
    std::filesystem::path stub() const;
    /// The header with its declaration, which the compiler reads before the learner's file.
    std::filesystem::path declared() const;
    /// The course's answer. Not every learner's edition has it.
    std::filesystem::path solution() const;
    bool has_solution() const;
};

/// Is this a learner's edition? It has no tests, and solutions only if the teacher has packed them.
bool is_kit();

/// All exercises, in the order of the course. Throws Stop(bad_use) with the name of an about.json that cannot be used.
std::vector<Exercise> read_exercises();

/// The exercise called `velocity_now`, `1.1`, or by its file; nothing if there is none.
std::optional<Exercise> exercise_of(const std::string& name);

/// That exercise. Throws Stop(bad_use) with the nearest name if there is none.
Exercise find_exercise(const std::string& name);

/// Is the learner's file as it was at the beginning?
bool untouched(const Exercise& exercise);

/// The text of an answer. Throws Stop(bad_use) if it cannot be read.
std::string answer_in(const Exercise& exercise, const std::filesystem::path& file);

}  // namespace course
