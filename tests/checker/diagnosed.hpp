#pragma once

#include "registry.hpp"
#include "session.hpp"

/// What an answer's calls are diagnosed as, in one word.
inline std::string diagnosed(const std::string& exercise, const checker::Truth& truth,
                             const std::vector<checker::Call>& calls) {
    checker::register_truth(exercise, truth);
    return checker::diagnose(exercise, truth, calls).label();
}
