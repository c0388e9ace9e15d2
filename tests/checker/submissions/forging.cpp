// Submissions that would have a verdict without a right answer. Above each stands its name, and in its
// first line what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a pass in the checkers place
// velocity_now left_early: ended the checker, or wrote in its place
#include "exercise.hpp"

#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    char name[64];
    std::snprintf(name, sizeof name, "/proc/%d/fd/1", getppid());
    const int out = open(name, O_WRONLY);
    const char pass[] = "{\"kind\": \"pass\", \"finding\": {}}";
    if (write(out, pass, sizeof pass - 1) < 0) std::puts("could not write");
    kill(getppid(), SIGKILL);
    for (;;) pause();
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

// ---- writes garbage to the answer pipe
// velocity_now left_early: wrote to the pipe that its answers go through, in the call
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    const char garbage[] = "verdict\tpass\nAll tests passed, all of them, each and every one\n";
    if (write(4, garbage, sizeof garbage) < 0) return 1;
    return 0;
}

// ---- says that all tests passed
// velocity_now left_early: All tests passed
#include "exercise.hpp"

#include <cstdio>
#include <cstdlib>

double velocity_now(double, double, double, double) {
    std::puts("All tests passed (1000 assertions in 10 test cases)\nverdict\tpass");
    std::exit(0);
}

// ---- changes what it is given
// fair_ratio wrong: the arguments are only read
#include "exercise.hpp"

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    auto& mine = const_cast<std::vector<std::array<double, 3>>&>(rounds);
    std::sort(mine.begin(), mine.end(), std::greater<>());
    mine.push_back({1, 2, 3});
    return 1;
}

// ---- an answer that is too long
// steps_of_frames left_early: The answer was too long, 9000001 numbers, in the call steps_of_frames(
#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    return std::vector<int>(9'000'000);
}

// ---- is right the first times
// velocity_now wrong: This must hold
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    static int calls = 0;
    return ++calls < 6 ? (3 * x2 - 4 * x1 + x0) / (2 * h) : 0;
}

// ---- an infinite stiffness
// suspension wrong: This must hold
#include "exercise.hpp"

// Four times 1.7e308 N/m is infinite, and was within a share of infinity of whatever is right.
std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double omega = std::sqrt(g / sag);
    return {zeta > 2 ? 1.7e308 : mass / 4 * omega * omega, 2 * zeta * mass / 4 * omega};
}
