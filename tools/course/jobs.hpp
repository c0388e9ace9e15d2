#pragma once
/// \file
/// Many checks at a time, each in a process of its own.

#include <cstddef>
#include <functional>
#include <vector>

#include "grades.hpp"

namespace course {

/// Does `work` for each of these, `most` at a time, each in a process of its own, and hands the
/// grades to `done` here, as they come. Ends those processes, and waits for them, where it throws:
/// Stop(interrupted) by Ctrl-C and the like, and what `done` throws. A process that is gone without
/// a grade has the verdict course_error.
void in_parallel(const std::vector<std::size_t>& which, int most, const std::function<Grade(std::size_t)>& work,
                 const std::function<void(std::size_t, const Grade&)>& done);

}  // namespace course
