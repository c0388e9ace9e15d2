#pragma once
/// \file
/// Finding submissions, and the answers in them.

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

/// What a submission holds: the answer to each exercise, and the names of folders and files that are left out.
struct Answers {
    std::vector<HandedIn> all;
    std::vector<std::string> left_out = {};
};

/// The submissions in a folder, and the names of what is left out.
struct Submissions {
    std::vector<Submission> all;
    std::vector<std::string> left_out = {};
};

/// The submissions in `place`: `place` itself, if it is a file, a whole kit, holds answers or a folder `exercises`, or
/// is `one` by the caller's word; otherwise each file and folder in it. Throws Stop(bad_use) if there is none, and if
/// `place` may be one submission as well as a class.
Submissions find_submissions(const std::filesystem::path& place, const std::vector<Exercise>& exercises, bool one);

/// What a submission holds for each of these exercises: the file exercises/CHAPTER/NAME.cpp anywhere
/// in it, or the only file NAME.cpp, or of one exercise the only C++ file there is, unless that is named
/// after another exercise. A submission that is one file is the answer to the only exercise, or to the one
/// it is named after. No link is followed. Where an answer lies only in a folder that is left out, or only by its name
/// in other letters or with another ending, it is refused, with the reason. For .cpp there may be .cc, .cxx or .c++.
Answers collect_answers(const Submission& submission, const std::vector<Exercise>& exercises);

/// The text of an answer. Throws Stop(bad_use), one line, if it is no regular file, is larger than 1 MB, or cannot be
/// read. Links are not followed.
std::string text_of(const HandedIn& answer);

/// A name from outside in one line that every format can hold. Different names stay different: a backslash becomes \\,
/// newline and tab become \n and \t, and each byte of an invisible character, of what is not UTF-8, and of a blank at
/// either end becomes \xNN.
std::string in_one_line(const std::string& name);

}  // namespace course
