// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <new>

#include <sys/mman.h>

double velocity_now(double, double, double, double) {
    for (;;)
        if (mmap(nullptr, 65536, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED)
            throw std::bad_alloc();
}
