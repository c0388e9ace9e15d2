#pragma once
// An engine from a checkout is compiled into a module of its own, once as it is and once with each patch: their names
// would clash in one program.

#include "engine.hpp"

// The only name that a module shows: the engines that it has.
extern "C" __attribute__((visibility("default"))) void timestep_engines(std::vector<engines::Engine>& engines);
