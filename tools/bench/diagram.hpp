#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "contest/contest.hpp"

namespace bench {

// Draws error against run time from the scene's CSV file into an SVG file beside it. Returns whether gnuplot is
// installed; throws Stop when it cannot draw.
bool draw(const std::filesystem::path& csv, const std::string& title, const std::vector<contest::Point>& points);

}  // namespace bench
