#pragma once

#include <filesystem>
#include <set>
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

/// A formula of a task, `f(omega2) = I (omega2 - omega1) + h omega2 x (I omega2)`, as TeX: names of letters as they
/// are written in mathematics, their digits as indices, a lone `x` between two things as the vector product.
std::string formula_tex(const std::string& plain);

/// The names of the parameters in a declaration.
std::set<std::string> names_in(const std::string& declaration);

/// A sentence as Markdown, in which what is a formula by the looks of it, made of `names`, letters, numbers and signs,
/// is set as one, and what is C++ as code. What looks like half a formula stays as it is.
std::string with_formulas(const std::string& sentence, const std::set<std::string>& names);

}  // namespace page
