#pragma once
// The results for people.

#include <filesystem>
#include <string>
#include <vector>

#include "results.hpp"

namespace bench {

// For each scene the cheapest method at 10 %, 1 %, 0.1 % and 1e-6.
void print_tables(const Setup& setup, const std::vector<Measured>& all);

// Draws error against run time from the scene's CSV file into an SVG file beside it. Returns whether gnuplot is
// installed; throws Stop when it cannot draw.
bool draw(const std::filesystem::path& csv, const Measured& measured);

}  // namespace bench
