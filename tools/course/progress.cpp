#include "progress.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "places.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

fs::path file() {
    return places().source / ".progress" / "exercises.tsv";
}

}  // namespace

std::map<std::string, Remembered> read_progress() {
    std::map<std::string, Remembered> progress;
    if (!fs::exists(file())) return progress;
    std::istringstream lines(contents(file()));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line);
        std::string name, state, rest;
        Remembered remembered;
        if (!(words >> name >> state >> remembered.hints) || (words >> rest) ||
            (state != "passed" && state != "open") || remembered.hints < 0)
            throw Stop(Status::bad_use, file().string() + ":" + std::to_string(number) + ": '" +
                                            line +
                                            "' is not 'exercise, passed or open, number of hints'");
        remembered.passed = state == "passed";
        progress[name] = remembered;
    }
    return progress;
}

// Written beside and then moved, so that a full disk costs nothing.
void write_progress(const std::map<std::string, Remembered>& progress) {
    std::error_code error;
    fs::create_directories(file().parent_path(), error);
    const fs::path fresh = file().string() + ".new";
    {
        std::ofstream out(fresh);
        for (const auto& [name, remembered] : progress)
            out << name << '\t' << (remembered.passed ? "passed" : "open") << '\t'
                << remembered.hints << '\n';
        out.close();
        if (!out) {
            fs::remove(fresh, error);
            throw Stop(Status::bad_use, file().string() + ": cannot be written");
        }
    }
    fs::rename(fresh, file(), error);
    if (error) throw Stop(Status::bad_use, file().string() + ": " + error.message());
}

std::string state_of(const Exercise& exercise, const std::map<std::string, Remembered>& progress) {
    const auto found = progress.find(exercise.name);
    if (found != progress.end() && found->second.passed) return "passed";
    std::error_code error;
    if (!fs::exists(exercise.file(), error) || !fs::exists(exercise.stub(), error))
        return "not started";
    return contents(exercise.file()) == contents(exercise.stub()) ? "not started" : "started";
}

}  // namespace course
