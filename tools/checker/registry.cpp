#include "registry.hpp"

#include <map>
#include <stdexcept>

namespace checker {

namespace {

// In a function, since what fills it runs before main, in any order.
std::map<std::string, Registered>& all() {
    static std::map<std::string, Registered> exercises;
    return exercises;
}

}  // namespace

const Registered& registered(const std::string& exercise) {
    const auto found = all().find(exercise);
    if (found == all().end()) throw std::invalid_argument("'" + exercise + "' is no exercise of these tests");
    return found->second;
}

bool register_truth(const std::string& exercise, Truth truth) {
    all()[exercise].truth = std::move(truth);
    return true;
}

bool register_tolerance(const std::string& exercise, Within within) {
    all()[exercise].within = std::move(within);
    return true;
}

bool register_mistakes(const std::string& exercise, std::vector<Mistake> mistakes) {
    all()[exercise].mistakes = std::move(mistakes);
    return true;
}

bool register_slips(const std::string& exercise, std::vector<Answer> answers) {
    all()[exercise].slips = std::move(answers);
    return true;
}

bool register_variants(const std::string& exercise, const Answer& stub, const Answer& solution,
                       std::vector<std::pair<std::string, Answer>> correct) {
    correct.insert(correct.begin(), {"solution", solution});
    all()[exercise].stub = stub;
    all()[exercise].correct = std::move(correct);
    return true;
}

}  // namespace checker
