#include "limited.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stop.hpp"

namespace course {

namespace {

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

[[noreturn]] void become(const std::vector<std::string>& command, int output,
                         const Allowance& allowance) {
    setpgid(0, 0);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    if (allowance.megabytes > 0) {
        const rlimit memory{allowance.megabytes << 20, allowance.megabytes << 20};
        setrlimit(RLIMIT_AS, &memory);
    }
    std::vector<char*> words;
    for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execvp(words[0], words.data());
    const std::string line = command[0] + ": " + std::strerror(errno) + "\n";
    if (write(STDERR_FILENO, line.data(), line.size()) < 0) _exit(126);
    _exit(127);
}

// Ctrl-C does not reach the other group: it is passed on.
volatile std::sig_atomic_t group = 0;
extern "C" void pass_on(int signal) {
    if (group != 0) kill(-group, SIGKILL);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

Outcome run_within(const std::vector<std::string>& command, const Allowance& allowance) {
    const std::size_t most = 1'000'000;
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw Stop(Status::missing, "no pipe to be had from the system");
    const pid_t child = fork();
    if (child < 0) throw Stop(Status::missing, "no process to be had from the system");
    if (child == 0) become(command, ends[1], allowance);
    setpgid(child, child);
    group = child;
    const auto interrupt = std::signal(SIGINT, pass_on);
    const auto terminate = std::signal(SIGTERM, pass_on);
    close(ends[1]);

    Outcome outcome;
    const double deadline = now() + allowance.seconds;
    char piece[4096];
    for (;;) {
        const double left = deadline - now();
        pollfd waiting{ends[0], POLLIN, 0};
        const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left * 1000) + 1) : 0;
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) {
            outcome.too_slow = true;
            break;
        }
        const ssize_t size = read(ends[0], piece, sizeof piece);
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) break;
        if (outcome.said.size() < most) outcome.said.append(piece, static_cast<std::size_t>(size));
    }
    close(ends[0]);
    if (outcome.too_slow) kill(-child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    kill(-child, SIGKILL);  // what it may have left behind
    group = 0;
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, terminate);
    outcome.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return outcome;
}

}  // namespace course
