#include "build.hpp"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include <unistd.h>

#include "exercises.hpp"
#include "files.hpp"
#include "process.hpp"
#include "paths.hpp"
#include "stop.hpp"
#include "verdict.hpp"

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

// Is this a line of CMake's own, not the COMMENT of one of our commands?
bool is_routine(const std::string& text) {
    return starts_with_any(
        text, {"Building", "Linking", "Built target", "Generating", "Scanning", "Consolidate", "Re-running",
               "Re-checking", "Cleaning", "Completed", "No ", "Performing", "Creating", "Automatic"});
}

// The lines that say why a build failed: from the first failure on, without the long names and commands, which are in
// the log.
std::vector<std::string> reason(const std::vector<std::string>& log) {
    const std::size_t most = 30;
    const auto begin = std::find_if(log.begin(), log.end(), [](const std::string& line) {
        return starts_with_any(line, {"FAILED:", "CMake Error", "ninja: error"});
    });
    if (begin == log.end()) return {log.end() - static_cast<std::ptrdiff_t>(std::min(most, log.size())), log.end()};
    std::vector<std::string> lines;
    for (auto line = begin; line != log.end() && lines.size() < most; ++line) {
        const bool is_command = line != log.begin() && (line - 1)->starts_with("FAILED:");
        Step step;
        if (!is_command && !starts_with_any(*line, {"FAILED:", "ninja: build stopped"}) && !read_step(*line, step))
            lines.push_back(*line);
    }
    return lines;
}

void mark_ready(const std::vector<fs::path>& marks, const std::string& text, fs::file_time_type begin) {
    std::error_code ignored;
    fs::create_directories(marks.front().parent_path(), ignored);
    for (const auto& mark : marks) {
        write_whole(mark, text);
        fs::last_write_time(mark, begin, ignored);  // what changed during the build counts as new
    }
}

// Debian changes this file whenever a package is installed or removed.
const fs::path packages = "/var/lib/dpkg/status";

// Has CMake configured this course here completely?
bool is_configured() {
    std::error_code ignored;
    const auto is_written = [&](const char* name) {
        return fs::is_regular_file(paths().build / name, ignored) && fs::file_size(paths().build / name, ignored) > 0;
    };
    const std::string home = "CMAKE_HOME_DIRECTORY:INTERNAL=" + paths().source.string();
    std::ifstream cache(paths().build / "CMakeCache.txt");
    for (std::string line; std::getline(cache, line);)
        if (line == home) return is_written("build.ninja") || is_written("Makefile");
    return false;
}

