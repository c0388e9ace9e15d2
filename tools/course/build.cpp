#include "build.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "exercises.hpp"
#include "places.hpp"
#include "process.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

// A line of Ninja ("[3/80] Linking …") or of Make ("[ 12%] Linking …"): how far, and what.
struct Step {
    std::string count, text;
};

bool read_step(const std::string& line, Step& step) {
    const auto close = line.find("] ");
    if (line.empty() || line[0] != '[' || close == std::string::npos) return false;
    step = {line.substr(1, close - 1), line.substr(close + 2)};
    return true;
}

bool starts_with_any(const std::string& text, std::initializer_list<const char*> beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(),
                       [&](const char* beginning) { return text.starts_with(beginning); });
}

// What CMake says of its own accord; anything else is a stage of ours, named by a COMMENT.
bool is_routine(const std::string& text) {
    return starts_with_any(text, {"Building", "Linking", "Built target", "Generating", "Scanning",
                                  "Consolidate", "Re-running", "Re-checking", "Cleaning",
                                  "Completed", "No ", "Performing", "Creating", "Automatic"});
}

// The lines that say why: from the first failure on, without the names and commands of what failed,
// which are long and stand in the log.
std::vector<std::string> reason(const std::vector<std::string>& log) {
    const std::size_t most = 30;
    const auto begin = std::find_if(log.begin(), log.end(), [](const std::string& line) {
        return starts_with_any(line, {"FAILED:", "CMake Error", "ninja: error"});
    });
    if (begin == log.end())
        return {log.end() - static_cast<std::ptrdiff_t>(std::min(most, log.size())), log.end()};
    std::vector<std::string> lines;
    for (auto line = begin; line != log.end() && lines.size() < most; ++line) {
        const bool is_command = line != log.begin() && (line - 1)->starts_with("FAILED:");
        Step step;
        if (!is_command && !starts_with_any(*line, {"FAILED:", "ninja: build stopped"}) &&
            !read_step(*line, step))
            lines.push_back(*line);
    }
    return lines;
}

}  // namespace

void build(const std::vector<std::string>& targets, ProgressLine& progress) {
    const fs::path log_path = places().build / "course.log";
    std::ofstream log(log_path);
    std::vector<std::string> heard;

    Lines lines([&](const std::string& line) {
        heard.push_back(line);
        log << line << std::endl;
        Step step;
        if (!read_step(line, step)) return;
        if (!is_routine(step.text)) {
            progress.say("  " + step.text);
            step.text.clear();
        }
        progress.now("[" + step.count + "] " + step.text);
    });
    std::vector<std::string> command{
        places().cmake,
        "--build",
        places().build.string(),
        "--parallel",
        std::to_string(std::max(1u, std::thread::hardware_concurrency())),
        "--target"};
    command.insert(command.end(), targets.begin(), targets.end());
    const int status = listen(command, std::ref(lines), [&] { progress.tick(); });
    progress.clear();
    if (status == 0) return;
    for (const auto& line : reason(heard)) std::fprintf(stderr, "%s\n", line.c_str());
    throw Stop(Status::wrong, "the build failed; the lines above say why, the whole log is in " +
                                  log_path.string());
}

std::string site_address() {
    std::string address = "file://";
    const fs::path page = is_kit() ? places().source / "site/index.html"
                                   : places().build / "site/html/index.html";
    for (const char c : page.string()) {
        const auto byte = static_cast<unsigned char>(c);
        char coded[4];
        std::snprintf(coded, sizeof coded, "%%%02X", byte);
        const bool plain = byte < 0x80 && (std::isalnum(byte) ||
                                           std::string("/-._~").find(c) != std::string::npos);
        address += plain ? std::string(1, c) : coded;
    }
    return address;
}

}  // namespace course
