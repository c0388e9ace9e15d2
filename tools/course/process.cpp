#include "process.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace {

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

// A running program, and the socket for its output.
struct Running {
    pid_t process;
    int output;
};

// Returns only if it fails.
void become(const std::vector<std::string>& command) {
    std::vector<char*> words;
    for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execvp(words[0], words.data());
}

// `prepare` is done in the new process.
Running start(const std::vector<std::string>& command, const std::function<void()>& prepare) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw Stop(Status::missing, "no socket to be had from the system");
    const pid_t child = fork();
    if (child < 0) throw Stop(Status::missing, "no process to be had from the system");
    if (child > 0) {
        close(ends[1]);
        return {child, ends[0]};
    }
    prepare();
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    become(command);
    const std::string line = command[0] + ": " + std::strerror(errno) + "\n";
    if (write(STDERR_FILENO, line.data(), line.size()) < 0) _exit(126);
    _exit(127);
}

// Reads the next output within `seconds`: returns its size, 0 at the end, -1 if there was none yet.
ssize_t hear(int from, char* piece, std::size_t size, double seconds) {
    pollfd waiting{from, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(seconds * 1000) + 1) <= 0) return -1;
    const ssize_t got = read(from, piece, size);
    return got < 0 && errno != EINTR ? 0 : got;
}

int wait_for(pid_t process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

// Waits for `seconds`; false if the process has not ended by then.
bool has_ended(pid_t process, int& status, double seconds) {
    for (const double end = now() + seconds; waitpid(process, &status, WNOHANG) == 0; usleep(1000))
        if (now() > end) return false;
    return true;
}

// Ctrl-C reaches the whole group. While a child runs, the child dies of it and we tidy up, as `system` does.
class LeaveInterruptToChild {
public:
    LeaveInterruptToChild() : before_(std::signal(SIGINT, SIG_IGN)) {}
    ~LeaveInterruptToChild() { std::signal(SIGINT, before_); }
    LeaveInterruptToChild(const LeaveInterruptToChild&) = delete;
    LeaveInterruptToChild& operator=(const LeaveInterruptToChild&) = delete;

private:
    void (*before_)(int);
};

// Called in the new process. C.UTF-8: we read its English words, and the plain C locale spells ω as \U000003c9.
void confine(const Allowance& allowance) {
    const auto limit = [](auto resource, std::size_t most) {
        const rlimit both{most, most};
        if (most > 0) setrlimit(resource, &both);
    };
    // The first limit ends it by a signal whose name says why; the second kills it.
    const auto seconds = static_cast<rlim_t>(allowance.processor_seconds);
    const rlimit first{seconds, seconds + 1};
    if (seconds > 0) setrlimit(RLIMIT_CPU, &first);
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // it ends with us; the processes that it has started have their limits
    const int terminal = open("/dev/tty", O_RDWR | O_CLOEXEC);
    if (terminal >= 0) ioctl(terminal, TIOCNOTTY);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    limit(RLIMIT_AS, allowance.megabytes << 20);
    limit(RLIMIT_FSIZE, allowance.file_megabytes << 20);
    // The limit counts the user's processes, which are no more than the machine's.
    struct sysinfo machine {};
    if (allowance.processes > 0 && sysinfo(&machine) == 0) limit(RLIMIT_NPROC, machine.procs + allowance.processes);
    setenv("LC_ALL", "C.UTF-8", 1);
    unsetenv("LANGUAGE");
    if (!allowance.temporary.empty()) setenv("TMPDIR", allowance.temporary.c_str(), 1);
}

const std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t caught = 0;
std::atomic<bool> is_told = false;  // somebody has thrown for it

extern "C" void remember_signal(int signal) { caught = signal; }

}  // namespace

void hand_over(const std::vector<std::string>& command) {
    std::fflush(stdout);
    become(command);
    throw Stop(Status::missing, command[0] + ": " + std::strerror(errno));
}

int listen(const std::vector<std::string>& command, const std::function<void(std::string_view)>& heard,
           const std::function<void()>& silence) {
    const LeaveInterruptToChild guard;
    const Running running = start(command, [] { std::signal(SIGINT, SIG_DFL); });
    char piece[4096];
    while (const ssize_t size = hear(running.output, piece, sizeof piece, 1)) {
        if (size > 0)
            heard({piece, static_cast<std::size_t>(size)});
        else
            silence();
    }
    close(running.output);

    const int status = wait_for(running.process);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) throw Stop(Status::interrupted, "interrupted");
    if (WIFSIGNALED(status))
        throw Stop(Status::wrong, command[0] + " was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
                                      strsignal(WTERMSIG(status)) + ")");
    return WEXITSTATUS(status);
}

Outcome run_within(const std::vector<std::string>& command, const Allowance& allowance, const std::string& input) {
    const std::size_t most = 1'000'000;
    const double turn = 0.1;  // s, between two looks at the clock
    int read_end = -1;
    if (!input.empty()) {  // a pipe has room for it
        int ends[2];
        const auto size = static_cast<ssize_t>(input.size());
        if (pipe2(ends, O_CLOEXEC) != 0 || write(ends[1], input.data(), input.size()) != size)
            throw Stop(Status::missing, "no pipe to be had from the system");
        close(ends[1]);
        read_end = ends[0];
    }
    const Running running = start(command, [&] {
        confine(allowance);
        if (read_end >= 0) dup2(read_end, STDIN_FILENO);
    });
    if (read_end >= 0) close(read_end);
    const pid_t group = running.process;
    setpgid(group, group);
    const double deadline = now() + allowance.seconds;

    Outcome outcome;
    std::string end;
    char piece[4096];
    int status = 0;
    bool listening = true, ended = false;
    Wait wait(allowance.waiting_for);
    while (!ended && !interrupted() && now() < deadline) {
        wait.look();
        if (listening) {
            const ssize_t size = hear(running.output, piece, sizeof piece, turn);
            listening = size != 0;
            if (size <= 0) continue;
            // Of long output keep the beginning, and the end, where a compiler says why it stopped.
            std::string& part = outcome.said.size() < most ? outcome.said : end;
            part.append(piece, static_cast<std::size_t>(size));
            if (end.size() > 2 * sizeof piece) end.erase(0, end.size() - sizeof piece);
        } else {
            ended = has_ended(group, status, turn);
        }
    }
    close(running.output);
    outcome.said += end;
    outcome.too_slow = !ended;
    // First it may end by itself: a compiler removes its unfinished files, the checker ends the learner's code, which
    // has its own group.
    if (!ended) {
        kill(-group, SIGTERM);
        ended = has_ended(group, status, 1);
    }
    kill(-group, SIGKILL);  // and any process that it left behind
    if (!ended) status = wait_for(group);
    stop_if_interrupted();
    outcome.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return outcome;
}

void Lines::operator()(std::string_view piece) {
    rest_ += piece;
    for (auto end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
        line_(rest_.substr(0, end));
        rest_.erase(0, end + 1);
    }
}

TidyEnd::TidyEnd() {
    struct sigaction remember {};
    remember.sa_handler = remember_signal;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        // An ignored signal stays ignored, as under nohup.
        if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &remember, nullptr);
    }
}

TidyEnd::~TidyEnd() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
    if (caught != 0 && !is_told) std::raise(caught);
}

bool interrupted() { return caught != 0; }

void stop_if_interrupted() {
    if (!interrupted()) return;
    is_told = true;
    throw Stop(Status::interrupted, "interrupted");
}

}  // namespace course
