// Submissions that no exercise plans for, one after the other. Above each stands its name, and in its first line
// what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- adds to memory that was never written
// velocity_now wrong: e+303
#include "exercise.hpp"

#include <memory>

double velocity_now(double x0, double x1, double x2, double h) {
    const auto sum = std::make_unique_for_overwrite<double[]>(3);
    sum[1] += (3 * x2 - 4 * x1 + x0) / (2 * h);
    return sum[1];
}

// ---- adds to what was never written
// velocity_now wrong: e+303
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    double sum;
    sum += (3 * x2 - 4 * x1 + x0) / (2 * h);
    return sum;
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

// ---- does not take what it is given
// sort_by_kind wrong
#include "exercise.hpp"

#include <cstdint>
#include <functional>

#include <unistd.h>

struct Head {
    std::uint64_t number;
    std::uint32_t reply, bytes;
};

static void take(void* to, std::size_t size) {
    for (char* at = static_cast<char*>(to); size > 0;) {
        const auto got = read(3, at, size);
        if (got <= 0) _exit(0);
        at += got;
        size -= static_cast<std::size_t>(got);
    }
}

// It serves itself. The longest call does not fit into the pipe, and of that it takes the beginning only.
namespace checker {
int serve(const std::function<std::vector<double>(const std::vector<double>&)>&) {
    const Head ready{0, 0, 0};
    if (write(4, &ready, sizeof ready) < 0) return 1;
    for (static char call[1 << 20];;) {
        Head head;
        take(&head, sizeof head);
        if (head.bytes > 1 << 16) pause();
        take(call, head.bytes);
        const Head answer{head.number, 1, 2 * sizeof(double)};
        const double nothing[2] = {0, 0};
        if (write(4, &answer, sizeof answer) < 0 || write(4, nothing, sizeof nothing) < 0) return 1;
    }
}
}  // namespace checker

std::array<std::vector<int>, 2> sort_by_kind(const std::vector<int>&, int) { return {}; }

// ---- has no memory to give
// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <new>

void* operator new(std::size_t) { throw std::bad_alloc(); }

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- memory in a file without a name
// velocity_now wrong: no file: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/mman.h>

double velocity_now(double, double, double, double) {
    if (memfd_create("memory", 0) < 0) std::perror("no file");
    return 0;
}

// ---- memory in many threads
// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <thread>

double velocity_now(double, double, double, double) {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([] {
            std::vector<std::vector<double>> history;
            for (std::size_t size = 1'000'000;; size *= 1000) history.emplace_back(size);
        });
    for (auto& thread : threads) thread.join();
    return 0;
}

// ---- memory in small pieces
// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <new>

#include <sys/mman.h>

double velocity_now(double, double, double, double) {
    for (;;)
        if (mmap(nullptr, 65536, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED) throw std::bad_alloc();
}

// ---- memory kept in a pipe
// velocity_now wrong: 0 of 6 ways are open
#include "exercise.hpp"

#include <cstdio>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/uio.h>
#include <unistd.h>

// What is given back while a pipe holds a byte of it stays taken, and counts as nobody's.
double velocity_now(double, double, double, double) {
    static int open = -1;
    int from[2], to[2];
    if (open >= 0 || pipe(from) != 0 || pipe(to) != 0) return 0;
    static char byte = 1;
    iovec piece{&byte, 1};
    if (write(from[1], "ab", 2) != 2) return 0;
    open = (fcntl(to[1], F_SETPIPE_SZ, 1 << 20) >= 0) + (vmsplice(to[1], &piece, 1, 0) >= 0) +
           (tee(from[0], to[1], 1, 0) >= 0) + (splice(from[0], nullptr, to[1], nullptr, 1, 0) >= 0) +
           (prctl(PR_SET_THP_DISABLE, 0, 0, 0, 0) >= 0) + (prctl(PR_GET_THP_DISABLE, 0, 0, 0, 0) == 0);
    std::printf("%d of 6 ways are open\n", open);
    return 0;
}

// ---- memory that outlives it
// velocity_now wrong: no memory: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/shm.h>

double velocity_now(double, double, double, double) {
    if (shmget(IPC_PRIVATE, 1 << 30, IPC_CREAT | 0600) < 0) std::perror("no memory");
    return 0;
}

// ---- puts a link in place of what it prints
// velocity_now wrong: no link: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    char name[4096];
    const ssize_t size = readlink("/proc/self/fd/1", name, sizeof name - 1);
    name[size > 0 ? size : 0] = '\0';
    unlink(name);
    if (symlink("/etc/passwd", name) != 0) std::perror("no link");
    return 0;
}

// ---- reads the checkers memory
// velocity_now wrong: no memory: Permission denied
#include "exercise.hpp"

#include <cstdio>
#include <string>

#include <fcntl.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    const auto name = "/proc/" + std::to_string(getppid()) + "/mem";
    if (open(name.c_str(), O_RDONLY) < 0) std::perror("no memory");
    return 0;
}

// ---- too much memory
// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    std::vector<std::vector<double>> history;
    for (std::size_t size = 1'000'000;; size *= 1000) history.emplace_back(size, x0);
    return (x2 - x1) / h;
}

// ---- variables too large for memory
// velocity_now too_much_memory: before the first call of velocity_now
#include "exercise.hpp"

volatile double grid[200'000'000];

double velocity_now(double x0, double x1, double x2, double h) {
    grid[0] = h;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- writes into the checkers memory
// velocity_now wrong: no memory: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/uio.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    char zero[8]{};
    const iovec here{zero, sizeof zero}, there{reinterpret_cast<void*>(0x400000), sizeof zero};
    if (process_vm_writev(getppid(), &here, 1, &there, 1, 0) < 0) std::perror("no memory");
    return 0;
}
