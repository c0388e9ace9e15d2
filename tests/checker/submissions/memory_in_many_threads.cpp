// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

#include <thread>

double velocity_now(double, double, double, double) {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([] {
            std::vector<std::vector<double>> history;
            for (std::size_t size = 1'000'000;; size *= 4) history.emplace_back(size);
        });
    for (auto& thread : threads) thread.join();
    return 0;
}
