// course bench latency

#include <algorithm>
#include <cstdio>

#include "build.hpp"
#include "commands.hpp"
#include "stop.hpp"
#include "terminal.hpp"
#include "verdict.hpp"

namespace course {

// The course's own answers are checked, round by round, so that a busy moment touches every
// exercise.
void bench_latency(int rounds) {
    ProgressLine progress;
    build({"exercises"}, progress);
    const auto exercises = read_exercises();
    std::vector<std::vector<double>> seconds(exercises.size());
    for (int round = 0; round < rounds; ++round) {
        progress.now("round " + std::to_string(round + 1) + " of " + std::to_string(rounds));
        for (std::size_t i = 0; i < exercises.size(); ++i) {
            const Verdict verdict = check_file(exercises[i], exercises[i].solution(),
                                               static_cast<std::uint64_t>(round));
            if (verdict.kind != "pass")
                throw Stop(Status::wrong,
                           exercises[i].name + ": the solution does not pass: " + verdict.kind);
            seconds[i].push_back(verdict.seconds);
        }
    }
    progress.clear();
    std::printf(
        "From a saved file to its verdict, in seconds; %d checks each\n\n%s  median    best   "
        "worst\n",
        rounds, padded("exercise", 34).c_str());
    std::vector<double> plain, eigen;
    const auto print = [](const std::string& name, std::vector<double> all) {
        if (all.empty()) return;
        std::sort(all.begin(), all.end());
        std::printf("%s  %6.3f  %6.3f  %6.3f\n", padded(name, 34).c_str(), all[all.size() / 2],
                    all.front(), all.back());
    };
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        print(exercises[i].place() + " " + exercises[i].name, seconds[i]);
        auto& kind = exercises[i].eigen ? eigen : plain;
        kind.insert(kind.end(), seconds[i].begin(), seconds[i].end());
    }
    std::printf("\n");
    print("all without Eigen", plain);
    print("all with Eigen", eigen);
}

}  // namespace course
