// What one of many springs or bodies costs, in lanes, beside loops written by hand, other libraries and the memory
// itself. The flags are in the programs' names.

#include "many.hpp"

#include <cstdio>

#include <timestep/lanes.hpp>

int main(int argc, char** argv) {
    if (argc > 1) return std::fprintf(stderr, "bench_many: %s: takes no options\n", argv[1]), 2;
    std::printf("%s: %d lanes in float, %d in double\n", BENCH_FLAGS, timestep::native_width<float>,
                timestep::native_width<double>);
    int status = many::bodies();
    if (status == 0) status = many::springs();
    std::printf("\n");
    return status;
}
