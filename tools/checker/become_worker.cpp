#include "become_worker.hpp"

#include <cerrno>
#include <csignal>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include "alone.hpp"
#include "pipe.hpp"

namespace checker {

namespace {

void limit(int resource, std::size_t amount, std::size_t hard) {
    const rlimit both{amount, hard};
    setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

void limit(int resource, std::size_t amount) { limit(resource, amount, amount); }

// The rules, where a launcher reads them.
constexpr int rules_fd = answers_fd + 2;

void open_rules() {
    const std::vector<sock_filter> list = rules();
    const int file = memfd_create("rules", 0);
    write_all(file, list.data(), list.size() * sizeof list[0]);
    lseek(file, 0, SEEK_SET);
    dup2(file, rules_fd);
    if (file != rules_fd) close(file);
}

}  // namespace

void become_worker(const std::string& program, const std::vector<std::string>& launcher, pid_t parent, int calls,
                   int answers, int printed, int failed, int found, const Limits& limits) {
    setsid();  // a group of its own, and no terminal to type into
    // It ends with its parent, which may have ended before this line.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    // First out of the way of the places they are to have.
    calls = fcntl(calls, F_DUPFD, 10);
    answers = fcntl(answers, F_DUPFD, 10);
    printed = fcntl(printed, F_DUPFD, 10);
    failed = fcntl(failed, F_DUPFD, 10);
    found = fcntl(found, F_DUPFD, 10);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(printed, STDOUT_FILENO);
    dup2(printed, STDERR_FILENO);
    dup2(calls, calls_fd);
    dup2(answers, answers_fd);
    failed = dup3(failed, answers_fd + 1, O_CLOEXEC);
    const bool memcheck = limits.watch == Watch::memcheck;
    const int first_closed = memcheck ? dup2(found, failed + 1) + 1 : failed + 1;
    close_range(static_cast<unsigned>(first_closed), ~0u, 0);
    for (const int signal : {SIGINT, SIGPIPE, SIGTERM}) std::signal(signal, SIG_DFL);
    std::signal(SIGXFSZ, SIG_IGN);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, limits.printed_bytes);
    if (limits.watch == Watch::nobody) limit(RLIMIT_AS, limits.megabytes << 20);
    const auto seconds = static_cast<std::size_t>(limits.total_seconds) + 1;
    limit(RLIMIT_CPU, seconds, seconds + 1);  // first a signal that says why, then the end
    if (!memcheck) limit(RLIMIT_NOFILE, 64);
    limit(RLIMIT_MSGQUEUE, 0);
    limit(RLIMIT_MEMLOCK, 0);
    // Of a huge page all stays taken when all but 4 kB are given back, and only those 4 kB count.
    prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
    // It counts all that the user runs, which is less than all that the machine runs.
    struct sysinfo machine {};
    if (sysinfo(&machine) == 0) limit(RLIMIT_NPROC, machine.procs + limits.threads);
    // Memory is handed out and taken back full of bytes that make no sense, so that what was never
    // written is no lucky zero.
    const std::string tunables = "glibc.malloc.perturb=1:glibc.malloc.tcache_count=0";
    // Sanitizers need more room than a limit on addresses leaves, and count memory themselves.
    const std::string most = std::to_string(limits.megabytes);
    std::vector<std::string> words = launcher, surroundings{
                                                   "ASAN_OPTIONS=detect_leaks=0:handle_segv=0:handle_sigbus=0:"
                                                   "handle_sigfpe=0:handle_sigill=0:handle_abort=0:"
                                                   "allocator_may_return_null=0:max_allocation_size_mb=" +
                                                   most + ":soft_rss_limit_mb=" + most};
    if (memcheck) {
        words = {"valgrind", "-q", "--vgdb=no", "--log-fd=" + std::to_string(failed + 1), "--track-origins=yes",
                 program};
        stay_alone(Files::are_written_too);
    } else if (launcher.empty()) {
        stay_alone(Files::are_read);
        // Some sanitizers do not find their places where these are drawn by lot.
        if (limits.watch == Watch::sanitizers) personality(ADDR_NO_RANDOMIZE);
        words.push_back("worker");
        surroundings.push_back("GLIBC_TUNABLES=" + tunables);
    } else {  // which keeps the rules for the worker
        open_rules();
        words.insert(words.end(),
                     {"--setenv", "GLIBC_TUNABLES", tunables, "--seccomp", std::to_string(rules_fd), "--", program});
    }
    const auto pointers = [](std::vector<std::string>& list) {
        std::vector<char*> to;
        for (std::string& word : list) to.push_back(word.data());
        to.push_back(nullptr);
        return to;
    };
    execvpe(memcheck || !launcher.empty() ? words[0].c_str() : program.c_str(), pointers(words).data(),
            pointers(surroundings).data());
    const int error = errno;
    write_all(failed, &error, sizeof error);
    _exit(127);
}

}  // namespace checker
