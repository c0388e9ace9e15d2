#pragma once
/// \file
/// Work shared by several threads.

#include <algorithm>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace timestep {

/// Calls `work(first, last)` for `threads` equal shares of 0 … `count`, each in a thread of its own
/// and the last in the caller's, and waits for all. Starting the threads takes as long as stepping
/// 1,500 to 8,000 boxes in lanes, depending on the machine, so it pays for larger shares. 0 threads
/// count as one, and there are never more than `count`. If the system gives no thread, the caller
/// does that share too. `work` must not throw.
template <class Work>
void parallel_for(std::size_t count, unsigned threads, const Work& work) {
    if (threads > count) threads = unsigned(count);  // no share is empty
    threads = std::max(threads, 1u);
    const auto share = [&](unsigned i) { work(count * i / threads, count * (i + 1) / threads); };
    std::vector<std::thread> others;
    others.reserve(threads - 1);  // so that nothing is thrown once a thread is under way
    for (unsigned i = 0; i + 1 < threads; ++i) {
#if defined(__cpp_exceptions)
        try {
            others.emplace_back(share, i);
        } catch (const std::exception&) {  // no thread to be had, or no memory for one
            share(i);
        }
#else
        others.emplace_back(share, i);  // ends the program where there is none
#endif
    }
    share(threads - 1);
    for (std::thread& other : others) other.join();
}

}  // namespace timestep
