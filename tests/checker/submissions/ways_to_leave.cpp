// Submissions that no exercise plans for, one after the other. Above each stands its name, and in its first line
// what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a fork bomb
// velocity_now too_slow: Is there a loop
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (;;) fork();
}

// ---- a thread bomb
// velocity_now crash: Resource temporarily unavailable
#include "exercise.hpp"

#include <thread>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (;;)
        std::thread([] {
            for (;;) pause();
        }).detach();
}

// ---- an endless loop
// velocity_now too_slow: in time (2 s of work
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    volatile bool never = false;
    while (!never) {
    }
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- an endless loop before the first call
// velocity_now too_slow: before the first call of velocity_now. Is there a loop
#include "exercise.hpp"

const double limit = [] {
    for (volatile bool never = false; !never;) {
    }
    return 2.0;
}();

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- becomes another program
// velocity_now left_early: ended with status 0 instead of returning
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    execl("/bin/true", "true", nullptr);
    return 0;
}

// ---- becomes another user
// velocity_now wrong: no namespace: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sched.h>

double velocity_now(double, double, double, double) {
    if (unshare(CLONE_NEWUSER) < 0) std::perror("no namespace");
    return 0;
}

// ---- closes the pipe
// velocity_now left_early: The program closed the pipe that its answers go through, in the call
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    close(4);
    for (;;) pause();
}

// ---- ends the checker
// velocity_now too_slow: waits for what does not come
#include "exercise.hpp"

#include <csignal>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    kill(getppid(), SIGTERM);
    for (;;) pause();
}

// ---- goes round by another gate
// velocity_now wrong: 32-bit: -38
#include "exercise.hpp"

#include <csetjmp>
#include <csignal>
#include <cstdio>

static sigjmp_buf closed;

double velocity_now(double, double, double, double) {
    static long result;
    result = -38;
#if defined(__x86_64__)
    // creat, in the numbers of 32-bit programs; a system without that gate answers with a signal
    std::signal(SIGSEGV, [](int) { siglongjmp(closed, 1); });
    if (sigsetjmp(closed, 1) == 0)
        asm volatile("int $0x80" : "=a"(result) : "a"(8), "b"(0), "c"(0) : "memory", "r8", "r9", "r10", "r11");
#endif
    std::printf("32-bit: %ld\n", result);
    return 0;
}

// ---- goes round by x32 and io uring
// velocity_now wrong: x32: Function not implemented io_uring: Function not implemented
#include "exercise.hpp"

#include <cstdio>

#include <sys/syscall.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    if (syscall(0x4000'0000 + SYS_openat, 0, 0, 0) < 0) std::perror("x32");
    if (syscall(SYS_io_uring_setup, 1, nullptr) < 0) std::perror("io_uring");
    return 0;
}

// ---- leaves a grandchild that holds the pipe
// velocity_now left_early: ended with status 0 instead of returning
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    if (fork() == 0 && setsid() > 0 && fork() == 0)
        for (;;) pause();
    _exit(0);
}

// ---- leaves before everything
// velocity_now left_early: ended with status 0 instead of returning, before the first call
#include "exercise.hpp"

#include <unistd.h>

[[gnu::constructor(101)]] static void leave() { _exit(0); }

double velocity_now(double, double, double, double) { return 0; }

// ---- leaves before the first call
// velocity_now left_early: ended with status 0 instead of returning, before the first call
#include "exercise.hpp"

#include <cstdlib>

const double limit = (std::exit(0), 2.0);

double velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- leaves busy threads behind
// velocity_now wrong: This must hold
#include "exercise.hpp"

#include <thread>

double velocity_now(double, double, double, double) {
    static int threads = 0;
    if (++threads > 8) return 0;
    std::thread([] {
        for (volatile int i = 0;; i = i + 1) {
        }
    }).detach();
    return 0;
}

// ---- leaves in a destructor
// velocity_now left_early: ended with status 0 instead of returning, in the call
#include "exercise.hpp"

#include <cstdlib>

#include <unistd.h>

struct Leaver {
    ~Leaver() { _exit(0); }
};
static Leaver leaver;

double velocity_now(double, double, double, double) { std::exit(1); }

// ---- leaves in a handler of the end
// velocity_now left_early: ended with status 0 instead of returning, in the call
#include "exercise.hpp"

#include <cstdlib>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    std::atexit([] { _exit(0); });
    std::exit(1);
}

// ---- leaves with status 0
// velocity_now left_early: The program ended with status 0 instead of returning, in the call velocity_now(
#include "exercise.hpp"

#include <cstdlib>

double velocity_now(double x0, double x1, double x2, double h) {
    std::exit(0);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- leaves with status 127
// velocity_now left_early: The program ended with status 127 instead of returning, in the call
#include "exercise.hpp"

#include <cstdlib>

double velocity_now(double, double, double, double) { std::exit(127); }

// ---- listens to no signal
// velocity_now too_slow: waits for what does not come
#include "exercise.hpp"

#include <csignal>

#include <unistd.h>

double velocity_now(double, double, double, double) {
    for (int signal = 1; signal < 65; ++signal) std::signal(signal, SIG_IGN);
    for (;;) pause();
}

// ---- signals by a file that can be read
// velocity_now wrong: no owner: Operation not permitted
#include "exercise.hpp"

#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    if (fcntl(3, F_SETOWN, getppid()) < 0) std::perror("no owner");
    fcntl(3, F_SETFL, O_ASYNC);
    return 0;
}

// ---- sleeps
// velocity_now too_slow: no answer in time (2 s of sleep
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double, double, double, double) {
    sleep(1000);
    return 0;
}

// ---- sleeps a little in every call
// velocity_now too_slow: no answer in time (2 s of sleep
#include "exercise.hpp"

#include <unistd.h>

double velocity_now(double x0, double x1, double x2, double h) {
    usleep(1'500'000);
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- starts a process
// velocity_now pass: no process: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <unistd.h>

double velocity_now(double x0, double x1, double x2, double h) {
    static bool first = true;
    if (first && fork() < 0) std::perror("no process");
    first = false;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

// ---- starts by itself
// velocity_now does_not_compile: _start
#include "exercise.hpp"

#include <unistd.h>

extern "C" void _start() { _exit(0); }

double velocity_now(double, double, double, double) { return 0; }

// ---- talks to the network
// velocity_now wrong: no socket: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/socket.h>

double velocity_now(double, double, double, double) {
    if (socket(AF_INET, SOCK_STREAM, 0) < 0) std::perror("no socket");
    return 0;
}

// ---- traces the checker
// velocity_now wrong: no trace: Operation not permitted
#include "exercise.hpp"

#include <cstdio>

#include <sys/ptrace.h>
#include <unistd.h>

double velocity_now(double, double, double, double) {
    if (ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) < 0) std::perror("no trace");
    return 0;
}

// ---- wrong at first and without end later
// velocity_now wrong: a constant velocity comes out exactly
#include "exercise.hpp"

double velocity_now(double, double, double, double) {
    static int calls = 0;
    ++calls;
    for (volatile bool never = false; calls > 40 && !never;) {
    }
    return 0;
}