// A learner's edition is configured when there is something to build, since its course program comes built; and again
// after a package was installed or removed, since CMake may find more or less.
void configure_kit(ProgressLine& progress) {
    const fs::path &root = paths().source, mark = paths().build / "packages_seen";
    const bool fresh = !is_configured();
    const auto seen = written_at(mark);
    if (!fresh && seen && !(fs::exists(packages) && touched_since(packages, *seen))) return;
    const auto begin = fs::file_time_type::clock::now();
    progress.say("Looking at the compiler and the libraries of this machine:");
    std::string unfit, all;
    Lines lines([&](const std::string& line) {
        if (line.starts_with("course: ")) unfit = line.substr(8);
        all += line + "\n";
    });
    std::vector<std::string> command{paths().cmake, "-S", root.string(), "-B", paths().build.string()};
    if (fresh) command.insert(command.end(), {"--fresh", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"});
    const int status = listen(command, std::ref(lines), [&] { progress.tick(); });
    progress.clear();
    if (status == 0) return mark_ready({mark}, "", begin);
    if (unfit.empty()) std::fprintf(stderr, "%s", all.c_str());
    throw Stop(Status::missing, unfit.empty() ? "CMake could not configure the build" : unfit);
}

// Its time is when the exercise was last found ready.
fs::path ready_mark(const Exercise& exercise) { return paths().build / "exercises/found_ready" / exercise.name; }

// What it holds: tests with another source folder or a fake for CMake use the same build folder.
std::string found_by() { return paths().source.string() + "\n" + paths().cmake + "\n"; }

// Is everything there that CMake and the build have made for a check of the exercise?
bool all_there(const Exercise& exercise) {
    if (!fs::exists(exercise.declared()) || !fs::exists(exercise.stub()) || !commands_are_whole(exercise)) return false;
    const auto parts = parts_of_check(exercise);
    return std::all_of(parts.begin(), parts.end(),
                       [](const fs::path& part) { return fs::exists(part) && !fs::is_empty(part); });
}

// Has nothing that a check of the exercise is made of been touched since it was found ready? A check then needs no
// build, not even one that finds nothing to do, and works while a tour builds.
bool is_ready(const Exercise& exercise) {
    const auto since = written_at(ready_mark(exercise));
    if (!since || contents(ready_mark(exercise)) != found_by()) return false;
    const fs::path &source = paths().source, &build = paths().build;
    const std::string room = exercise.chapter + "/" + exercise.name;
    std::vector<fs::path> parts{source / "CMakeLists.txt", source / "include", source / "tools/cmake",
                                source / "tools/checker", build / "CMakeCache.txt"};
    if (is_kit())
        parts.push_back(source / "kit");
    else
        parts.insert(parts.end(), {source / "tests/CMakeLists.txt", source / "tests/exercises/CMakeLists.txt",
                                   source / "tests/exercises" / room, source / "solutions" / (room + ".cpp")});
    if (fs::exists(packages)) parts.push_back(packages);  // the compiler may be a new one
    return std::none_of(parts.begin(), parts.end(),
                        [&](const fs::path& part) { return touched_since(part, *since); }) &&
           all_there(exercise);
}

const char* const other_builds = "Another ./course is building here; this goes on when it has done";

}  // namespace

void build(const std::vector<std::string>& targets, ProgressLine& progress, const std::string& what) {
    std::error_code ignored;
    fs::create_directories(paths().build, ignored);
    // A build may itself run this program, for a transcript on a page: it must not wait for that build.
    std::optional<Lock> one_at_a_time;
    const char* const builder = std::getenv("TIMESTEP_BUILDS_IN");
    if (builder == nullptr || builder != paths().build.string()) {
        one_at_a_time.emplace(paths().build / "course.lock", other_builds);
        setenv("TIMESTEP_BUILDS_IN", paths().build.c_str(), 1);
    }
    if (is_kit()) configure_kit(progress);
    if (targets.empty()) return;
    const fs::path log_path = paths().build / "course.log";
    std::ofstream log(log_path);
    std::vector<std::string> heard;
    std::string to_tell = what;
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    const auto tell_if_late = [&] {
        if (to_tell.empty() || std::chrono::steady_clock::now() < late) return;
        progress.say(to_tell);
        to_tell.clear();
    };

    Lines lines([&](const std::string& line) {
        tell_if_late();
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
    std::vector<std::string> command{paths().cmake,
                                     "--build",
                                     paths().build.string(),
                                     "--parallel",
                                     std::to_string(std::max(1u, std::thread::hardware_concurrency())),
                                     "--target"};
    command.insert(command.end(), targets.begin(), targets.end());
    const int status = listen(command, std::ref(lines), [&] {
        tell_if_late();
        progress.tick();
    });
    if (one_at_a_time) unsetenv("TIMESTEP_BUILDS_IN");
    progress.clear();
    if (status == 0) return;
    for (const auto& line : reason(heard)) std::fprintf(stderr, "%s\n", line.c_str());
    throw Stop(Status::wrong, "the build failed; the lines above say why, the whole log is in " + log_path.string());
}

void make_ready(const std::vector<Exercise>& exercises, ProgressLine& progress) {
    if (std::getenv("COURSE_IS_BUILT") != nullptr) return;  // by the build that runs this check
    std::vector<std::string> targets;
    std::vector<fs::path> marks;
    for (const auto& exercise : exercises) {
        if (is_ready(exercise)) continue;
        targets.push_back("ready_" + exercise.name);
        marks.push_back(ready_mark(exercise));
    }
    if (targets.empty()) return;
    const auto begin = fs::file_time_type::clock::now();
    const std::string whose =
        targets.size() == 1 ? targets.front().substr(6) : std::to_string(targets.size()) + " exercises";
    build(targets, progress, "Building what a check of " + whose + " needs; at first that takes half a minute");
    mark_ready(marks, found_by(), begin);
}

std::string address_of(const fs::path& page) {
    std::string address = "file://";
    for (const char c : page.string()) {
        const auto byte = static_cast<unsigned char>(c);
        char coded[4];
        std::snprintf(coded, sizeof coded, "%%%02X", byte);
        const bool plain = byte < 0x80 && (std::isalnum(byte) || std::string("/-._~").find(c) != std::string::npos);
        address += plain ? std::string(1, c) : coded;
    }
    return address;
}

std::string site_address() {
    return address_of(is_kit() ? paths().source / "site/index.html" : paths().build / "site/html/index.html");
}

// CMake breaks an error into lines, indents them by two, and ends it with an empty line or a call stack; it puts two
// blanks before the second sentence.
std::string cmake_error(const std::string& said) {
    std::istringstream lines(said.substr(std::min(said.find("CMake Error"), said.size())));
    std::string words, line;
    std::getline(lines, line);
    if (line.starts_with("CMake Error: ")) words = line.substr(13);
    while (std::getline(lines, line) && !line.starts_with("Call Stack") &&
           (!line.empty() || words.empty() || words.ends_with(":")))
        if (const auto begin = line.find_first_not_of(' '); begin != std::string::npos)
            words += (words.empty() ? "" : " ") + line.substr(begin);
    return words.substr(0, words.find(".  "));
}

void configure() {
    const Lock one_at_a_time(paths().build / "course.lock", other_builds);
    std::string said;
    if (listen({paths().cmake, "-S", paths().source.string(), "-B", paths().build.string()},
               [&](std::string_view text) { said += text; }) == 0)
        return;
    const std::string error = cmake_error(said);
    throw Stop(Status::bad_use, error.empty() ? "CMake could not configure the build" : error);
}

}  // namespace course
