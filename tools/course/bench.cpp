// course bench: the contest of chapter 7, gyroscopic rules in engines, the tables of targets

#include <cstdio>

#include "build.hpp"
#include "commands.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace course {

namespace {

// The same source under several sets of flags, one after the other.
void run_each(const std::vector<std::string>& programs) {
    ProgressLine progress;
    build(programs, progress);
    for (const auto& program : programs) {
        progress.now("running " + program);
        std::string said;
        const int status = listen(
            {(paths().build / "tools/bench" / program).string()}, [&](std::string_view text) { said += text; },
            [&] { progress.tick(); });
        progress.clear();
        std::fprintf(status == 0 ? stdout : stderr, "%s", said.c_str());
        if (status != 0) throw Stop(static_cast<Status>(status), "");
    }
}

// Builds the target and becomes it: `program` lies in the build folder.
[[noreturn]] void become(const std::string& target, const std::string& program, std::vector<std::string> options) {
    {
        ProgressLine progress;
        build({target}, progress);
    }
    options.insert(options.begin(), (paths().build / program).string());
    hand_over(options);
}

std::vector<std::string> options_of(const Contest& contest, const std::string& folder) {
    std::vector<std::string> options{"--out", contest.out.value_or((paths().build / "runs" / folder).string())};
    if (contest.quick) options.push_back("--quick");
    for (const auto& scene : contest.scenes) options.insert(options.end(), {"--scene", scene});
    return options;
}

}  // namespace

void bench(const Contest& contest) {
    become("bench", "tools/bench/bench", options_of(contest, contest.quick ? "bench_quick" : "bench"));
}

void bench_loops() { run_each({"bench_loops_O2", "bench_loops_O3_native"}); }

void bench_many() { run_each({"bench_many_O2", "bench_many_O2_native", "bench_many_O3_native"}); }

void bench_engines(const Contest& contest, const std::optional<std::string>& engine) {
    auto options = options_of(contest, "engines");
    if (engine) options.insert(options.end(), {"--engine", *engine});
    become("bench_engines", "engines/measure/bench_engines", options);
}

}  // namespace course
