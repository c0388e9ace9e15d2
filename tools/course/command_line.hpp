#pragma once
/// \file
/// From the words of the command line to what they ask for.

#include "stop.hpp"

namespace course {

/// Reads the command line and does what it asks. Throws Stop where it cannot.
Status obey(int argc, char** argv);

}  // namespace course
