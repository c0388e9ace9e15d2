// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <sys/resource.h>

double velocity_now(double, double, double, double) {
    const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &more);
    std::vector<std::vector<double>> history;
    for (std::size_t size = 1'000'000;; size *= 4) history.emplace_back(size);
}
