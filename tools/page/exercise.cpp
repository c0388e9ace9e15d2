#include "exercise.hpp"

#include "error.hpp"
#include "json.hpp"
#include "text.hpp"

#include <algorithm>

namespace page {
namespace {

namespace fs = std::filesystem;

std::string required(const Json& about, const std::string& key, const std::string& file) {
    const auto found = about.find(key);
    if (found == about.end() || found->second.size() != 1 || found->second.front().empty()) {
        throw Error{file, 1, "\"" + key + "\" is missing"};
    }
    return found->second.front();
}

/// A row of the table of what goes in and comes out: `h   length of the step, s`, where lines farther in go on.
std::string row(const std::string& words) {
    const auto end = words.find("  ");
    const auto meaning = words.find_first_not_of(' ', end);
    if (end == std::string::npos || meaning == std::string::npos) {
        return "| `" + words + "` | ";
    }
    return "| `" + words.substr(0, end) + "` | " + escape_markdown(words.substr(meaning));
}

/// The comment that a file begins with, as Markdown: the title left out, since the section has it. What stands two
/// blanks in is a row of a table, what stands farther in is a formula.
std::string task(const fs::path& file) {
    enum { words, rows, formulas } inside = words;
    std::string markdown;
    bool title = true;
    for (const std::string& line : split_lines(read_file(file))) {
        if (line.rfind("//", 0) != 0) {
            break;
        }
        const std::string text = line.substr(std::min<std::size_t>(line.size(), 3));
        const std::size_t in = std::min(text.find_first_not_of(' '), text.size());
        const auto before = inside;
        inside = in < 2 ? words : in == 2 || before == rows ? rows : formulas;
        if (before == formulas && inside != formulas) {
            markdown += "\\end{aligned}\\f]\n";
        } else if (before == rows && inside != rows) {
            markdown += " |\n";
        }
        if (title) {
            title = false;
        } else if (inside == words) {
            markdown += escape_markdown(text) + "\n";
        } else if (inside == formulas) {
            markdown += (before == formulas ? "\\\\" : "\\f[\\begin{aligned}") + ("&" + formula_tex(std::string{trim(text)})) + "\n";
        } else if (in == 2) {
            markdown += (before == rows ? " |\n" : "| name | what it is |\n|---|---|\n") + row(text.substr(2));
        } else {
            markdown += " " + escape_markdown(text.substr(in));
        }
    }
    return markdown + (inside == formulas ? "\\end{aligned}\\f]\n" : inside == rows ? " |\n" : "");
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
        exercise.number = std::stoi(required(json, "number", file));
        exercise.title = required(json, "title", file);
        exercise.level = required(json, "level", file);
        exercise.practises = required(json, "practises", file);
        exercise.declaration = required(json, "declaration", file);
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
