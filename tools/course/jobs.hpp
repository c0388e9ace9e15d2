#pragma once
/// \file
/// Many checks at a time, each in a process of its own.

#include <cstddef>
#include <functional>
#include <vector>

#include "grades.hpp"

namespace course {

/// Does `work` for each of these, at most `most` at a time, each in a process of its own, and passes the grades to
/// `done` in this process, as they come. A process that ends without a grade gets the verdict course_error. Throws
/// Stop(interrupted) after Ctrl-C, and what `done` throws; then it first ends those processes.
void in_parallel(const std::vector<std::size_t>& which, int most, const std::function<Grade(std::size_t)>& work,
                 const std::function<void(std::size_t, const Grade&)>& done);

}  // namespace course
