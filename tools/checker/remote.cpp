#include "remote.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <random>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pipe.hpp"

namespace checker {

namespace {

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

void limit(int resource, std::size_t amount) {
    const rlimit both{amount, amount};
    setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

// In the child: the pipes and the file in place of all that was open, limits, and the program with
// an empty environment.
[[noreturn]] void become(const std::string& program, int calls, int answers, int printed,
                         const Limits& limits) {
    setpgid(0, 0);
    // First out of the way of the places they are to have.
    calls = fcntl(calls, F_DUPFD, 10);
    answers = fcntl(answers, F_DUPFD, 10);
    printed = fcntl(printed, F_DUPFD, 10);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(printed, STDOUT_FILENO);
    dup2(printed, STDERR_FILENO);
    dup2(calls, calls_fd);
    dup2(answers, answers_fd);
    for (int fd = answers_fd + 1; fd < 64; ++fd) close(fd);
    for (const int signal : {SIGINT, SIGPIPE, SIGTERM}) std::signal(signal, SIG_DFL);
    std::signal(SIGXFSZ, SIG_IGN);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, limits.printed_bytes);
    limit(RLIMIT_AS, limits.megabytes << 20);
    limit(RLIMIT_CPU, static_cast<std::size_t>(limits.total_seconds) + 1);
    char name[] = "worker";
    char* arguments[] = {name, nullptr};
    char* environment[] = {nullptr};
    execve(program.c_str(), arguments, environment);
    _exit(127);
}

std::string hexadecimal(const void* address) {
    char text[32];
    std::snprintf(text, sizeof text, "%p", address);
    return text;
}

}  // namespace

Remote::Remote(const std::string& program, const std::string& printed, const Limits& limits)
    : limits_(limits), program_(program), begin_(now()) {
    // The first call's number is not to be guessed, so that nothing said beforehand is an answer.
    std::random_device random;
    number_ = (static_cast<std::uint64_t>(random()) << 32) | random();
    std::signal(SIGPIPE, SIG_IGN);
    int calls[2], answers[2];
    const int file = open(printed.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0) throw Ended(Kind::course_error, printed + ": cannot be written");
    if (pipe2(calls, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0)
        throw Ended(Kind::course_error, "no pipe to be had from the system");
    process_ = fork();
    if (process_ < 0) throw Ended(Kind::course_error, "no process to be had from the system");
    if (process_ == 0) become(program, calls[0], answers[1], file, limits);
    setpgid(process_, process_);
    close(calls[0]);
    close(answers[1]);
    close(file);
    calls_ = calls[1];
    answers_ = answers[0];
}

Remote::~Remote() {
    end();
    close(calls_);
    close(answers_);
}

// The whole group, and at once: what does not listen to anything else must end, too.
void Remote::end() {
    if (process_ < 0) return;
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
}

Numbers Remote::operator()(const Numbers& arguments) {
    const Head call{++number_, Reply::answer,
                    static_cast<std::uint32_t>(arguments.size() * sizeof(double))};
    const double deadline = std::min(now() + limits_.call_seconds, begin_ + limits_.total_seconds);
    if (!write_all(calls_, &call, sizeof call) || !write_all(calls_, arguments.data(), call.bytes))
        gone();
    Head head;
    receive(&head, sizeof head, deadline);
    if (head.number != number_ || head.reply > Reply::crashed || head.bytes > (64u << 20))
        throw Ended(Kind::left_early, "it wrote to the pipe that its answers go through");
    std::string bytes(head.bytes, '\0');
    receive(bytes.data(), bytes.size(), deadline);

    switch (head.reply) {
        case Reply::answer: {
            Numbers result(bytes.size() / sizeof(double));
            std::memcpy(result.data(), bytes.data(), result.size() * sizeof(double));
            return result;
        }
        case Reply::not_started:
            throw Ended(Kind::not_started, "");
        case Reply::threw:
            throw Ended(Kind::crash, "an exception that nobody caught: " + bytes);
        case Reply::out_of_memory:
            throw Ended(Kind::too_much_memory, "");
        case Reply::crashed:
            break;
    }
    // The addresses on the stack, from the inside out; the signal's name comes with the end.
    std::string trace;
    for (std::size_t i = 0; i + sizeof(void*) <= bytes.size(); i += sizeof(void*)) {
        void* address = nullptr;
        std::memcpy(&address, bytes.data() + i, sizeof address);
        trace += ' ';
        trace += hexadecimal(address);
    }
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    throw Ended(Kind::crash,
                std::string(WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "a signal") +
                    " at" + trace);
}

void Remote::receive(void* to, std::size_t size, double deadline) {
    char* at = static_cast<char*>(to);
    while (size > 0) {
        const double left = deadline - now();
        pollfd waiting{answers_, POLLIN, 0};
        const int ready = left > 0 ? poll(&waiting, 1, static_cast<int>(left * 1000) + 1) : 0;
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) throw Ended(Kind::too_slow, "");
        const ssize_t got = read(answers_, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) gone();
        at += got;
        size -= static_cast<std::size_t>(got);
    }
}

// The pipe has an end before the answer.
void Remote::gone() {
    int status = 0;
    kill(-process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        throw Ended(Kind::course_error, program_ + ": cannot be run");
    if (WIFEXITED(status))
        throw Ended(Kind::left_early,
                    "it ended with status " + std::to_string(WEXITSTATUS(status)));
    if (WTERMSIG(status) == SIGXCPU) throw Ended(Kind::too_slow, "");
    throw Ended(Kind::crash, strsignal(WTERMSIG(status)));
}

}  // namespace checker
