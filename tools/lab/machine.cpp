// What a time was measured with.

#include <fstream>

#include "lab.hpp"

namespace lab {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
    return "an unknown processor";
}

std::string compiler() {
#if defined(__clang__)
    return "clang " + std::to_string(__clang_major__);
#elif defined(__GNUC__)
    return "g++ " + std::to_string(__GNUC__);
#else
    return "an unknown compiler";
#endif
}

}  // namespace lab
