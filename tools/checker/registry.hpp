#pragma once
/// \file
/// What the hidden tests hold of each exercise. Sources that the build writes fill it before main.

#include <string>
#include <utility>
#include <vector>

#include "truth.hpp"

namespace checker {

/// A mistake that the course knows, and what it would have answered.
struct Mistake {
    std::string name;
    Function made;
};

/// One exercise.
struct Registered {
    Truth truth = {};
    Within within = {};
    std::vector<Mistake> mistakes = {};
    std::vector<Answer> slips = {};  ///< the right answers, written so that they can slip (slips.hpp)
    Answer stub = {};
    std::vector<std::pair<std::string, Answer>> correct = {};  ///< the solution, and others written differently
};

/// What is registered of an exercise. Throws std::invalid_argument, one line, where nothing is.
const Registered& registered(const std::string& exercise);

/// Each adds a part to what is registered, and returns true.
bool register_truth(const std::string& exercise, Truth truth);
bool register_tolerance(const std::string& exercise, Within within);
bool register_mistakes(const std::string& exercise, std::vector<Mistake> mistakes);
bool register_slips(const std::string& exercise, std::vector<Answer> answers);
bool register_variants(const std::string& exercise, const Answer& stub, const Answer& solution,
                       std::vector<std::pair<std::string, Answer>> correct);

}  // namespace checker
