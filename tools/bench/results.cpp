#include "results.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "lab.hpp"

namespace bench {

namespace {

using contest::Point;
using Json = nlohmann::ordered_json;

const char* const columns = "scene,method,library,step,error_final,error_max,seconds,evaluations,solves,diverged";

// The shortest words that read back as the same number.
std::string exact(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// JSON knows neither NaN nor infinity.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json whole(double value) { return std::isfinite(value) ? Json(std::llround(value)) : Json(nullptr); }

}  // namespace

Setup setup(const std::string& effort) {
    return {{"effort", effort}, {"compiler", BENCH_COMPILER}, {"flags", BENCH_FLAGS}, {"cpu", lab::processor()}};
}

std::string as_csv(const Setup& setup, const Measured& measured) {
    std::string text;
    for (const auto& [key, words] : setup) text += "# " + key + ": " + words + "\n";
    text += "# scene: " + measured.title + "\n# reference error: " + exact(measured.reference_error) + "\n" + columns +
            "\n";
    for (const Point& p : measured.points) {
        text += p.scene + ",\"" + p.method + "\",\"" + p.library + "\"";
        for (const double value : {p.step, p.error_final, p.error_max, p.seconds, p.evaluations, p.solves})
            text += "," + exact(value);
        text += p.diverged ? ",true\n" : ",false\n";
    }
    return text;
}

std::string as_json(const std::vector<Measured>& all) {
    Json list = Json::array();
    for (const Measured& measured : all)
        for (const Point& p : measured.points) {
            list.push_back({{"scene", p.scene},
                            {"method", p.method},
                            {"library", p.library},
                            {"step", p.step},
                            {"error_final", finite(p.error_final)},
                            {"error_max", finite(p.error_max)},
                            {"seconds", p.seconds},
                            {"evaluations", whole(p.evaluations)},
                            {"solves", whole(p.solves)},
                            {"diverged", p.diverged}});
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
