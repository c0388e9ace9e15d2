// Every method in every scene of chapter 7: error, time and work. ./course bench builds it and hands over to it.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <utility>

#include "diagram.hpp"
#include "files.hpp"
#include "lab.hpp"
#include "options.hpp"
#include "contest/scenes.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace fs = std::filesystem;
using contest::Point;
using course::padded;
using course::Status;
using course::Stop;

namespace {

struct Asked {
    bool quick = false;
    fs::path out;
    std::vector<contest::Named> scenes;  // in the order of the page
};

Asked read_words(int argc, char** argv) {
    const auto& all = contest::all_scenes;
    Asked asked;
    std::vector<std::string> given;
    lab::Options options("./course bench");
    options.add("--quick", asked.quick);
    options.add("--out", [&](const std::string& folder) { return asked.out = folder, std::string(); });
    const auto add_scene = [&](const std::string& id) -> std::string {
        given.push_back(id);
        std::string ids;
        for (const auto& scene : all) {
            if (scene.id == id) return "";
            ids += (ids.empty() ? "" : ", ") + std::string(scene.id);
        }
        return "must be one of " + ids;
    };
    options.add("--scene", add_scene, true);
    try {
        if (!options.parse(argc, argv)) throw std::invalid_argument("./course bench --help says what it takes");
    } catch (const std::invalid_argument& wrong) {
        throw Stop(Status::bad_use, wrong.what());
    }
    for (const auto& scene : all)
        if (given.empty() || std::find(given.begin(), given.end(), scene.id) != given.end())
            asked.scenes.push_back(scene);
    return asked;
}

void prepare(const fs::path& folder) {
    std::error_code error;
    if (folder.empty()) throw Stop(Status::bad_use, "--out '': must be the name of a folder");
    fs::create_directories(folder, error);
    if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
    if (error)
        throw Stop(Status::bad_use, "--out " + folder.string() + ": cannot write there (" + error.message() + ")");
}

// How a result came about.
using Setup = std::vector<std::pair<std::string, std::string>>;

struct Measured {
    contest::Scene scene;
    std::vector<Point> points;
};

std::string as_csv(const Setup& setup, const Measured& measured) {
    std::ostringstream text;
    text.precision(17);  // reads back as the same number
    for (const auto& [key, words] : setup) text << "# " << key << ": " << words << "\n";
    text << "# scene: " << measured.scene.title << "\n# reference error: " << measured.scene.reference_error
         << "\nscene,method,library,step,error_final,error_max,seconds,evaluations,solves,diverged\n";
    for (const Point& p : measured.points) {
        text << p.scene << ",\"" << p.method << "\",\"" << p.library << "\"";
        for (const double value : {p.step, p.error_final, p.error_max, p.seconds, p.evaluations, p.solves})
            text << "," << value;
        text << (p.diverged ? ",true\n" : ",false\n");
    }
    return text.str();
}

void print_row(const std::string& first, const contest::Cheapest& best) {
    char rate[32];
    std::snprintf(rate, sizeof rate, "%.3g", 1 / best.step);
    std::printf("  %s%s\n", padded(first, 12).c_str(),
                best.method.empty() ? "none"
                                    : (padded(best.method + ", " + best.library, 44) + padded(rate, 10) +
                                       contest::time_in_words(best.seconds))
                                          .c_str());
}

// The cheapest method at 10 %, 1 %, 0.1 % and 1e-6.
void print_table(const Measured& measured) {
    const contest::Scene& scene = measured.scene;
    const auto is_ours = [](const std::string& library) { return library.starts_with("Timestep"); };
    std::printf("\n%s (%s)\n", course::bold(scene.title).c_str(), scene.id.c_str());
    if (scene.reference_error > 0) std::printf("  known to %.1g of the scene's size\n", scene.reference_error);
    std::printf("  %s%s%s%s\n", padded("right to", 12).c_str(), padded("the cheapest", 44).c_str(),
                padded("Hz", 10).c_str(), "time");
    for (const auto& [words, accuracy] : {std::pair{"10 %", 0.1}, {"1 %", 0.01}, {"0.1 %", 1e-3}, {"1e-6", 1e-6}}) {
        const auto best = contest::cheapest(measured.points, accuracy, [](const Point&) { return true; });
        print_row(words, best);
        if (best.method.empty() || is_ours(best.library)) continue;
        print_row("   of ours",
                  contest::cheapest(measured.points, accuracy, [&](const Point& p) { return is_ours(p.library); }));
    }
}

void run(const Asked& asked) {
    const Setup setup{{"effort", asked.quick ? "quick" : "full"},
                      {"compiler", BENCH_COMPILER},
                      {"flags", BENCH_FLAGS},
                      {"cpu", lab::processor()}};
    prepare(asked.out);
    course::ProgressLine progress;
    std::vector<Measured> all;
    bool can_draw = true;
    for (const auto& [id, make] : asked.scenes) {
        const std::string which =
            "scene " + std::to_string(all.size() + 1) + " of " + std::to_string(asked.scenes.size()) + ", " + id + ": ";
        progress.now(which + "the reference");
        all.push_back({make(), {}});
        auto& [scene, points] = all.back();
        points = contest::measure(scene, asked.quick ? contest::quick : contest::full,
                                  [&](const std::string& what) { progress.now(which + what); });
        const fs::path csv = asked.out / (scene.id + ".csv");
        course::write_whole(csv, as_csv(setup, all.back()));
        can_draw = can_draw && bench::draw(csv, scene.title, points);
    }
    progress.clear();

    for (const auto& [key, text] : setup) std::printf("%s%s\n", padded(key, 10).c_str(), text.c_str());
    std::printf("\nA run is %g s of the scene; right means right at each of %d moments of it.\n", contest::duration,
                contest::marks);
    for (const Measured& measured : all) print_table(measured);
    std::printf("\n");
    std::istringstream missing(BENCH_MISSING);
    for (std::string peer; std::getline(missing, peer, '|');)
        std::printf("Not installed, so not measured: %s\n", peer.c_str());
    if (!can_draw) std::printf("No figures: gnuplot is not installed (package gnuplot-nox)\n");
    std::printf("Every run, as CSV%s: %s\n", can_draw ? ", and a figure per scene" : "",
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
