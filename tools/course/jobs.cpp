#include "jobs.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "process.hpp"

namespace course {

void in_parallel(const std::vector<std::size_t>& which, std::size_t most, const std::function<Grade(std::size_t)>& work,
                 const std::function<void(std::size_t, const Grade&)>& done) {
    const TidyEnd tidy_end;
    std::atomic<std::size_t> next = 0;
    std::mutex one_at_a_time;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < which.size(); i = next++) {
                stop_if_interrupted();
                const Grade grade = work(which[i]);
                const std::lock_guard lock(one_at_a_time);
                done(which[i], grade);
            }
        } catch (...) {
            const std::lock_guard lock(one_at_a_time);
            failure = std::current_exception();
            next = which.size();
        }
    };
    std::vector<std::thread> threads;
    while (threads.size() < std::min(most, which.size())) threads.emplace_back(run);
    for (std::thread& thread : threads) thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace course
