// Every method in every scene of chapter 7: error, time and work. ./course bench builds it and hands over to it.

#include <algorithm>
#include <cstdio>
#include <exception>

#include "files.hpp"
#include "options.hpp"
#include "results.hpp"
#include "contest/scenes.hpp"
#include "stop.hpp"
#include "tables.hpp"
#include "terminal.hpp"

namespace fs = std::filesystem;
using namespace bench;
using course::Status;
using course::Stop;

namespace {

struct Asked {
    bool quick = false, json = false;
    fs::path out;
    std::vector<std::string> scenes;  // in the order of the page
};

contest::Scene scene_of(const std::string& id) {
    for (const auto& named : contest::all_scenes)
        if (named.id == id) return named.make();
    std::string all;
    for (const auto& named : contest::all_scenes) all += (all.empty() ? "" : ", ") + std::string(named.id);
    throw Stop(Status::bad_use, "--scene " + (id.empty() ? "''" : id) + ": must be one of " + all);
}

Asked read_words(int argc, char** argv) {
    Asked asked;
    std::vector<std::string> given;
    lab::Options options("./course bench");
    options.add("--quick", asked.quick);
    options.add("--json", asked.json);
    options.add("--out", [&](const std::string& folder) { return asked.out = folder, std::string(); });
    options.add(
        "--scene", [&](const std::string& id) { return given.push_back(id), std::string(); }, true);
    try {
        if (!options.parse(argc, argv)) throw std::invalid_argument("./course bench --help says what it takes");
    } catch (const std::invalid_argument& wrong) {
        throw Stop(Status::bad_use, wrong.what());
    }
    const auto& all = contest::all_scenes;
    for (const auto& id : given)
        if (std::none_of(all.begin(), all.end(), [&](const auto& named) { return named.id == id; }))
            scene_of(id);  // says which there are
    for (const auto& named : all)
        if (given.empty() || std::find(given.begin(), given.end(), named.id) != given.end())
            asked.scenes.push_back(named.id);
    return asked;
}

Measured measure(const contest::Scene& scene, bool quick, const std::string& which, course::ProgressLine& progress) {
    return {scene.title, scene.reference_error,
            contest::measure(scene, quick ? contest::quick : contest::full,
                             [&](const std::string& what) { progress.now(which + ": " + what); })};
}

void prepare(const fs::path& folder) {
    std::error_code error;
    if (folder.empty()) throw Stop(Status::bad_use, "--out '': must be the name of a folder");
    fs::create_directories(folder, error);
    if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
    if (error)
        throw Stop(Status::bad_use, "--out " + folder.string() + ": cannot write there (" + error.message() + ")");
}

void run(const Asked& asked) {
    const Setup setup = bench::setup(asked.quick ? "quick" : "full");
    prepare(asked.out);
    course::write_whole(asked.out / "meta.json", about_json(setup, asked.scenes));

    course::ProgressLine progress;
    std::vector<Measured> all;
    bool can_draw = true;
    for (const auto& id : asked.scenes) {
        const std::string which =
            "scene " + std::to_string(all.size() + 1) + " of " + std::to_string(asked.scenes.size()) + ", " + id;
        progress.now(which + ": the reference");
        all.push_back(measure(scene_of(id), asked.quick, which, progress));
        const fs::path csv = asked.out / (id + ".csv");
        course::write_whole(csv, as_csv(setup, all.back()));
        can_draw = can_draw && draw(csv, all.back());
    }
    progress.clear();

    if (asked.json)
        std::printf("%s\n", as_json(all).c_str());
    else
        print_tables(setup, all);
    FILE* const people = asked.json ? stderr : stdout;
    if (!asked.json) std::printf("\n");
    for (const auto& peer : missing_peers()) std::fprintf(people, "Not installed, so not measured: %s\n", peer.c_str());
    if (!can_draw) std::fprintf(people, "No figures: gnuplot is not installed (package gnuplot-nox)\n");
    std::fprintf(people, "Every run, as CSV%s: %s\n", can_draw ? ", and a figure per scene" : "",
                 fs::absolute(asked.out).lexically_normal().c_str());
    course::flush();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run(read_words(argc, argv));
        return 0;
    } catch (const Stop& stop) {
        std::fprintf(stderr, "bench: %s\n", stop.what());
        return static_cast<int>(stop.status());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench: %s\n", error.what());
        return 1;
    }
}
