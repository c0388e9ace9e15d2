#include "remote.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "become_worker.hpp"
#include "look.hpp"
#include "memcheck.hpp"
#include "pipe.hpp"

namespace checker {

namespace {

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

constexpr double turn = 0.1;  // s, between two looks at a worker that has not answered yet

std::string hexadecimal(const void* address) {
    char text[32];
    std::snprintf(text, sizeof text, "%p", address);
    return text;
}

[[noreturn]] void crash(const std::string& bytes) {
    LastWords words{};
    std::memcpy(&words, bytes.data(), std::min(bytes.size(), sizeof words));
    words.text[sizeof words.text - 1] = '\0';
    std::string trace;
    for (int i = 0; i < std::min(words.places, most_places); ++i)
        trace += (i > 0 ? " " : "") + hexadecimal(words.place[i]);
    throw NoAnswer(Kind::crash, words.text, trace);
}

}  // namespace

Remote::Remote(const std::string& program, const std::string& printed, const std::vector<std::string>& launcher,
               const Limits& limits)
    : limits_(limits),
      launched_(!launcher.empty()),
      most_bytes_(1 << 16),
      begin_(now()),
      call_begin_(begin_),
      next_look_(begin_ + turn) {
    std::signal(SIGPIPE, SIG_IGN);
    int calls[2], answers[2], failed[2];
    const int file = open(printed.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (file < 0) throw NoAnswer(Kind::course_error, printed + ": cannot be written");
    if (pipe2(calls, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0 || pipe2(failed, O_CLOEXEC) != 0)
        throw NoAnswer(Kind::course_error, "no pipe to be had from the system");
    int log[2] = {-1, -1};
    if (limits.watch == Watch::memcheck &&
        (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, log) != 0 || shutdown(log[1], SHUT_RD) != 0))
        throw NoAnswer(Kind::course_error, "no socket to be had from the system");
    log_ = log[0];
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // what a child leaves behind becomes ours: see end()
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) throw NoAnswer(Kind::course_error, "no process to be had from the system");
    if (process_ == 0) become_worker(program, launcher, parent, calls[0], answers[1], file, failed[1], log[1], limits);
    close(calls[0]);
    close(answers[1]);
    close(failed[1]);
    close(file);
    if (log[1] >= 0) close(log[1]);
    calls_ = calls[1];
    fcntl(calls_, F_SETFL, O_NONBLOCK);
    answers_ = answers[0];
    int error = 0;
    const bool runs = !read_all(failed[0], &error, sizeof error);
    close(failed[0]);
    if (!runs) throw NoAnswer(Kind::course_error, program + ": cannot be run: " + std::strerror(error));
}

Remote::~Remote() {
    end();
    if (calls_ >= 0) close(calls_);
    close(answers_);
    if (log_ >= 0) close(log_);
}

// No more calls: the worker returns from its main, global variables are destroyed, and the pipe of answers ends.
void Remote::await_end() {
    begin_call();
    close(std::exchange(calls_, -1));
    try {
        hear(Reply::ready);
    } catch (const NoAnswer& ended) {  // it has left, as it should; and who speaks out of turn now has answered all
        if (ended.kind == Kind::crash || ended.kind == Kind::too_slow) throw;
    }
}

void Remote::close_down() {
    end();
    overhear();
    look_through(found_);
}

// Reads what memcheck has written by now. The first that it finds is what is told; the rest is
// dropped.
void Remote::overhear() {
    char piece[4096];
    while (log_ >= 0) {
        const ssize_t got = recv(log_, piece, sizeof piece, MSG_DONTWAIT);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return;
        if (got == 0) close(std::exchange(log_, -1));
        if (got > 0 && found_.size() < (1 << 20)) found_.append(piece, static_cast<std::size_t>(got));
    }
}

// The whole group, and at once: what does not listen to anything else must end, too. So must what
// has left the group, or what a launcher has begun; the verdict comes when all of it is gone.
void Remote::end() {
    if (process_ < 0) return;
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    for (;;) {
        std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
        if (!children) return;
        for (pid_t child; children >> child;) kill(child, SIGKILL);
        if (waitpid(-1, nullptr, 0) < 0 && errno == ECHILD) return;
    }
}

void Remote::await() {
    begin_call();
    hear(Reply::ready);
    // The first call's number is not to be guessed, so that nothing said beforehand is an answer.
    std::random_device random;
    number_ = (static_cast<std::uint64_t>(random()) << 32) | random();
}

Numbers Remote::operator()(const Numbers& arguments) {
    const Head call{++number_, Reply::answer, static_cast<std::uint32_t>(arguments.size() * sizeof(double))};
    // For each argument some numbers: no test looks for long through an answer of that length.
    most_bytes_ = (10'000 + 4 * arguments.size()) * sizeof(double);
    begin_call();
    // Who does not listen has perhaps said why, and that comes first: `hear` knows.
    if (send(&call, sizeof call)) send(arguments.data(), call.bytes);
    const std::string bytes = hear(Reply::answer);
    Numbers result(bytes.size() / sizeof(double));
    std::memcpy(result.data(), bytes.data(), result.size() * sizeof(double));
    return result;
}

// Most calls take microseconds: then one look in many calls is enough to know what all have taken.
void Remote::begin_call() {
    call_begin_ = now();
    call_used_ = -1;
    asleep_ = 0;
    if (call_begin_ >= next_look_) look(false);
}

// The first look of a call tells what was used before it, and is at most a turn late.
void Remote::look(bool in_call) {
    const processes::Look seen = processes::look_at(process_, launched_);
    next_look_ = now() + turn;
    if (seen.known) {
        if (call_used_ < 0) call_used_ = seen.seconds;
        if (seen.seconds - call_used_ >= limits_.call_seconds || seen.seconds >= limits_.total_seconds)
            throw NoAnswer(Kind::too_slow, "");
    }
    if (next_look_ - call_begin_ > limits_.clock_seconds || next_look_ - begin_ > 4 * limits_.clock_seconds)
        throw NoAnswer(Kind::too_slow, too_slow_by_the_clock);
    // Before a call it sleeps, and after its answer.
    pollfd answered{answers_, POLLIN, 0};
    if (!in_call || !seen.asleep || poll(&answered, 1, 0) != 0) return;
    ++asleep_, ++all_asleep_;
    if (asleep_ * turn >= limits_.call_seconds || all_asleep_ * turn >= limits_.total_seconds)
        throw NoAnswer(Kind::too_slow, too_slow_asleep);
}

// Returns when the pipe is ready, or nobody holds its other end. Throws NoAnswer where that takes too
// much.
void Remote::wait_for(int pipe, short event) {
    for (;;) {
        pollfd waiting[] = {{pipe, event, 0}, {log_, POLLIN, 0}};
        if (poll(waiting, 2, static_cast<int>(turn * 1000)) > 0) {
            overhear();
            if (waiting[0].revents != 0) return;
        }
        if (now() >= next_look_) look(true);
    }
}

// False where nobody listens any more. A pipe holds 64 KB, and a call may be longer.
bool Remote::send(const void* from, std::size_t size) {
    for (const char* at = static_cast<const char*>(from); size > 0;) {
        wait_for(calls_, POLLOUT);
        const ssize_t put = write(calls_, at, size);
        if (put < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (put <= 0) return false;
        at += put;
        size -= static_cast<std::size_t>(put);
    }
    return true;
}

// What comes with the reply. Throws NoAnswer where it is not the one expected.
std::string Remote::hear(Reply expected) {
    Head head;
    receive(&head, sizeof head);
    // A thread may crash after an answer, when the next call is on its way: that is told of the call before.
    const bool of_before = head.reply == Reply::crashed && (head.number + 1 == number_ || head.number == 0);
    if ((head.number != number_ && !of_before) || head.reply > Reply::crashed)
        throw NoAnswer(Kind::left_early, "The program wrote to the pipe that its answers go through");
    if (head.bytes > most_bytes_)
        throw NoAnswer(Kind::left_early,
                       "The answer was too long, " + std::to_string(head.bytes / sizeof(double)) + " numbers");
    std::string bytes(head.bytes, '\0');
    receive(bytes.data(), bytes.size());
    if (head.reply == Reply::not_started) throw NoAnswer(Kind::not_started, "");
    if (head.reply == Reply::out_of_memory) throw NoAnswer(Kind::too_much_memory, "");
    if (head.reply == Reply::arguments_changed)
        throw NoAnswer(Kind::wrong, "the arguments are only read: after the call the caller's are as they were");
    if (head.reply == Reply::mode_changed)
        throw NoAnswer(Kind::wrong,
                       "the call leaves the processor as it found it: rounding to nearest, no tiny "
                       "number flushed to zero, full precision, no end of the program at 1/0, nothing "
                       "left on the x87's stack");
    if (head.reply == Reply::crashed) crash(bytes);
    if (head.reply != expected)
        throw NoAnswer(Kind::left_early, "The program wrote to the pipe that its answers go through");
    return bytes;
}

void Remote::receive(void* to, std::size_t size) {
    char* at = static_cast<char*>(to);
    while (size > 0) {
        wait_for(answers_, POLLIN);
        const ssize_t got = read(answers_, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) gone();
        at += got;
        size -= static_cast<std::size_t>(got);
    }
}

// The pipe has an end before the answer. The process stays there to be looked at until `end`. One
// that is about to end has little left to do, but perhaps no processor to do it; one that is not
// works or sleeps.
void Remote::gone() {
    siginfo_t how{};
    double used = -1, looked = now();
    const double deadline = now() + limits_.clock_seconds;
    for (int asleep = 0; asleep < 2 && now() < deadline; usleep(500)) {
        waitid(P_PID, static_cast<id_t>(process_), &how, WEXITED | WNOHANG | WNOWAIT);
        if (how.si_pid != 0) break;
        overhear();
        if (now() < looked + turn) continue;
        const processes::Look seen = processes::look_at(process_, launched_);
        looked = now();
        asleep += seen.asleep;
        if (used < 0) used = seen.seconds;
        if (seen.seconds - used > 2 * turn) break;
    }
    if (how.si_pid == 0) throw NoAnswer(Kind::left_early, "The program closed the pipe that its answers go through");
    if (how.si_code == CLD_EXITED && launched_ && how.si_status > 128) {  // as a launcher says it
        how.si_code = CLD_KILLED;
        how.si_status -= 128;
    }
    if (how.si_code == CLD_EXITED)
        throw NoAnswer(Kind::left_early,
                       "The program ended with status " + std::to_string(how.si_status) + " instead of returning");
    if (how.si_status == SIGXCPU) throw NoAnswer(Kind::too_slow, "");
    // Crashes are told before; so soon it is the system, which has no room for the variables.
    if (number_ == 0 && how.si_status == SIGSEGV) throw NoAnswer(Kind::too_much_memory, "");
    throw NoAnswer(Kind::crash, strsignal(how.si_status));
}

}  // namespace checker
