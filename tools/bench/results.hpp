#pragma once
// What was measured of a scene, and how it is written: as CSV, one file per scene, and as JSON.

#include <string>
#include <utility>
#include <vector>

#include "contest/contest.hpp"

namespace bench {

// How a result came about: effort, compiler, flags and CPU, in words.
using Setup = std::vector<std::pair<std::string, std::string>>;
Setup setup(const std::string& effort);

struct Measured {
    std::string title;
    double reference_error = 0;
    std::vector<contest::Point> points;
};

// The file of one scene.
std::string as_csv(const Setup& setup, const Measured& measured);

// A list of points, as programs read it.
std::string as_json(const std::vector<Measured>& all);

// The setup and the scenes of the results in a folder, and the libraries that are not installed.
std::string about_json(const Setup& setup, const std::vector<std::string>& scenes);

// Libraries that could be measured were they installed: "GSL (package libgsl-dev)".
std::vector<std::string> missing_peers();

}  // namespace bench
