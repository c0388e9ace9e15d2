#pragma once
/// \file
/// What CMake makes when it configures: the files of exercises/, for one.

namespace course {

/// Lets CMake read again what there is. Throws Stop(bad_use) with its first error, in one line.
void configure();

}  // namespace course
