// Submissions that no exercise plans for, one after the other. Above each stands its name, and in its first line
// what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a pass in the checkers place
// velocity_now too_slow: could not write
#include "exercise.hpp"

#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    char name[64];
    std::snprintf(name, sizeof name, "/proc/%d/fd/1", getppid());
    const int out = open(name, O_WRONLY);
    const char pass[] = "verdict\tpass\n";
    if (write(out, pass, sizeof pass - 1) < 0) std::puts("could not write");
    kill(getppid(), SIGKILL);
    for (;;) pause();
}

// ---- a pass in the course programs place
// velocity_now wrong: could not write
// graded: crash
#include "exercise.hpp"

#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

// The parent's parent, from the fourth field of /proc/PARENT/stat; the second is "(check)".
static int grandparent() {
    char name[64];
    std::snprintf(name, sizeof name, "/proc/%d/stat", getppid());
    std::FILE* const file = std::fopen(name, "r");
    int pid = 0;
    if (!file || std::fscanf(file, "%*d %*s %*c %d", &pid) != 1) std::puts("no grandparent");
    std::fclose(file);
    return pid;
}

double velocity_now(double, double, double, double) {
    static bool first = true;
    if (first) {
        char name[64];
        std::snprintf(name, sizeof name, "/proc/%d/fd/1", grandparent());
        const int out = open(name, O_WRONLY | O_APPEND);
        const char pass[] = "{\"exercise\":\"velocity_now\",\"verdict\":\"pass\"}\n";
        if (write(out, pass, sizeof pass - 1) < 0) std::puts("could not write");
    }
    first = false;
    return 0;
}

// ---- answers before it is asked
// velocity_now left_early: wrote to the pipe that its answers go through
#include "exercise.hpp"

#include <cstdint>

#include <unistd.h>

// What goes before each message: the number of the call, what it is (0 ready, 1 an answer), its
// size.
struct Head {
    std::uint64_t number;
    std::uint32_t reply, bytes;
};

static const bool asked = [] {
    const Head ready{0, 0, 0};
    bool well = write(4, &ready, sizeof ready) > 0;
    for (std::uint64_t call = 0; call < 1000; ++call) {
        const struct {
            Head head;
            double zero;
        } answer{{call, 1, 8}, 0};
        well = write(4, &answer, sizeof answer) > 0 && well;
    }
    return well;
}();

double velocity_now(double, double, double, double) { return asked; }

// ---- lowers the limits of the checker
// velocity_now wrong: no limit: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/resource.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    const rlimit none{0, 0};
    if (prlimit(getppid(), RLIMIT_AS, &none, nullptr) < 0) std::perror("no limit");
    return 0;
}

// ---- overrides read
// velocity_now left_early: instead of returning
#include "exercise.hpp"

#include <unistd.h>

extern "C" ssize_t read(int, void*, size_t) { return 0; }

double velocity_now(double, double, double, double) { return 0; }

// ---- overrides the sine and the root
// velocity_now wrong: This must hold
#include "exercise.hpp"

extern "C" double sin(double) noexcept { return 0; }
extern "C" double sqrt(double) noexcept { return 0; }
extern "C" double fabs(double) noexcept { return 0; }

double velocity_now(double, double, double, double) { return 0; }

// ---- overrides write
// velocity_now too_slow: before the first call
#include "exercise.hpp"

#include <unistd.h>

extern "C" ssize_t write(int, const void*, size_t size) { return static_cast<ssize_t>(size); }

double velocity_now(double, double, double, double) { return 0; }

// ---- reads what the checker reads
// velocity_now wrong: what it reads: Permission denied
#include "exercise.hpp"

#include <cstdio>
#include <string>

#include <fcntl.h>
#include <unistd.h>

// The seed comes by the checker's standard input.
double velocity_now(double, double, double, double) {
    const std::string name = "/proc/" + std::to_string(getppid()) + "/fd/0";
    if (open(name.c_str(), O_RDONLY) < 0) std::perror("what it reads");
    return 0;
}

// ---- serves itself and answers zero
// velocity_now wrong: returned 0; right is
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
        if (write(4, &call.head, sizeof call.head) < 0 || write(4, &zero, sizeof zero) < 0) return 1;
    }
    return 0;
}

}  // namespace checker

double velocity_now(double, double, double, double) { return 0; }

// ---- serves itself and repeats an older answer
// velocity_now left_early: wrote to the pipe that its answers go through, in the call
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

int serve(const Answer& answer) {
    const Head ready{0, 0, 0};
    if (write(4, &ready, sizeof ready) < 0) return 1;
    struct {
        Head head;
        double numbers[4];
    } call;
    struct {
        Head head;
        double number;
    } first{};
    while (read(3, &call.head, sizeof call.head) > 0 && read(3, call.numbers, 32) == 32) {
        if (first.head.bytes == 0)
            first = {{call.head.number, 1, sizeof(double)},
                     answer(std::vector<double>(call.numbers, call.numbers + 4))[0]};
        if (write(4, &first, sizeof first) < 0) return 1;
    }
    return 0;
}

}  // namespace checker

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- snoops in the environment
// velocity_now wrong: no environment: Permission denied
#include "exercise.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    const auto name = "/proc/" + std::to_string(getppid()) + "/environ";
    std::FILE* const file = std::fopen(name.c_str(), "r");
    if (!file || std::fgetc(file) == EOF) std::perror("no environment");
    return std::getenv("HOME") || std::getenv("FIXTURE_SOURCE") ? 1 : 0;
}

// ---- writes garbage to the answer pipe
// velocity_now left_early: wrote to the pipe that its answers go through, in the call
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    const char garbage[] = "verdict\tpass\nAll tests passed, all of them, each and every one\n";
    if (write(4, garbage, sizeof garbage) < 0) return 1;
    return 0;
}
