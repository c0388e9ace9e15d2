// Exercises on the pages: from their about.json, and the comment that their solution begins with.

#include "directives.hpp"
#include "text.hpp"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

namespace page {
namespace {

namespace fs = std::filesystem;

/// One exercise, as its about.json and its file tell it.
struct Exercise {
    std::string name, chapter;  ///< `velocity_now`, `01_derivatives`
    int number;                 ///< its place in the chapter
    std::string title, level, practises, declaration;
    std::vector<std::string> hints;  ///< as Markdown
    std::string task;                ///< the comment that its file begins with, as Markdown

    /// `1.2`
    std::string place() const { return std::to_string(std::stoi(chapter.substr(0, 2))) + "." + std::to_string(number); }
    /// The id of its section on the page of the exercises.
    std::string id() const { return "exercise_" + name; }
};

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
        if (line.rfind("//", 0) != 0) break;
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

/// Every exercise of a chapter, in order. Throws Error for a faulty about.json.
std::vector<Exercise> load_exercises(Context& context, const std::string& chapter) {
    const fs::path& root = context.root();
    std::vector<Exercise> exercises;
    const fs::path folder = root / "tests/exercises" / chapter;
    if (!fs::is_directory(folder)) return exercises;
    for (const auto& room : fs::directory_iterator{folder}) {
        const fs::path about = room.path() / "about.json";
        if (!fs::exists(about)) continue;
        Exercise exercise{};
        exercise.name = room.path().filename().string();
        exercise.chapter = chapter;
        read_about(root, fs::proximate(about, root).generic_string(), [&exercise](const nlohmann::json& json) {
            exercise.number = json.at("number");
            exercise.title = json.at("title");
            exercise.level = json.at("level");
            exercise.practises = json.at("practises");
            exercise.declaration = json.at("declaration");
            for (const std::string hint : json.at("hints")) exercise.hints.push_back(markdown(hint));
        });
        const fs::path solution = root / "solutions" / chapter / (exercise.name + ".cpp");
        exercise.task = task(solution);
        context.inputs.insert({about, solution});
        exercises.push_back(exercise);
    }
    std::sort(exercises.begin(), exercises.end(),
              [](const Exercise& a, const Exercise& b) { return a.number < b.number; });
    return exercises;
}

std::string quoted(const std::string& text) { return "\"" + replace_all(text, "\"", "'") + "\""; }

/// On a chapter's page: one line each, with the way to the task.
std::string in_brief(const std::vector<Exercise>& exercises) {
    if (exercises.empty()) return {};
    std::string table = "\n| | exercise | practises | level |\n|---|---|---|---|\n";
    for (const Exercise& exercise : exercises) {
        table += "| " + exercise.place() + " | \\ref " + exercise.id() + " " + quoted(exercise.title) + " | " +
                 escape_markdown(exercise.practises) + " | " + exercise.level + " |\n";
    }
    return table;
}

/// A declaration; a long one has a line for each parameter, which a narrow page does not cut.
std::string in_lines(const std::string& declaration) {
    if (declaration.size() <= 40) return declaration;
    std::string text;
    int brackets = 0;  // in those of a template a comma parts no parameters
    for (const char character : declaration) {
        brackets += (character == '<') - (character == '>');
        if (character == ' ' && text.ends_with(",") && brackets == 0) {
            text += "\n    ";
        } else {
            text += character;
        }
        if (character == '(') text += "\n    ";
    }
    return text;
}

std::string in_full(const Exercise& exercise) {
    std::string text = "\n## " + exercise.place() + " " + exercise.title + " {#" + exercise.id() + "}\n\n*" +
                       exercise.level + "; practises " + escape_markdown(exercise.practises) + "*\n\n```cpp\n" +
                       in_lines(exercise.declaration) + "\n```\n\n" + exercise.task + "\nYour file is `exercises/" +
                       exercise.chapter + "/" + exercise.name + ".cpp`; `./course check " + exercise.name +
                       "` checks it.\n";
    for (std::size_t i = 0; i < exercise.hints.size(); ++i) {
        text += "\n\\htmlonly[block]<details class=\"hint\"><summary>Hint " + std::to_string(i + 1) +
                "</summary>\\endhtmlonly\n" + exercise.hints[i] + "\n\\htmlonly[block]</details>\\endhtmlonly\n";
    }
    return text;
}

}  // namespace

/// The exercises of a chapter go on a page of their own; this one leads there.
std::string exercises_markdown(Context& context, const Directive&) {
    if (context.chapter() != nullptr) return in_brief(load_exercises(context, context.chapter()->folder));
    std::string text;
    for (const Chapter& chapter : context.chapters()) {
        const auto exercises = load_exercises(context, chapter.folder);
        if (exercises.empty()) continue;
        const std::string id = "exercises_" + std::to_string(chapter.number);
        std::string page = "# Exercises: " + chapter.heading() + " {#" + id +
                           "}\n\n[TOC]\n\nWhat they need is in chapter \\ref " + chapter.id() + " " +
                           quoted(chapter.heading()) +
                           "; how they are done and checked, in \\ref exercises_how \"How it works\".\n";
        for (const Exercise& exercise : exercises) page += in_full(exercise);
        context.pages[id + ".md"] = page;
        text += "\n<b>\\subpage " + id + " " + quoted(chapter.heading()) + "</b>\n" + in_brief(exercises);
    }
    return text;
}

int number_of_exercises(Context& context, const Chapter& chapter) {
    return static_cast<int>(load_exercises(context, chapter.folder).size());
}

}  // namespace page
