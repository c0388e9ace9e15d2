// What a whole step costs a body that touches nothing, by each rule of an engine.

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

#include <timestep/rigid/shapes.hpp>

#include "scenes.hpp"

namespace engines {

namespace {

// All engines here have one thread.
template <class Work>
double processor_seconds_of(const Work& work) {
    const std::clock_t begin = std::clock();
    work();
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

void time_steps(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    constexpr int bodies = 512, together = 4;  // steps a turn
    const int turns = effort.quick ? 20 : 100;
    std::printf(
        "\n%d boxes that touch nothing: ns of processor time a body and step, in turns, the median of %d\n%-48s %8s "
        "%10s\n",
        bodies, turns, "", "ns", "of first");
    const Shape shape{Shape::box, {0.25, 0.5, 0.75}, timestep::box(1.0, 0.5, 1.0, 1.5).moments, 1};
    std::vector<std::unique_ptr<World>> worlds;
    for (const Engine& engine : engines) {
        worlds.push_back(engine.world({}));
        Chance chance(1);
        for (int n = 0; n < bodies; ++n) {
            State s;
            s.x = 4 * Vector(n % 8, n / 8 % 8, n / 64);
            // So slow that no rule takes their spin: what turns slowly costs an engine less by itself.
            s.q = chance.orientation(), s.omega = chance.direction();
            worlds.back()->add(shape, s);
        }
    }
    std::vector<std::vector<double>> taken(engines.size());
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t i = 0; i < engines.size(); ++i)
            taken[i].push_back(processor_seconds_of([&] {
                                   for (int n = 0; n < together; ++n) worlds[i]->step(step);
                               }) /
                               together);
    for (std::size_t i = 0; i < engines.size(); ++i) {
        std::size_t first = i;  // the engine's own first row
        while (first > 0 && engines[first - 1].name == engines[i].name) --first;
        std::vector<double> ratios;  // side by side, so that what slows the machine slows both
        for (int turn = 0; turn < turns; ++turn)
            ratios.push_back(taken[i][std::size_t(turn)] / taken[first][std::size_t(turn)]);
        const double ns = 1e9 * median(taken[i]) / bodies, ratio = median(ratios);
        std::printf("%s %8.1f %10.3f\n", row_name(engines[i]).c_str(), ns, ratio);
        numbers.add("cost", "512 boxes", engines[i], "ns", ns);
        numbers.add("cost", "512 boxes", engines[i], "of the first", ratio);
    }
}

}  // namespace engines
