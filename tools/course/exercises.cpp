#include "exercises.hpp"

#include <algorithm>
#include <tuple>

#include <nlohmann/json.hpp>

#include "terminal.hpp"
#include "paths.hpp"
#include "stop.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

fs::path told_of_all() { return paths().source / (is_kit() ? "kit/about" : "tests/exercises"); }

Exercise read_exercise(const fs::path& about) {
    const fs::path folder = about.parent_path();
    try {
        const auto json = nlohmann::json::parse(contents(about));
        Exercise exercise;
        exercise.name = folder.filename().string();
        exercise.chapter = folder.parent_path().filename().string();
        exercise.number = json.at("number");
        exercise.title = json.at("title");
        exercise.level = json.at("level");
        exercise.practises = json.at("practises");
        exercise.declaration = json.at("declaration");
        exercise.eigen = json.at("eigen");
        exercise.hints = json.at("hints");
        exercise.learned = json.at("learned");
        return exercise;
    } catch (const nlohmann::json::exception& error) {
        throw Stop(Status::bad_use, about.string() + ": " + error.what());
    }
}

}  // namespace

std::string Exercise::place() const {
    return std::to_string(std::stoi(chapter.substr(0, 2))) + "." + std::to_string(number);
}
fs::path Exercise::file() const { return paths().source / "exercises" / chapter / (name + ".cpp"); }
fs::path Exercise::stub() const {
    // A learner's edition brings it, configured or not.
    return (is_kit() ? paths().source / "kit/generated" : paths().build / "exercises/generated") / (name + "_stub.cpp");
}
fs::path Exercise::about() const { return told_of_all() / chapter / name / "about.json"; }
fs::path Exercise::told() const { return paths().build / "exercises/generated" / (name + "_mistakes.json"); }
std::map<std::string, Misconception> Exercise::mistakes() const {
    const fs::path file = told();
    try {
        std::map<std::string, Misconception> known;
        const auto json = nlohmann::json::parse(contents(file));
        for (const auto& [mistake, words] : json.items()) known[mistake] = {words.at("says"), words.at("hint")};
        return known;
    } catch (const nlohmann::json::exception& error) {
        throw Stop(Status::bad_use, file.string() + ": " + error.what());
    }
}
fs::path Exercise::declared() const { return paths().build / "exercises/generated" / (name + "_declared.hpp"); }
fs::path Exercise::solution() const {
    return paths().source / (is_kit() ? "kit/solutions" : "solutions") / chapter / (name + ".cpp");
}
bool Exercise::has_solution() const {
    std::error_code ignored;
    return fs::exists(solution(), ignored);
}

bool is_kit() { return fs::exists(paths().source / "kit/kit.json"); }

std::vector<Exercise> read_exercises() {
    std::vector<Exercise> exercises;
    const fs::path all = told_of_all();
    if (!fs::exists(all)) return exercises;
    for (const auto& chapter : fs::directory_iterator(all)) {
        if (!chapter.is_directory()) continue;
        for (const auto& room : fs::directory_iterator(chapter))
            if (fs::exists(room.path() / "about.json")) exercises.push_back(read_exercise(room.path() / "about.json"));
    }
    std::sort(exercises.begin(), exercises.end(), [](const Exercise& a, const Exercise& b) {
        return std::tie(a.chapter, a.number, a.name) < std::tie(b.chapter, b.number, b.name);
    });
    return exercises;
}

std::optional<Exercise> exercise_of(const std::string& name) {
    std::error_code ignored;
    const fs::path meant = fs::weakly_canonical(name, ignored);
    for (const auto& exercise : read_exercises())
        if (name == exercise.name || name == exercise.place() ||
            meant == fs::weakly_canonical(exercise.file(), ignored))
            return exercise;
    return {};
}

Exercise find_exercise(const std::string& name) {
    if (const auto exercise = exercise_of(name)) return *exercise;
    std::vector<std::string> names;
    std::string of_chapter;
    for (const auto& exercise : read_exercises()) {
        names.push_back(exercise.name);
        if (exercise.place().starts_with(name + ".")) of_chapter += (of_chapter.empty() ? "" : ", ") + exercise.place();
    }
    if (!of_chapter.empty())
        throw Stop(Status::bad_use, "'" + name + "' is a chapter; its exercises are " + of_chapter);
    const fs::path file(name);
    const std::string near = nearest(file.extension() == ".cpp" ? file.stem().string() : name, names);
    throw Stop(Status::bad_use, "'" + sanitized_line(shortened(name, 100)) + "' is no exercise; " +
                                    (near.empty() ? "./course list shows them"
                                                  : "the nearest is " + near + " (./course list shows them)"));
}

// A file that cannot be read, as a link that leads nowhere, counts as the learner's own.
bool untouched(const Exercise& exercise) {
    try {
        return contents(exercise.file()) == contents(exercise.stub());
    } catch (const Stop&) {
        return false;
    }
}

std::string answer_in(const Exercise& exercise, const fs::path& file) {
    std::error_code ignored;
    if (file == exercise.file() && !fs::exists(file, ignored))
        throw Stop(Status::bad_use, shown(file) + " is not there; ./course reset " + exercise.name + " brings it back");
    return contents(file);
}

}  // namespace course
