#pragma once
/// \file
/// Work for several threads.

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace timestep {

/// Calls `work(first, last)` for `threads` equal shares of 0 … `count`, each in a thread of its
/// own, the last one in the caller's, and waits for all. To start a thread takes as long as to step
/// some thousands of bodies: it pays where a share is larger than that. No thread, as a system may
/// say that does not know how many it has, is one. `work` must not throw.
template <class Work>
void share_out(std::size_t count, unsigned threads, const Work& work) {
    threads = std::max(threads, 1u);
    const auto share = [&](unsigned i) { work(count * i / threads, count * (i + 1) / threads); };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(share, i - 1);
    share(threads - 1);
    for (std::thread& other : others) other.join();
}

}  // namespace timestep
