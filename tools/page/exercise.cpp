#include "exercise.hpp"

#include "error.hpp"
#include "json.hpp"
#include "text.hpp"

#include <algorithm>

namespace page {
namespace {

namespace fs = std::filesystem;

std::string one(const Json& about, const std::string& key, const std::string& file) {
    const auto found = about.find(key);
    if (found == about.end() || found->second.size() != 1 || found->second.front().empty()) {
        throw Error{file, 1, "\"" + key + "\" is missing"};
    }
    return found->second.front();
}

/// The comment that a file begins with, as Markdown: the title left out, since the section has it;
/// what is indented stands as it is.
std::string task(const fs::path& file) {
    std::string markdown;
    bool title = true, listing = false;
    for (const std::string& line : split_lines(read_file(file))) {
        if (line.rfind("//", 0) != 0) {
            break;
        }
        const std::string words = line.substr(std::min<std::size_t>(line.size(), 3));
        const bool indented = words.rfind("  ", 0) == 0;
        if (indented != listing) {
            markdown += "```\n";
        }
        if (!title) {
            markdown += (indented ? words.substr(2) : escape_markdown(words)) + "\n";
        }
        listing = indented;
        title = false;
    }
    return markdown + (listing ? "```\n" : "");
}

}  // namespace

std::string Exercise::place() const {
    return std::to_string(std::stoi(chapter.substr(0, 2))) + "." + std::to_string(number);
}

std::vector<Exercise> load_exercises(const fs::path& root, const std::string& chapter,
                                     std::vector<fs::path>& inputs) {
    std::vector<Exercise> exercises;
    const fs::path folder = root / "tests/exercises" / chapter;
    if (!fs::is_directory(folder)) {
        return exercises;
    }
    for (const auto& room : fs::directory_iterator{folder}) {
        const fs::path about = room.path() / "about.json";
        if (!fs::exists(about)) {
            continue;
        }
        Exercise exercise{};
        exercise.name = room.path().filename().string();
        exercise.chapter = chapter;
        const std::string file = fs::proximate(about, root).generic_string();
        const Json json = parse_json(read_file(about), file);
        exercise.number = std::stoi(one(json, "number", file));
        exercise.title = one(json, "title", file);
        exercise.level = one(json, "level", file);
        exercise.practises = one(json, "practises", file);
        exercise.declaration = one(json, "declaration", file);
        const auto hints = json.find("hints");
        if (hints != json.end()) {
            exercise.hints = hints->second;
        }
        const fs::path solution = root / "solutions" / chapter / (exercise.name + ".cpp");
        exercise.task = task(solution);
        inputs.push_back(about);
        inputs.push_back(solution);
        exercises.push_back(exercise);
    }
    std::sort(exercises.begin(), exercises.end(),
              [](const Exercise& a, const Exercise& b) { return a.number < b.number; });
    return exercises;
}

}  // namespace page
