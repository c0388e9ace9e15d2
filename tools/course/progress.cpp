#include "progress.hpp"

#include <filesystem>
#include <sstream>

#include "paths.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

fs::path file() { return paths().source / ".progress" / "exercises.tsv"; }

}  // namespace

std::map<std::string, Remembered> read_progress() {
    std::map<std::string, Remembered> progress;
    std::error_code error;
    if (fs::status(file(), error).type() == fs::file_type::not_found) return progress;
    std::istringstream lines(contents(file()));
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line);
        std::string name, state, rest;
        Remembered remembered;
        if (!(words >> name >> state >> remembered.hints) || (words >> rest) ||
            (state != "passed" && state != "open") || remembered.hints < 0)
            throw Stop(Status::bad_use,
                       file().string() + ":" + std::to_string(number) + ": '" + line +
                           "' is not 'exercise, passed or open, number of hints'. Delete the line or the "
                           "file; ./course check then marks the exercises that pass again");
        remembered.passed = state == "passed";
        progress[name] = remembered;
    }
    return progress;
}

void change_progress(const std::function<void(std::map<std::string, Remembered>&)>& change) {
    std::error_code error;
    fs::create_directories(file().parent_path(), error);
    const Lock lock(file().parent_path() / "lock",
                    "Another ./course is writing in .progress; this goes on when it has done");
    auto progress = read_progress();
    change(progress);
    std::string text;
    for (const auto& [name, remembered] : progress)
        text += name + '\t' + (remembered.passed ? "passed" : "open") + '\t' + std::to_string(remembered.hints) + '\n';
    write_whole(file(), text);
}

std::string state_of(const Exercise& exercise, const std::map<std::string, Remembered>& progress) {
    const auto found = progress.find(exercise.name);
    if (found != progress.end() && found->second.passed) return "passed";
    std::error_code error;
    if (!fs::exists(exercise.file(), error) || !fs::exists(exercise.stub(), error)) return "not started";
    return untouched(exercise) ? "not started" : "started";
}

}  // namespace course
