// velocity_now wrong: which returned 0
#include "exercise.hpp"

#include <cstdint>
#include <functional>

#include <unistd.h>

// What goes before each message: the number of the call, what it is (0 ready, 1 an answer), its
// size.
struct Head {
    std::uint64_t number;
    std::uint32_t reply, bytes;
};

namespace checker {
using Answer = std::function<std::vector<double>(const std::vector<double>&)>;
int serve(const Answer&);

int serve(const Answer&) {
    const Head ready{0, 0, 0};
    if (write(4, &ready, sizeof ready) < 0) return 1;
    struct {
        Head head;
        double numbers[4];
    } call;
    while (read(3, &call.head, sizeof call.head) > 0 && read(3, call.numbers, 32) == 32) {
        const double zero = 0;
        call.head.bytes = sizeof zero;
        if (write(4, &call.head, sizeof call.head) < 0 || write(4, &zero, sizeof zero) < 0)
            return 1;
    }
    return 0;
}

}  // namespace checker

double velocity_now(double, double, double, double) {
    return 0;
}
