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
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pipe.hpp"

namespace checker {

namespace {

double now() {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

constexpr int turn = 100;  // ms, between two looks at a worker that has not answered yet

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

void limit(__rlimit_resource resource, std::size_t amount, std::size_t hard) {
    const rlimit both{amount, hard};
    setrlimit(resource, &both);
}

// In the child: the pipes and the file in place of all that was open, limits, and the program with an environment of
// its own. What keeps it from running is written to `failed`.
[[noreturn]] void become_worker(const std::string& program, const std::vector<std::string>& launcher, pid_t parent,
                                int calls, int answers, int printed, int failed, const Limits& limits) {
    setsid();  // a group of its own, and no terminal to type into
    // It ends with its parent, which may have ended before this line.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    // First out of the way of the places they are to have.
    for (int* const file : {&calls, &answers, &printed, &failed}) *file = fcntl(*file, F_DUPFD, 10);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(printed, STDOUT_FILENO);
    dup2(printed, STDERR_FILENO);
    dup2(calls, calls_fd);
    dup2(answers, answers_fd);
    failed = dup3(failed, answers_fd + 1, O_CLOEXEC);
    close_range(static_cast<unsigned>(failed) + 1, ~0u, 0);
    for (const int signal : {SIGINT, SIGPIPE, SIGTERM}) std::signal(signal, SIG_DFL);
    std::signal(SIGXFSZ, SIG_IGN);
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_FSIZE, limits.printed_bytes, limits.printed_bytes);
    if (!limits.sanitizers) limit(RLIMIT_AS, limits.megabytes << 20, limits.megabytes << 20);
    limit(RLIMIT_CPU, limits.total_seconds, limits.total_seconds + 1);  // first a signal that says why, then the end
    // It counts all that the user runs, which is less than all that the machine runs.
    struct sysinfo machine {};
    const std::size_t threads = sysinfo(&machine) == 0 ? machine.procs + limits.threads : limits.threads;
    limit(RLIMIT_NPROC, threads, threads);
    // Memory is handed out and taken back full of bytes that make no sense, so that what was never written is no lucky
    // zero.
    const std::string tunables = "glibc.malloc.perturb=1:glibc.malloc.tcache_count=0";
    // A sanitizer prints its report and aborts: the worker then tells the line.
    const std::string most = std::to_string(limits.megabytes), reports = "abort_on_error=1:print_legend=0:";
    std::vector<std::string> words = launcher,
                             surroundings{
                                 "UBSAN_OPTIONS=" + reports,
                                 "ASAN_OPTIONS=" + reports +
                                     "detect_leaks=0:handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0:"
                                     "handle_abort=0:allocator_may_return_null=0:max_allocation_size_mb=" +
                                     most + ":soft_rss_limit_mb=" + most};
    if (launcher.empty()) {
        // Some sanitizers do not find their places where these are drawn by lot.
        if (limits.sanitizers) personality(ADDR_NO_RANDOMIZE);
        words.push_back("worker");
        surroundings.push_back("GLIBC_TUNABLES=" + tunables);
    } else {
        words.insert(words.end(), {"--setenv", "GLIBC_TUNABLES", tunables, "--", program});
    }
    const auto pointers = [](std::vector<std::string>& list) {
        std::vector<char*> to;
        for (std::string& word : list) to.push_back(word.data());
        to.push_back(nullptr);
        return to;
    };
    execvpe(launcher.empty() ? program.c_str() : words[0].c_str(), pointers(words).data(),
            pointers(surroundings).data());
    const int error = errno;
    write_all(failed, &error, sizeof error);
    _exit(127);
}

}  // namespace

Remote::Remote(const std::string& program, const std::string& printed, const std::vector<std::string>& launcher,
               const Limits& limits)
    : limits_(limits), launched_(!launcher.empty()), most_bytes_(1 << 16), begin_(now()), call_begin_(begin_) {
    std::signal(SIGPIPE, SIG_IGN);
    int calls[2], answers[2], failed[2];
    const int file = open(printed.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (file < 0) throw NoAnswer(Kind::course_error, printed + ": cannot be written");
    if (pipe2(calls, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0 || pipe2(failed, O_CLOEXEC) != 0)
        throw NoAnswer(Kind::course_error, "no pipe to be had from the system");
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // what a child leaves behind becomes ours: see end()
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) throw NoAnswer(Kind::course_error, "no process to be had from the system");
    if (process_ == 0) become_worker(program, launcher, parent, calls[0], answers[1], file, failed[1], limits);
    close(calls[0]);
    close(answers[1]);
    close(failed[1]);
    close(file);
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
}

// No more calls: the worker returns from its main, global variables are destroyed, and the pipe of answers ends.
void Remote::await_end() {
    call_begin_ = now();
    close(std::exchange(calls_, -1));
    try {
        hear(Reply::ready);
    } catch (const NoAnswer& ended) {  // it has left, as it should; and who speaks out of turn now has answered all
        if (ended.kind == Kind::crash || ended.kind == Kind::too_slow) throw;
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
    call_begin_ = now();
    hear(Reply::ready);
    // The first call's number is not to be guessed, so that nothing said beforehand is an answer.
    std::random_device random;
    number_ = (static_cast<std::uint64_t>(random()) << 32) | random();
}

Numbers Remote::operator()(const Numbers& arguments) {
    const Head call{++number_, Reply::answer, static_cast<std::uint32_t>(arguments.size() * sizeof(double))};
    // For each argument some numbers: no test looks for long through an answer of that length.
    most_bytes_ = (10'000 + 4 * arguments.size()) * sizeof(double);
    call_begin_ = now();
    // Who does not listen has perhaps said why, and that comes first: `hear` knows.
    if (send(&call, sizeof call)) send(arguments.data(), call.bytes);
    const std::string bytes = hear(Reply::answer);
    Numbers result(bytes.size() / sizeof(double));
    std::memcpy(result.data(), bytes.data(), result.size() * sizeof(double));
    return result;
}

// Returns when the pipe is ready, or nobody holds its other end. Throws NoAnswer where that takes too
// much.
void Remote::wait_for(int pipe, short event) {
    for (;;) {
        pollfd waiting{pipe, event, 0};
        if (poll(&waiting, 1, turn) > 0) return;
        // A process that it has left behind may hold the pipe open.
        siginfo_t how{};
        waitid(P_PID, static_cast<id_t>(process_), &how, WEXITED | WNOHANG | WNOWAIT);
        if (how.si_pid != 0 && poll(&waiting, 1, 0) == 0) gone();
        if (now() - call_begin_ > limits_.clock_seconds || now() - begin_ > 4 * limits_.clock_seconds)
            throw NoAnswer(Kind::too_slow, too_slow_by_the_clock);
    }
}

// False where nobody listens any more. A pipe holds 64 KB, and a call may be longer.
bool Remote::send(const void* from, std::size_t size) {
    return write_all(calls_, from, size, [this] { wait_for(calls_, POLLOUT); });
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
    if (head.reply == Reply::crashed) crash(bytes);
    if (head.reply != expected)
        throw NoAnswer(Kind::left_early, "The program wrote to the pipe that its answers go through");
    return bytes;
}

void Remote::receive(void* to, std::size_t size) {
    if (!read_all(answers_, to, size, [this] { wait_for(answers_, POLLIN); })) gone();
}

// The pipe has an end before the answer. The process stays there to be looked at until `end`. One that is about to end
// has little left to do, but perhaps no processor to do it.
void Remote::gone() {
    siginfo_t how{};
    for (const double deadline = now() + limits_.clock_seconds; how.si_pid == 0 && now() < deadline; usleep(500))
        waitid(P_PID, static_cast<id_t>(process_), &how, WEXITED | WNOHANG | WNOWAIT);
    if (how.si_pid == 0) throw NoAnswer(Kind::left_early, "The program closed the pipe that its answers go through");
    if (how.si_code == CLD_EXITED && launched_ && how.si_status > 128) {  // as a launcher says it
        how.si_code = CLD_KILLED;
        how.si_status -= 128;
    }
    if (how.si_code == CLD_EXITED)
        throw NoAnswer(Kind::left_early,
                       "The program ended with status " + std::to_string(how.si_status) + " instead of returning");
    if (how.si_status == SIGXCPU || how.si_status == SIGPROF) throw NoAnswer(Kind::too_slow, "");
    throw NoAnswer(Kind::crash, strsignal(how.si_status));
}

}  // namespace checker
