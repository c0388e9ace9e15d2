#pragma once
/// \file
/// What CMake makes when it configures: the files of exercises/, for one.

#include <string>

namespace course {

/// Lets CMake read again what there is. Throws Stop(bad_use) with its first error, in one line.
void configure();

/// Why what CMake has written cannot be built at all, in one line; nothing where it can.
std::string why_unbuildable();

}  // namespace course
