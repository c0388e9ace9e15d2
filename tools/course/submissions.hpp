#pragma once
/// \file
/// What learners have handed in, whatever it is.

#include <filesystem>
#include <string>
#include <vector>

#include "exercises.hpp"

namespace course {

/// One learner's folder or file. Nothing in it is trusted: not what it is, not what it is called.
struct Submission {
    std::string name;  ///< as in_one_line writes it
    std::filesystem::path place;
};

/// An answer in a submission, or why there is none to check.
struct HandedIn {
    std::filesystem::path file;  ///< empty: nothing was handed in
    std::string refused;         ///< one line where the file cannot be taken
    bool whole = false;          ///< it is the submission that cannot be taken, whatever the exercise
    std::string beside = {};     ///< one line where another file of the submission may be meant as the answer
};

/// What a submission holds: for each exercise what is its answer, and the names of what nothing is taken from.
struct Answers {
    std::vector<HandedIn> all;
    std::vector<std::string> left_out = {};
};

/// The submissions in a place, and the names of what there is besides and is none.
struct Submissions {
    std::vector<Submission> all;
    std::vector<std::string> left_out = {};
    bool itself = false;  ///< there is one: the place itself
};

/// The submissions in `place`: itself, where it is a file, holds answers or a folder `exercises`, else each file
/// and folder in it; only itself where it is to be `one`. Throws Stop(bad_use) where there is none, and where it may
/// be one as well as a class.
Submissions find_submissions(const std::filesystem::path& place, const std::vector<Exercise>& exercises, bool one);

/// What a submission holds for each of these exercises: the file exercises/CHAPTER/NAME.cpp anywhere
/// in it, or the only file NAME.cpp, or of one exercise the only C++ file there is, unless that is named
/// after another exercise. A submission that is one file is the answer to the only exercise, or to the one
/// it is named after. No link is followed. Where an answer lies only in a folder that is left out, or only by its name
/// in other letters or with another ending, it is refused, with the reason; and beside an answer it is named. For .cpp
/// there may be .cc, .cxx or .c++. (collect_answers.cpp)
Answers collect_answers(const Submission& submission, const std::vector<Exercise>& exercises);

/// All exercises of the course.
const std::vector<Exercise>& all_exercises();

/// Is it what versions, file managers and archives leave beside the submissions, and beside each file of a Mac's?
bool is_ignored(const std::string& name);

/// Is it a part of the whole course, which lies in the same folder?
bool is_of_the_course(const std::filesystem::path& entry);

/// Is it a C++ file by its name: .cpp, .cc, .cxx or .c++, in small letters or large?
bool is_source(const std::filesystem::path& file);

/// Is it named after an exercise, of which we know that it is not the one looked for?
bool answers_another(const std::filesystem::path& file);

/// The text of an answer that is handed in. Throws Stop(bad_use), one line, where it is no file, is
/// larger than 1 MB, or cannot be read. No link is followed.
std::string text_of(const HandedIn& answer);

/// A name from outside in one line, which every format can hold as it is: two that differ stay different.
/// A backslash is \\, newline and tab are \n and \t. As \xNN comes each byte of what is obeyed or not seen,
/// of what is no UTF-8, and of a blank at either end.
std::string in_one_line(const std::string& name);

}  // namespace course
