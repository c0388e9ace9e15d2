#include "tables.hpp"

#include <cstdio>

#include "terminal.hpp"

namespace bench {

namespace {

using contest::Cheapest;
using contest::Point;
using course::padded;

std::string words(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

void print_row(const std::string& first, const Cheapest& best) {
    std::string row = padded(first, 12);
    if (best.method.empty())
        row += "none";
    else
        row += padded(best.method + ", " + best.library, 44) + padded(words("%.3g", 1 / best.step), 10) +
               contest::time_in_words(best.seconds);
    std::printf("  %s\n", row.c_str());
}

void print_table(const Measured& measured) {
    const auto& points = measured.points;
    std::printf("\n%s (%s)\n", course::bold(measured.title).c_str(), points.front().scene.c_str());
    if (measured.reference_error > 0) std::printf("  known to %.1g of the scene's size\n", measured.reference_error);
    std::printf("  %s%s%s%s\n", padded("right to", 12).c_str(), padded("the cheapest", 44).c_str(),
                padded("Hz", 10).c_str(), "time");
    const struct {
        const char* words;
        double accuracy;
    } wishes[] = {{"10 %", 0.1}, {"1 %", 0.01}, {"0.1 %", 1e-3}, {"1e-6", 1e-6}};
    for (const auto& wish : wishes) {
        const Cheapest best = contest::cheapest(points, wish.accuracy, [](const Point&) { return true; });
        print_row(wish.words, best);
        if (best.method.empty() || best.library.starts_with("Timestep")) continue;
        print_row("   of ours", contest::cheapest(points, wish.accuracy,
                                                  [](const Point& p) { return p.library.starts_with("Timestep"); }));
    }
}

}  // namespace

void print_tables(const Setup& setup, const std::vector<Measured>& all) {
    for (const auto& [key, text] : setup) std::printf("%s%s\n", padded(key, 10).c_str(), text.c_str());
    std::printf("\nA run is %g s of the scene; right means right at each of %d moments of it.\n", contest::duration,
                contest::marks);
    for (const Measured& measured : all) print_table(measured);
}

}  // namespace bench
