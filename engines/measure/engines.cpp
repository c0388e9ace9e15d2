// Gyroscopic rules inside physics engines, before and after: ./course bench engines.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "options.hpp"
#include "scenes.hpp"
#include "timing.hpp"

namespace fs = std::filesystem;
using namespace engines;

namespace {

struct Scene {
    const char* id;
    void (*run)(const std::vector<Engine>&, const Effort&, Numbers&);
};
constexpr Scene scenes[] = {
    {"alone", fly}, {"top", spin_tops}, {"throws", throw_bodies}, {"piles", pile_up}, {"cost", time_steps}};

struct Asked {
    Effort effort;
    fs::path out;
    std::string engine;  // only those whose name begins so
    std::vector<std::string> scenes;
};

Asked read_words(int argc, char** argv, const std::vector<Engine>& all) {
    Asked asked;
    lab::Options options("./course bench engines");
    options.add("--quick", asked.effort.quick);
    options.add("--out", [&](const std::string& folder) -> std::string {
        asked.out = folder;
        return folder.empty() ? "must be the name of a folder" : "";
    });
    options.add("--engine", [&](const std::string& name) -> std::string {
        asked.engine = name;
        return name.empty() ? "must be the beginning of an engine's name" : "";
    });
    options.add(
        "--scene", [&](const std::string& id) { return asked.scenes.push_back(id), std::string(); }, true);
    if (!options.parse(argc, argv)) throw std::invalid_argument("./course bench --help says what it takes");
    std::string names;
    for (const Scene& scene : scenes) names += (names.empty() ? "" : ", ") + std::string(scene.id);
    for (const std::string& id : asked.scenes)
        if (std::none_of(std::begin(scenes), std::end(scenes), [&](const Scene& s) { return s.id == id; }))
            throw std::invalid_argument("--scene '" + id + "': must be one of " + names);
    if (std::none_of(all.begin(), all.end(), [&](const Engine& e) { return e.name.starts_with(asked.engine); }))
        throw std::invalid_argument("--engine " + asked.engine +
                                    ": must be the beginning of the name of an engine that is here");
    return asked;
}

// Asked for before anything is measured.
void prepare(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error))
        throw std::invalid_argument("--out " + folder.string() + ": must be a folder that can be written");
}

void run(const Asked& asked, std::vector<Engine> all, const std::vector<std::string>& missing) {
    if (!asked.out.empty()) prepare(asked.out);
    std::erase_if(all, [&](const Engine& e) { return !e.name.starts_with(asked.engine); });
    // Rows of one engine, or of one number of substeps, stand together.
    std::stable_sort(all.begin(), all.end(), [](const Engine& a, const Engine& b) { return a.name < b.name; });
    Numbers numbers;
    for (const Scene& scene : scenes) {
        const bool wanted =
            asked.scenes.empty() || std::find(asked.scenes.begin(), asked.scenes.end(), scene.id) != asked.scenes.end();
        if (!wanted) continue;
        const double seconds = lab::seconds_of([&] { scene.run(all, asked.effort, numbers); });
        std::printf("(%s: %.1f s)\n", scene.id, seconds);
        std::fflush(stdout);
    }
    std::printf("\n");
    for (const std::string& line : missing) std::printf("Not here, so not measured: %s\n", line.c_str());
    if (!asked.out.empty()) record(asked.out, numbers);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<Engine> all;
        std::vector<std::string> missing;
        enter_bullet(all, missing), enter_ode(all, missing), enter_checkouts(all, missing);
        if (all.empty()) {
            for (const std::string& line : missing) std::fprintf(stderr, "bench_engines: not here: %s\n", line.c_str());
            return 3;
        }
        run(read_words(argc, argv, all), all, missing);
        return std::fflush(stdout) == 0 ? 0 : 2;
    } catch (const std::invalid_argument& wrong) {
        std::fprintf(stderr, "bench_engines: %s\n", wrong.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_engines: %s\n", error.what());
        return 1;
    }
}
