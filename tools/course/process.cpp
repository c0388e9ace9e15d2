#include "process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "stop.hpp"

namespace course {

namespace {

// Ctrl-C reaches the whole group. While a child runs it is the child's to die of, and ours to tidy
// up after: what `system` does, too.
class LeaveInterruptToChild {
public:
    LeaveInterruptToChild() : before_(std::signal(SIGINT, SIG_IGN)) {}
    ~LeaveInterruptToChild() { std::signal(SIGINT, before_); }
    LeaveInterruptToChild(const LeaveInterruptToChild&) = delete;
    LeaveInterruptToChild& operator=(const LeaveInterruptToChild&) = delete;

private:
    void (*before_)(int);
};

[[noreturn]] void become(const std::vector<std::string>& command, int output) {
    std::signal(SIGINT, SIG_DFL);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    std::vector<char*> words;
    for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execvp(words[0], words.data());
    const std::string line = command[0] + ": " + std::strerror(errno) + "\n";
    if (write(STDERR_FILENO, line.data(), line.size()) < 0) _exit(126);
    _exit(127);
}

}  // namespace

int listen(const std::vector<std::string>& command,
           const std::function<void(std::string_view)>& heard,
           const std::function<void()>& silence) {
    const LeaveInterruptToChild guard;
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) throw Stop(Status::missing, "no pipe to be had from the system");
    const pid_t child = fork();
    if (child < 0) throw Stop(Status::missing, "no process to be had from the system");
    if (child == 0) {
        close(pipe_ends[0]);
        become(command, pipe_ends[1]);
    }
    close(pipe_ends[1]);

    char piece[4096];
    for (;;) {
        pollfd waiting{pipe_ends[0], POLLIN, 0};
        if (poll(&waiting, 1, 1000) == 0) {
            silence();
            continue;
        }
        const ssize_t size = read(pipe_ends[0], piece, sizeof piece);
        if (size > 0)
            heard({piece, static_cast<std::size_t>(size)});
        else if (size == 0 || errno != EINTR)
            break;
    }
    close(pipe_ends[0]);

    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT)
        throw Stop(Status::interrupted, "interrupted");
    if (WIFSIGNALED(status))
        throw Stop(Status::wrong, command[0] + " was ended by signal " +
                                      std::to_string(WTERMSIG(status)) + " (" +
                                      strsignal(WTERMSIG(status)) + ")");
    return WEXITSTATUS(status);
}

void Lines::operator()(std::string_view piece) {
    rest_ += piece;
    for (auto end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
        line_(rest_.substr(0, end));
        rest_.erase(0, end + 1);
    }
}

}  // namespace course
