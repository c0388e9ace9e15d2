// The engines from checkouts: a module for each, made by the build where it was told of the checkout.

#include <dlfcn.h>

#include <sstream>
#include <stdexcept>

#include "module.hpp"

namespace engines {

// ENGINE_MODULES: their files, with | between them. ENGINE_MISSING: a line for each engine without any.
void enter_checkouts(std::vector<Engine>& engines, std::vector<std::string>& missing) {
    std::istringstream modules(ENGINE_MODULES), lines(ENGINE_MISSING);
    for (std::string file; std::getline(modules, file, '|');) {
        void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);  // for as long as the program runs
        if (!module) throw std::runtime_error(dlerror());
        const auto enter = reinterpret_cast<decltype(&timestep_engines)>(dlsym(module, "timestep_engines"));
        if (!enter) throw std::runtime_error(dlerror());
        enter(engines);
    }
    for (std::string line; std::getline(lines, line, '|');) missing.push_back(line);
}

}  // namespace engines
