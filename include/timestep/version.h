#pragma once
/// \file
/// Which version of the library this is, for C and C++. CMake reads it here.

#define TIMESTEP_VERSION_MAJOR 0  ///< grows where code that uses the library must change
#define TIMESTEP_VERSION_MINOR 1  ///< grows with what is new
#define TIMESTEP_VERSION_PATCH 0  ///< grows with what is repaired
