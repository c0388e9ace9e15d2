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
std::string row(const std::string& words, const std::set<std::string>& names) {
    const auto end = words.find("  ");
    const auto meaning = words.find_first_not_of(' ', end);
    if (end == std::string::npos || meaning == std::string::npos) {
        return "| `" + words + "` | ";
    }
    return "| `" + words.substr(0, end) + "` | " + with_formulas(words.substr(meaning), names);
}

/// The comment that a file begins with, as Markdown: the title left out, since the section has it. What stands two
/// blanks in is a row of a table, what stands farther in is a formula.
std::string task(const fs::path& file, const std::set<std::string>& names) {
    enum { words, rows, formulas } inside = words;
    std::string markdown, pending;  // a row, or sentences: a formula may go over the end of a line
    const auto flush = [&] {
        if (!pending.empty())
            markdown += inside == rows ? row(pending, names) + " |\n" : with_formulas(pending, names) + "\n";
        if (inside == formulas) markdown += "\\end{aligned}\\f]\n";
        pending.clear();
    };
    bool title = true;
    for (const std::string& line : split_lines(read_file(file))) {
        if (line.rfind("//", 0) != 0) {
            break;
        }
        const std::string text = line.substr(std::min<std::size_t>(line.size(), 3));
        if (title) {
            title = false;
            continue;
        }
        const std::size_t in = std::min(text.find_first_not_of(' '), text.size());
        const auto before = inside, now = in < 2 ? words : in == 2 || before == rows ? rows : formulas;
        if (now != before || in == 2 || text.empty()) flush();
        inside = now;
        if (inside == formulas) {
            markdown += (before == formulas ? "\\\\" : "\\f[\\begin{aligned}") +
                        ("&" + formula_tex(std::string{trim(text)})) + "\n";
        } else if (inside == rows) {
            if (before != rows) markdown += "| name | what it is |\n|---|---|\n";
            pending += in == 2 ? text.substr(2) : " " + text.substr(in);
        } else if (text.empty()) {
            markdown += "\n";
        } else {
            pending += (pending.empty() ? "" : " ") + text;
        }
    }
    flush();
    return markdown;
}

}  // namespace

std::string Exercise::place() const {
    return std::to_string(std::stoi(chapter.substr(0, 2))) + "." + std::to_string(number);
}

std::vector<Exercise> load_exercises(const fs::path& root, const std::string& chapter, std::vector<fs::path>& inputs) {
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
        const std::set<std::string> names = names_in(exercise.declaration);
        for (std::string& hint : exercise.hints) hint = with_formulas(hint, names);
        const fs::path solution = root / "solutions" / chapter / (exercise.name + ".cpp");
        exercise.task = task(solution, names);
        inputs.push_back(about);
        inputs.push_back(solution);
        exercises.push_back(exercise);
    }
    std::sort(exercises.begin(), exercises.end(),
              [](const Exercise& a, const Exercise& b) { return a.number < b.number; });
    return exercises;
}

}  // namespace page
