#include "results.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

#include "files.hpp"
#include "lab.hpp"

namespace bench {

namespace {

using contest::Point;
using Json = nlohmann::ordered_json;

const char* const columns =
    "scene,method,library,step,error_final,error_max,seconds,evaluations,solves,diverged,"
    "instructions";

// A program that was compiled anew from other sources is another program.
std::string fingerprint() {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (std::istreambuf_iterator<char> byte(file), end; byte != end; ++byte)
        hash = (hash ^ static_cast<unsigned char>(*byte)) * 1099511628211u;
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

// The shortest words that read back as the same number.
std::string exact(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// Reads what as_csv has written. False where it is something else.
bool read(const std::string& word, double& value) {
    return std::from_chars(word.data(), word.data() + word.size(), value).ptr == word.data() + word.size() &&
           !word.empty();
}

// Words between commas; a method's name may hold one and stands in quotes.
std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> all{""};
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            all.emplace_back();
        else
            all.back() += c;
    }
    return all;
}

std::string as_csv(const Setup& setup, const Measured& measured) {
    std::string text;
    for (const auto& [key, words] : setup) text += "# " + key + ": " + words + "\n";
    text += "# scene: " + measured.title + "\n# reference error: " + exact(measured.reference_error) +
            "\n# rows: " + std::to_string(measured.points.size()) + "\n" + columns + "\n";
    for (std::size_t i = 0; i < measured.points.size(); ++i) {
        const Point& p = measured.points[i];
        text += p.scene + ",\"" + p.method + "\",\"" + p.library + "\"";
        for (const double value : {p.step, p.error_final, p.error_max, p.seconds, p.evaluations, p.solves})
            text += "," + exact(value);
        text += p.diverged ? ",true," : ",false,";
        if (std::isfinite(measured.instructions[i])) text += exact(measured.instructions[i]);
        text += "\n";
    }
    return text;
}

bool read_point(const std::string& line, Measured& measured) {
    const auto words = cells(line);
    if (words.size() != 11) return false;
    Point p{words[0], words[1], words[2]};
    double instructions = std::numeric_limits<double>::quiet_NaN();
    if (!read(words[3], p.step) || !read(words[4], p.error_final) || !read(words[5], p.error_max) ||
        !read(words[6], p.seconds) || !read(words[7], p.evaluations) || !read(words[8], p.solves) ||
        (!words[10].empty() && !read(words[10], instructions)))
        return false;
    p.diverged = words[9] == "true";
    measured.points.push_back(p);
    measured.instructions.push_back(instructions);
    return true;
}

// JSON knows neither NaN nor infinity.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json whole(double value) { return std::isfinite(value) ? Json(std::llround(value)) : Json(nullptr); }

}  // namespace

Setup setup(const std::string& effort) {
    return {{"effort", effort},
            {"compiler", BENCH_COMPILER},
            {"flags", BENCH_FLAGS},
            {"cpu", lab::processor()},
            {"program", fingerprint()}};
}

void keep(const std::filesystem::path& file, const Setup& setup, const Measured& measured) {
    course::write_whole(file, as_csv(setup, measured));
}

Kept find_kept(const std::filesystem::path& file, const Setup& setup) {
    std::ifstream lines(file);
    std::string line, rest;
    if (!std::getline(lines, line)) return {};
    for (const auto& [key, words] : setup) {
        if (line != "# " + key + ": " + words) return {{}, key};
        std::getline(lines, line);
    }
    Measured measured;
    const auto after = [&](const std::string& key) {
        const bool there = line.starts_with(key);
        rest = there ? line.substr(key.size()) : "";
        std::getline(lines, line);
        return there;
    };
    bool good = after("# scene: ");
    measured.title = rest;
    double rows = 0;
    good = good && after("# reference error: ") && read(rest, measured.reference_error) && after("# rows: ") &&
           read(rest, rows) && line == columns;
    while (good && std::getline(lines, line))
        good = read_point(line, measured) && measured.points.back().scene == file.stem();
    if (!good || measured.points.empty() || double(measured.points.size()) != rows) return {{}, "form"};
    return {measured, {}};
}

std::string as_json(const std::vector<Measured>& all) {
    Json list = Json::array();
    for (const Measured& measured : all)
        for (std::size_t i = 0; i < measured.points.size(); ++i) {
            const Point& p = measured.points[i];
            list.push_back({{"scene", p.scene},
                            {"method", p.method},
                            {"library", p.library},
                            {"step", p.step},
                            {"error_final", finite(p.error_final)},
                            {"error_max", finite(p.error_max)},
                            {"seconds", p.seconds},
                            {"evaluations", whole(p.evaluations)},
                            {"solves", whole(p.solves)},
                            {"diverged", p.diverged},
                            {"instructions", whole(measured.instructions[i])}});
        }
    return list.dump(1);
}

std::string about_json(const Setup& setup, const std::vector<std::string>& scenes) {
    Json about;
    for (const auto& [key, words] : setup) about[key] = words;
    about["scenes"] = scenes;
    about["not_installed"] = missing_peers();
    return about.dump(1) + "\n";
}

std::vector<std::string> missing_peers() {
    std::vector<std::string> all;
    std::istringstream lines(BENCH_MISSING);
    for (std::string peer; std::getline(lines, peer, '|');) all.push_back(peer);
    return all;
}

}  // namespace bench
