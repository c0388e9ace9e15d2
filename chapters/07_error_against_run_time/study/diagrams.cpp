// Every scene's diagram: error against run time, and who is the cheapest at an accuracy.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "contest/scenes.hpp"
#include "sections.hpp"

using namespace contest;

namespace {

constexpr double accuracies[] = {0.1, 0.01, 1e-3};

bool ours(const Point& p) { return p.library == "Timestep"; }

// On a page a number stays with its unit.
std::string together(const std::string& words) {
    std::string all;
    for (const char c : words)
        if (c == ' ' && !all.empty() && std::isdigit(static_cast<unsigned char>(all.back())))
            all += "\u00a0";
        else
            all += c;
    return all;
}

std::string in_words(const Cheapest& best) {
    if (best.method.empty()) return "not at these rates";
    return best.method + ", " + rounded(1 / best.step) + " Hz, " + time_in_words(best.seconds);
}

void write(const std::vector<Point>& points, lab::Table& table) {
    for (const Point& p : points)
        table.row({lab::id(p.method), p.library, p.step, std::min(p.error_final, 100.0), std::min(p.error_max, 100.0),
                   p.seconds, p.evaluations, p.solves, std::string(p.diverged ? "yes" : "no")});
}

// What the methods of a table make of 60 Hz: the error, and what a step takes.
void at_sixty(const All& all, const std::string& file, const std::vector<const char*>& scenes,
              const std::vector<std::string>& methods, lab::Findings& out) {
    std::vector<std::string> columns{"scene"};
    columns.insert(columns.end(), methods.begin(), methods.end());
    auto& table = out.table(file, columns);
    for (const char* id : scenes) {
        std::vector<lab::Cell> row{std::string(id)};
        for (const std::string& method : methods) {
            // A method that is exact to roundoff before it comes to 60 Hz is given no shorter
            // steps.
            std::string cell = "does not apply";
            for (const Point& p : all.at(id))
                if (ours(p) && p.method == method && p.asked <= long(60 * duration)) {
                    const double percent = 100 * p.error_max;
                    const std::string error = percent < 1e-3 ? "below 0.001" : rounded(percent);
                    const std::string time = rounded(p.seconds / double(p.asked) * 1e9);
                    cell = p.diverged ? "blows up" : error + " %, " + time + " ns";
                }
            row.push_back(together(cell));
        }
        table.row(row);
    }
}

// What a step of each of our methods asks for, and what it takes, at 240 Hz.
void work_of_a_step(const std::vector<Point>& spring, lab::Findings& out) {
    auto& table = out.table("work.tsv", {"method", "evaluations", "solves", "ns a step"});
    for (const Point& p : spring)
        if (ours(p) && p.asked == 960)
            table.row({p.method, p.evaluations / 960, p.solves / 960, rounded(p.seconds / 960 * 1e9)});
}

}  // namespace

All diagrams(const Effort& effort, lab::Findings& out) {
    All all;
    out.section("The cheapest method of ours, to 1 %");
    auto& best_table = out.table("cheapest.tsv", {"scene", "10 %", "1 %", "0.1 %"});
    for (const auto& [id, make] : all_scenes) {
        const Scene scene = make();
        const std::vector<Point> points = measure(scene, effort);
        write(points, out.table(scene.id + ".tsv", {"method", "library", "step (s)", "final error", "largest error",
                                                    "run time (s)", "evaluations", "solves", "diverged"}));
        std::string best[3];
        for (int i = 0; i < 3; ++i) best[i] = in_words(cheapest(points, accuracies[i], ours));
        if (id != std::string("spring_3d") && id != std::string("two_time_scales"))  // these have their figures
            best_table.row(
                {scene.title + " (" + scene.id + ")", together(best[0]), together(best[1]), together(best[2])});
        std::printf("  %-17s %s\n", scene.id.c_str(), best[1].c_str());
        all[scene.id] = points;
    }
    work_of_a_step(all["spring"], out);
    at_sixty(all, "sixty.tsv",
             {"projectile", "drag", "spring", "damped_spring", "spring_3d", "stiff_spring", "two_time_scales",
              "bouncing_ball"},
             {"explicit Euler", "semi-implicit Euler", "Verlet", "implicit midpoint", "Runge-Kutta 4"}, out);
    at_sixty(all, "sixty_bodies.tsv", {"dzhanibekov", "symmetric_top"},
             {"explicit", "one Newton step", "passive", "Runge-Kutta 4"}, out);
    out.text("processor", lab::processor(), "what the times were measured on");
    out.text("compiler", lab::compiler(), "what made the program");
    return all;
}
