// course bench: the contest of chapter 7, the tables of targets, and what a check takes

#include <algorithm>
#include <cstdio>

#include "build.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"
#include "terminal.hpp"
#include "verdict.hpp"

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

// Before anything is built for them: are there such scenes?
void check_scenes(const std::vector<std::string>& given, const std::vector<std::string>& known) {
    for (const auto& scene : given)
        if (!known.empty() && std::find(known.begin(), known.end(), scene) == known.end()) {
            std::string all;
            for (const auto& name : known) all += (all.empty() ? "" : ", ") + name;
            throw Stop(Status::bad_use, "--scene '" + sanitized_line(scene) + "': must be one of " + all);
        }
}

// The names in the list of a source: what stands in quotes at the beginning of each of its entries.
std::vector<std::string> names_in(const std::filesystem::path& source, const std::string& list,
                                  const std::string& before) {
    std::error_code ignored;
    if (!std::filesystem::exists(source, ignored)) return {};
    const std::string text = contents(source);
    const auto begin = text.find(list), end = text.find("};", begin);
    std::vector<std::string> names;
    for (auto at = text.find(before, begin); begin != std::string::npos && at < end; at = text.find(before, at + 1)) {
        const auto first = at + before.size();
        names.push_back(text.substr(first, text.find('"', first) - first));
    }
    return names;
}

}  // namespace

void bench(const Contest& contest) {
    check_scenes(contest.scenes,
                 names_in(paths().source / "tools/bench/contest/scenes.hpp", "all_scenes{", "Named{\""));
    {
        ProgressLine progress;
        build({"bench"}, progress);
    }
    const auto folder = paths().build / "runs" / (contest.quick ? "bench_quick" : "bench");
    std::vector<std::string> command{(paths().build / "tools/bench/bench").string(), "--out",
                                     contest.out.value_or(folder.string())};
    if (contest.quick) command.push_back("--quick");
    if (contest.json) command.push_back("--json");
    if (contest.again) command.push_back("--again");
    for (const auto& scene : contest.scenes) {
        command.push_back("--scene");
        command.push_back(scene);
    }
    hand_over(command);
}

void bench_loops() { run_each({"bench_loops_O2", "bench_loops_O3_native"}); }

void bench_gyroscopic() { run_each({"bench_gyroscopic_O2", "bench_gyroscopic_O3_native"}); }

void bench_many() { run_each({"bench_many_O2", "bench_many_O2_native", "bench_many_O3_native"}); }

void bench_engines(const Contest& contest, const std::optional<std::string>& engine) {
    check_scenes(contest.scenes, names_in(paths().source / "engines/measure/engines.cpp", "Scene scenes[]", "{\""));
    {
        ProgressLine progress;
        build({"bench_engines"}, progress);
    }
    const auto folder = paths().build / "runs/engines";
    std::vector<std::string> command{(paths().build / "engines/measure/bench_engines").string(), "--out",
                                     contest.out.value_or(folder.string())};
    if (contest.quick) command.push_back("--quick");
    if (engine) command.insert(command.end(), {"--engine", *engine});
    for (const auto& scene : contest.scenes) command.insert(command.end(), {"--scene", scene});
    hand_over(command);
}

// The course's own answers are checked, round by round, so that a busy moment touches every
// exercise.
void bench_latency(int rounds) {
    if (is_kit())
        throw Stop(Status::bad_use, "this is the learner's edition: it has no solutions to check for bench latency");
    ProgressLine progress;
    const auto exercises = read_exercises();
    make_ready(exercises, progress);
    std::vector<std::vector<double>> seconds(exercises.size());
    for (int round = 0; round < rounds; ++round) {
        progress.now("round " + std::to_string(round + 1) + " of " + std::to_string(rounds));
        for (std::size_t i = 0; i < exercises.size(); ++i) {
            const Verdict verdict =
                check_file(exercises[i], exercises[i].solution(), static_cast<std::uint64_t>(round));
            if (verdict.kind != "pass")
                throw Stop(Status::wrong, exercises[i].name + ": the solution does not pass: " + verdict.kind);
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
        std::printf("%s  %6.3f  %6.3f  %6.3f\n", padded(name, 34).c_str(), all[all.size() / 2], all.front(),
                    all.back());
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
