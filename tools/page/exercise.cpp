#include "exercise.hpp"

#include "error.hpp"
#include "json.hpp"
#include "scanner.hpp"
#include "text.hpp"

#include <algorithm>
#include <cctype>

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

/// TeX of a formula as tasks have it, `u = length v`: a name of several letters is one name.
std::string task_tex(const std::string& formula) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    std::string tex;
    for (std::size_t at = 0; at < formula.size();) {
        const char before = at > 0 ? formula[at - 1] : ' ';
        std::size_t end = at;
        while (end < formula.size() && is_letter(formula[end])) ++end;
        if (formula.compare(at, 5, "text{") == 0 && before == '\\') {
            end = std::min(formula.find('}', at), formula.size());
            tex += formula.substr(at, end - at);
        } else if (end > at + 1 && before != '\\') {
            tex += "\\mathit{" + formula.substr(at, end - at) + "}";
            if (end + 1 < formula.size() && formula[end] == ' ' &&
                (is_letter(formula[end + 1]) || formula[end + 1] == '('))
                tex += "\\,";
        } else if (end > at) {
            tex += formula.substr(at, end - at);
        } else {
            tex += formula[at] == '|' ? "\\vert " : formula.substr(at, 1);
            ++end;
        }
        at = end;
    }
    return tex;
}

/// Words of a task or a hint as Markdown: they hold formulas, `$h = 0.1$`, and code between backticks.
std::string markdown(const std::string& words) {
    std::string text;
    for (const Piece& piece : scan(words, "a task"))
        text += piece.kind == Piece::Kind::formula ? "\\f$" + task_tex(piece.text) + "\\f$"
                : piece.kind == Piece::Kind::code  ? piece.text
                                                   : escape_markdown(piece.text);
    return text;
}

/// A row of the table of what goes in and comes out: `h   length of the step, s`, where lines farther in go on.
std::string row(const std::string& words) {
    const auto end = words.find("  ");
    const auto meaning = words.find_first_not_of(' ', end);
    const bool is_named = end != std::string::npos && meaning != std::string::npos;
    return "| `" + words.substr(0, end) + "` | " + (is_named ? markdown(words.substr(meaning)) : "") + " |\n";
}

/// The comment that a file begins with, as Markdown: the title left out, since the section has it. What stands two
/// blanks in is a row of a table, what stands farther in is a formula.
std::string task(const fs::path& file) {
    enum { words, rows, formulas } inside = words;
    std::string text_so_far, pending;  // a row, or sentences: a formula may go over the end of a line
    const auto flush = [&] {
        if (!pending.empty()) text_so_far += inside == rows ? row(pending) : markdown(pending) + "\n";
        if (inside == formulas) text_so_far += "\\end{aligned}\\f]\n";
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
            text_so_far += (before == formulas ? "\\\\" : "\\f[\\begin{aligned}") +
                           ("&" + task_tex(std::string{trim(text)})) + "\n";
        } else if (inside == rows) {
            if (before != rows) text_so_far += "| name | what it is |\n|---|---|\n";
            pending += in == 2 ? text.substr(2) : " " + text.substr(in);
        } else if (text.empty()) {
            text_so_far += "\n";
        } else {
            pending += (pending.empty() ? "" : " ") + text;
        }
    }
    flush();
    return text_so_far;
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
        for (std::string& hint : exercise.hints) hint = markdown(hint);
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
