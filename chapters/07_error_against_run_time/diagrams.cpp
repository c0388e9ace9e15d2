// Every scene's diagram: error against run time, and who is the cheapest at an accuracy.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scenes.hpp"
#include "sections.hpp"

using namespace contest;

namespace {

constexpr double accuracies[] = {0.1, 0.01, 1e-3, 1e-6};

bool ours(const Point& p) {
    return p.library == "Timestep";
}

// Two digits are all that a measured time has: 1234 becomes 1200.
std::string rounded(double value) {
    const double unit = value > 0 ? std::pow(10, std::floor(std::log10(value)) - 1) : 1;
    char text[32];
    std::snprintf(text, sizeof text, "%g", std::round(value / unit) * unit);
    return text;
}

std::string in_words(double seconds) {
    if (seconds < 1e-6) return rounded(seconds * 1e9) + " ns";
    if (seconds < 1e-3) return rounded(seconds * 1e6) + " µs";
    return rounded(seconds * 1e3) + " ms";
}

std::string in_words(const Cheapest& best) {
    if (best.method.empty()) return "none";
    return best.method + " at " + rounded(1 / best.step) + " Hz, " + in_words(best.seconds);
}

void write(const std::vector<Point>& points, lab::Table& table) {
    for (const Point& p : points)
        table.row({lab::id(p.method), p.library, p.step, std::min(p.error_final, 100.0),
                   std::min(p.error_max, 100.0), p.seconds, p.evaluations, p.solves,
                   std::string(p.diverged ? "yes" : "no")});
}

// What a step of each of our methods asks for, and what it takes, at 240 Hz.
void work_of_a_step(const std::vector<Point>& spring, lab::Findings& out) {
    auto& table = out.table("work.tsv", {"method", "evaluations", "solves", "ns a step"});
    for (const Point& p : spring)
        if (ours(p) && p.asked == 960)
            table.row({p.method, p.evaluations / 960, p.solves / 960, rounded(p.seconds / 960 * 1e9)});
}

}  // namespace

All diagrams(const std::string& one_scene, lab::Findings& out) {
    All all;
    out.section("The cheapest method of ours");
    auto& best_table = out.table("cheapest.tsv", {"scene", "10 %", "1 %", "0.1 %", "1e-6"});
    for (const auto& [id, make] : all_scenes) {
        if (one_scene != "all" && one_scene != id) continue;
        const Scene scene = make();
        const std::vector<Point> points = measure(scene, page);
        write(points, out.table(scene.id + ".tsv",
                                {"method", "library", "step (s)", "final error", "largest error",
                                 "run time (s)", "evaluations", "solves", "diverged"}));
        std::vector<lab::Cell> row{scene.title};
        std::printf("  %s\n", scene.title.c_str());
        for (const double accuracy : accuracies) {
            const Cheapest best = cheapest(points, accuracy, ours);
            row.push_back(in_words(best));
            std::printf("    to %-7.3g%s\n", accuracy, in_words(best).c_str());
        }
        best_table.row(row);
        all[scene.id] = points;
    }
    if (all.contains("spring")) work_of_a_step(all["spring"], out);
    return all;
}
