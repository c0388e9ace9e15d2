// Every method in every scene of chapter 7: error, time and work. ./course bench builds it and
// hands over to it. Each scene that is measured is kept; a run that was killed goes on after the
// last one.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>

#include "count.hpp"
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
    bool quick = false, json = false, again = false;
    fs::path out;
    std::vector<std::string> scenes;  // in the order of the page
    std::string count;                // a scene: only take its runs, for callgrind to count
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
    const auto into = [](auto& word) {
        return [&word](const std::string& value) {
            word = value;
            return std::string();
        };
    };
    lab::Options options("./course bench");
    options.add("--quick", asked.quick);
    options.add("--json", asked.json);
    options.add("--again", asked.again);
    options.add("--out", into(asked.out));
    options.add("--count", into(asked.count));
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

// ---- Instructions
// --------------------------------------------------------------------------------

// So many steps are counted. callgrind is slow, and the longer runs follow from these.
constexpr long most_counted = 30L << 6;

void run_for_callgrind(const contest::Scene& scene) {
    for (const auto& entry : scene.entries) {
        entry.run(contest::marks);  // libraries are bound with the first call
        for (long steps = contest::marks; steps <= most_counted; steps *= 2) counted([&] { entry.run(steps); });
    }
}

double steps_taken(const contest::Point& p) { return contest::duration / p.step; }

// The instructions of each point's run. Each entry was counted at 30, 60, … steps; where its points
// go on, a further step costs what one did between the two longest runs counted.
void take_over(const std::vector<double>& counts, Measured& measured) {
    std::size_t next = 0;
    long counted_per_entry = 0;
    for (long steps = contest::marks; steps <= most_counted; steps *= 2) ++counted_per_entry;
    const auto& points = measured.points;
    for (std::size_t first = 0; first < points.size(); next += std::size_t(counted_per_entry)) {
        if (next + std::size_t(counted_per_entry) > counts.size()) return;
        std::size_t i = first;
        for (; i < points.size() && points[i].method == points[first].method &&
               points[i].library == points[first].library;
             ++i) {
            const std::size_t k = i - first;
            if (k < std::size_t(counted_per_entry)) {
                measured.instructions[i] = counts[next + k];
                continue;
            }
            const std::size_t last = first + std::size_t(counted_per_entry) - 1;
            const double further = (measured.instructions[last] - measured.instructions[last - 1]) /
                                   (steps_taken(points[last]) - steps_taken(points[last - 1]));
            measured.instructions[i] =
                measured.instructions[last] + further * (steps_taken(points[i]) - steps_taken(points[last]));
        }
        first = i;
    }
}

// ---- Measuring
// -----------------------------------------------------------------------------------

Measured measure(const std::string& id, const Asked& asked, const std::string& which, course::ProgressLine& progress,
                 bool& can_count) {
    progress.now(which + ": the reference");
    const contest::Scene scene = scene_of(id);
    Measured measured{scene.title, scene.reference_error, {}, {}};
    measured.points = contest::measure(scene, asked.quick ? contest::quick : contest::full,
                                       [&](const std::string& what) { progress.now(which + ": " + what); });
    measured.instructions.assign(measured.points.size(), std::numeric_limits<double>::quiet_NaN());
    if (asked.quick || !can_count) return measured;
    progress.now(which + ": counting instructions");
    const Counts counts = count_instructions({"--count", id});
    can_count = counts.failure.empty();
    if (!can_count) progress.say("bench: instructions are not counted: " + counts.failure);
    take_over(counts.instructions, measured);
    return measured;
}

void prepare(const fs::path& folder) {
    std::error_code error;
    if (folder.empty()) throw Stop(Status::bad_use, "--out '': must be the name of a folder");
    fs::create_directories(folder, error);
    if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
    if (error)
        throw Stop(Status::bad_use, "--out " + folder.string() + ": cannot write there (" + error.message() + ")");
}

// What is kept of this setup, so that it need not be measured; says what it does with what it
// finds.
std::vector<std::optional<Measured>> find_all_kept(const Asked& asked, const Setup& setup) {
    std::vector<std::optional<Measured>> all(asked.scenes.size());
    if (asked.again) return all;
    std::size_t kept = 0;
    std::string other;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Kept found = find_kept(asked.out / (asked.scenes[i] + ".csv"), setup);
        if (!found.other.empty()) other = found.other;
        kept += found.measured.has_value();
        all[i] = std::move(found.measured);
    }
    const std::string place = course::shown(asked.out);
    if (!other.empty())
        std::fprintf(stderr, "bench: results in %s are of another %s: these scenes are measured anew\n", place.c_str(),
                     other.c_str());
    if (kept > 0)
        std::fprintf(stderr, "bench: %zu of %zu scenes are in %s already; --again measures them, too\n", kept,
                     all.size(), place.c_str());
    return all;
}

void run(const Asked& asked) {
    const Setup setup = bench::setup(asked.quick ? "quick" : "full");
    prepare(asked.out);
    course::write_whole(asked.out / "meta.json", about_json(setup, asked.scenes));
    auto kept = find_all_kept(asked, setup);

    course::ProgressLine progress;
    std::vector<Measured> all;
    bool can_count = true, can_draw = true;
    for (std::size_t i = 0; i < asked.scenes.size(); ++i) {
        const fs::path csv = asked.out / (asked.scenes[i] + ".csv");
        if (!kept[i]) {
            kept[i] = measure(asked.scenes[i], asked,
                              "scene " + std::to_string(i + 1) + " of " + std::to_string(asked.scenes.size()) + ", " +
                                  asked.scenes[i],
                              progress, can_count);
            keep(csv, setup, *kept[i]);
        }
        all.push_back(*kept[i]);
    }
    progress.now("drawing");
    for (std::size_t i = 0; i < all.size() && can_draw; ++i)
        can_draw = draw(asked.out / (asked.scenes[i] + ".csv"), all[i]);
    progress.clear();

    if (asked.json)
        std::printf("%s\n", as_json(all).c_str());
    else
        print_tables(setup, all);
    FILE* const people = asked.json ? stderr : stdout;
    if (!asked.json) std::printf("\n");
    for (const auto& peer : missing_peers()) std::fprintf(people, "Not installed, so not measured: %s\n", peer.c_str());
    if (!can_draw) std::fprintf(people, "No figures: gnuplot is not installed (package gnuplot-nox)\n");
    std::fprintf(people, "Every run, as CSV%s: %s\n", can_draw ? ", and a figure a scene" : "",
                 fs::absolute(asked.out).lexically_normal().c_str());
    course::flush();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const Asked asked = read_words(argc, argv);
        if (asked.count.empty())
            run(asked);
        else
            run_for_callgrind(scene_of(asked.count));
        return 0;
    } catch (const Stop& stop) {
        std::fprintf(stderr, "bench: %s\n", stop.what());
        return static_cast<int>(stop.status());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench: %s\n", error.what());
        return 1;
    }
}
