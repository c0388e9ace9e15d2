#include "jobs.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "process.hpp"
#include "stop.hpp"

namespace course {

namespace {

using nlohmann::json;

struct Job {
    std::size_t which;
    pid_t process;
    int pipe;
    std::string said;
};

// MessagePack, since the strings may hold bytes that JSON does not allow.
std::string packed(const Grade& grade) {
    const json value{grade.submission, grade.exercise, grade.verdict, grade.says,
                     grade.seed,       grade.seconds,  grade.in_time};
    const auto bytes = json::to_msgpack(value);
    return {bytes.begin(), bytes.end()};
}

Grade unpacked(const std::string& bytes) {
    const json value = json::from_msgpack(bytes, true, false);
    if (!value.is_array() || value.size() != 7)
        return {"", "", "course_error", "the check ended without a verdict", 0, 0, true};
    return {value[0], value[1], value[2], value[3], value[4], value[5], value[6]};
}

// Ends with its parent.
[[noreturn]] void work_in_child(pid_t parent, int pipe, const std::function<Grade()>& work) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(1);
    int status = 1;
    try {
        const std::string bytes = packed(work());
        const auto size = static_cast<ssize_t>(bytes.size());
        status = write(pipe, bytes.data(), bytes.size()) == size ? 0 : 1;
    } catch (...) {
    }
    _exit(status);
}

class Jobs {
public:
    ~Jobs() {
        for (const Job& job : running_) kill(job.process, SIGTERM);
        for (const Job& job : running_) end(job);
    }
    std::size_t size() const { return running_.size(); }

    void start(std::size_t which, const std::function<Grade(std::size_t)>& work) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) throw Stop(Status::missing, "no pipe to be had from the system");
        std::fflush(stdout);
        const pid_t parent = getpid();
        const pid_t child = fork();
        if (child < 0) throw Stop(Status::missing, "no process to be had from the system");
        if (child == 0) work_in_child(parent, ends[1], [&] { return work(which); });
        close(ends[1]);
        running_.push_back({which, child, ends[0], {}});
    }

    // Waits briefly for output; passes on the grades of processes that have ended.
    void listen(const std::function<void(std::size_t, const Grade&)>& done) {
        std::vector<pollfd> pipes;
        for (const Job& job : running_) pipes.push_back({job.pipe, POLLIN, 0});
        if (poll(pipes.data(), pipes.size(), 100) <= 0) return;
        for (std::size_t i = pipes.size(); i-- > 0;) {
            if (pipes[i].revents == 0) continue;
            Job& job = running_[i];
            char piece[4096];
            const ssize_t got = read(job.pipe, piece, sizeof piece);
            if (got < 0 && errno == EINTR) continue;
            if (got > 0) {
                job.said.append(piece, static_cast<std::size_t>(got));
                continue;
            }
            const Job over = job;
            running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
            end(over);
            done(over.which, unpacked(over.said));
        }
    }

private:
    static void end(const Job& job) {
        close(job.pipe);
        while (waitpid(job.process, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    std::vector<Job> running_;
};

}  // namespace

void in_parallel(const std::vector<std::size_t>& which, int most, const std::function<Grade(std::size_t)>& work,
                 const std::function<void(std::size_t, const Grade&)>& done) {
    const TidyEnd tidy_end;
    Jobs jobs;
    for (std::size_t next = 0; next < which.size() || jobs.size() > 0;) {
        stop_if_interrupted();
        if (next < which.size() && jobs.size() < static_cast<std::size_t>(most))
            jobs.start(which[next++], work);
        else
            jobs.listen(done);
    }
    stop_if_interrupted();
}

}  // namespace course
