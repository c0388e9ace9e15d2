#pragma once
/// \file
/// Several checks at a time.

#include <cstddef>
#include <functional>
#include <vector>

#include "grades.hpp"

namespace course {

/// Does `work` for each of these, in at most `most` threads, and passes the grades to `done`, one at a time, as they
/// come. Throws Stop(interrupted) after Ctrl-C, and what `work` or `done` throws.
void in_parallel(const std::vector<std::size_t>& which, std::size_t most, const std::function<Grade(std::size_t)>& work,
                 const std::function<void(std::size_t, const Grade&)>& done);

}  // namespace course
