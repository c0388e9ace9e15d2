// What is known of the exercises: filled by sources that the build writes, before main.

#include <map>

#include "self_test.hpp"

namespace checker {

namespace {

std::map<std::string, std::vector<Mistake>>& mistakes() {
    static std::map<std::string, std::vector<Mistake>> known;
    return known;
}

std::map<std::string, Truth>& truths() {
    static std::map<std::string, Truth> known;
    return known;
}

std::map<std::string, Within>& tolerances() {
    static std::map<std::string, Within> known;
    return known;
}

std::map<std::string, Variants>& variants() {
    static std::map<std::string, Variants> known;
    return known;
}

}  // namespace

bool register_truth(const std::string& exercise, Truth truth) {
    return truths().emplace(exercise, std::move(truth)).second;
}

const Truth& truth_of_exercise(const std::string& exercise) { return truths()[exercise]; }

bool register_tolerance(const std::string& exercise, Within within) {
    return tolerances().emplace(exercise, std::move(within)).second;
}

const Within& within(const std::string& exercise) { return tolerances()[exercise]; }

bool register_mistakes(const std::string& exercise, std::vector<Mistake> list) {
    return mistakes().emplace(exercise, std::move(list)).second;
}

const std::vector<Mistake>& mistakes_of(const std::string& exercise) { return mistakes()[exercise]; }

bool register_variants(const std::string& exercise, const Answer& stub, const Answer& solution,
                       std::vector<std::pair<std::string, Answer>> correct) {
    correct.insert(correct.begin(), {"solution", solution});
    return variants().emplace(exercise, Variants{stub, std::move(correct)}).second;
}

const Variants& variants_of(const std::string& exercise) { return variants()[exercise]; }

}  // namespace checker
