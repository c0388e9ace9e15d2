#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace page {

/// One exercise, as its about.json and its file tell it.
struct Exercise {
    std::string name, chapter;  ///< `velocity_now`, `01_derivatives`
    int number;                 ///< its place in the chapter
    std::string title, level, practises, declaration;
    std::vector<std::string> hints;  ///< as Markdown
    std::string task;                ///< the comment that its file begins with, as Markdown

    /// `1.2`
    std::string place() const;
    /// The id of its section on the page of the exercises.
    std::string id() const { return "exercise_" + name; }
};

/// Every exercise of a chapter, in order, and into `inputs` the files that tell of them. Throws Error
/// for a faulty about.json.
std::vector<Exercise> load_exercises(const std::filesystem::path& root, const std::string& chapter,
                                     std::vector<std::filesystem::path>& inputs);

}  // namespace page
