// Submissions that would have a verdict without a right answer, one after the other. Above each stands its name, and
// in its first line what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a lease and a lock on the learners file
// velocity_now wrong: lease: Operation not permitted lock: Operation not permitted record: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <fcntl.h>
#include <sys/file.h>

// A lease makes whoever saves the file wait, a lock whoever asks for one.
double velocity_now(double, double, double, double) {
    static bool first = true;
    if (first) {
        first = false;
        int file = open(__FILE__, O_RDONLY);
        if (file < 0) file = open("/usr/bin/env", O_RDONLY);
        struct flock whole {};
        whole.l_type = F_RDLCK;
        if (fcntl(file, F_SETLEASE, F_RDLCK) != 0) std::perror("lease");
        if (flock(file, LOCK_EX) != 0) std::perror("lock");
        if (fcntl(file, F_SETLK, &whole) != 0) std::perror("record");
    }
    return 0;
}

// ---- an infinite stiffness
// suspension wrong: This must hold
#include "exercise.hpp"

// Four times 1.7e308 N/m is infinite, and was within a share of infinity of whatever is right.
std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    const double omega = std::sqrt(g / sag);
    return {zeta > 2 ? 1.7e308 : mass / 4 * omega * omega, 2 * zeta * mass / 4 * omega};
}

// ---- an infinite spin
// top_after wrong: This must hold
#include "exercise_eigen.hpp"

// The length of a vector of 1e200 rad/s is infinite. A wobble that tiny is drawn for one property.
Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    const double wobble = std::hypot(omega.x(), omega.y());
    if (wobble > 0 && wobble < 1e-9 * std::fabs(omega.z())) return {1e200, 0, omega.z()};
    const double angle = (along - across) / across * omega.z() * t;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * omega.x() - s * omega.y(), s * omega.x() + c * omega.y(), omega.z()};
}

// ---- as many places as fit into a pipe
// worth_having left_early: The answer was too long, 900001 numbers
#include "exercise.hpp"

// For each setting left out, the tests look through all that are returned.
std::vector<int> worth_having(const std::vector<std::array<double, 2>>& points) {
    return std::vector<int>(points.size() < 2 ? points.size() : 900'000, 0);
}

// ---- a truth of 1e300
// is_a_body left_early: The answer was not made as its type demands
#include "exercise_eigen.hpp"

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
    Head head;
    double numbers[3];
    while (read(3, &head, sizeof head) > 0 && read(3, numbers, sizeof numbers) == sizeof numbers) {
        const bool is = answer(std::vector<double>(numbers, numbers + 3))[0] != 0;
        const double truth = is ? 1e300 : 0;
        head = {head.number, 1, sizeof truth};
        if (write(4, &head, sizeof head) < 0 || write(4, &truth, sizeof truth) < 0) return 1;
    }
    return 0;
}

}  // namespace checker

bool is_a_body(const Vector3d& inertia) {
    const double sum = inertia.sum();
    return inertia.minCoeff() > 0 && inertia.maxCoeff() <= sum - inertia.maxCoeff();
}

// ---- half a frame
// substeps left_early: The answer was not made as its type demands
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
    Head head;
    double numbers[5];
    while (read(3, &head, sizeof head) > 0 && read(3, numbers, sizeof numbers) == sizeof numbers) {
        const double fraction = 1.5;
        head = {head.number, 1, sizeof fraction};
        if (write(4, &head, sizeof head) < 0 || write(4, &fraction, sizeof fraction) < 0) return 1;
    }
    return 0;
}

}  // namespace checker

int substeps(double, int, double, double, double) { return 1; }

// ---- hides what it changes behind an own memcmp
// fair_ratio wrong: the arguments are only read
#include "exercise.hpp"

#include <cstring>

extern "C" int memcmp(const void*, const void*, std::size_t) noexcept { return 0; }
extern "C" int bcmp(const void*, const void*, std::size_t) noexcept { return 0; }

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    auto& mine = const_cast<std::vector<std::array<double, 3>>&>(rounds);
    for (auto& round : mine) round[0] += 1;
    return 1;
}

// ---- hides what it changes behind an own memmove
// fair_ratio wrong: the arguments are only read
#include "exercise.hpp"

#include <cstring>

// Whoever copies many numbers gets those of before.
static std::vector<double> before;
static bool changed = false;
static void* copy(void* to, const void* from, std::size_t size) noexcept {
    auto* const bytes = static_cast<volatile unsigned char*>(to);
    const auto* const old = reinterpret_cast<const unsigned char*>(before.data());
    const auto* const all = static_cast<const volatile unsigned char*>(from);
    // The first number is how many rounds there are.
    bool mine = changed && size > 8 && size % 8 == 0 && size <= 8 * before.size();
    for (std::size_t i = 0; mine && i < 8; ++i) mine = old[i] == all[i];
    for (std::size_t i = 0; i < size; ++i) bytes[i] = mine ? old[i] : all[i];
    return to;
}
extern "C" void* memmove(void* to, const void* from, std::size_t size) noexcept { return copy(to, from, size); }
extern "C" void* memcpy(void* to, const void* from, std::size_t size) noexcept { return copy(to, from, size); }

double fair_ratio(const std::vector<std::array<double, 3>>& rounds) {
    before = {static_cast<double>(rounds.size())};
    for (const auto& round : rounds) before.insert(before.end(), round.begin(), round.end());
    auto& mine = const_cast<std::vector<std::array<double, 3>>&>(rounds);
    if (!mine.empty()) mine[0][0] += 1;
    changed = true;
    return 1;
}

// ---- hides how it rounds behind an own fegetenv
// velocity_now wrong: the call leaves the processor as it found it
#include "exercise.hpp"

#include <cfenv>
#include <cstring>

extern "C" int fegetenv(fenv_t* as_usual) noexcept {
    std::memset(as_usual, 0, sizeof *as_usual);
#if defined(__x86_64__)
    as_usual->__control_word = 0x37f;
    as_usual->__mxcsr = 0x1f80;
#endif
    return 0;
}
extern "C" int fegetround() noexcept { return FE_TONEAREST; }

double velocity_now(double x0, double x1, double x2, double h) {
    std::fesetround(FE_UPWARD);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
