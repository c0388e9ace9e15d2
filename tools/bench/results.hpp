#pragma once
// What was measured of a scene, and how it is kept: a CSV file a scene, made under one setup.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contest/contest.hpp"

namespace bench {

// How a result came about: effort, compiler, flags, CPU and program, in words. Results of two
// setups are never shown together.
using Setup = std::vector<std::pair<std::string, std::string>>;
Setup setup(const std::string& effort);

struct Measured {
    std::string title;
    double reference_error = 0;
    std::vector<contest::Point> points;
    std::vector<double> instructions;  // of each point's run; NaN: not counted
};

// The file of one scene, whole or not at all. Throws Stop where it cannot be written.
void keep(const std::filesystem::path& file, const Setup& setup, const Measured& measured);

struct Kept {
    std::optional<Measured> measured;  // nothing: not there, not readable, or of another setup
    std::string other;                 // what is other about that one: "compiler"
};
Kept find_kept(const std::filesystem::path& file, const Setup& setup);

// A list of points, as programs read it.
std::string as_json(const std::vector<Measured>& all);

// The setup and the scenes that the results in a folder are of, and the libraries that are not
// there.
std::string about_json(const Setup& setup, const std::vector<std::string>& scenes);

// Libraries that could be measured were they installed: "GSL (package libgsl-dev)".
std::vector<std::string> missing_peers();

}  // namespace bench
