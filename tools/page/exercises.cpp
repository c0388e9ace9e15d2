// What the pages say of the exercises.

#include "directives.hpp"
#include "exercise.hpp"
#include "text.hpp"

namespace page {
namespace {

std::string quoted(const std::string& text) { return "\"" + replace_all(text, "\"", "'") + "\""; }

/// On a chapter's page: one line each, with the way to the task.
std::string in_brief(const std::vector<Exercise>& exercises) {
    if (exercises.empty()) {
        return {};
    }
    std::string table = "\n| | exercise | practises | level |\n|---|---|---|---|\n";
    for (const Exercise& exercise : exercises) {
        table += "| " + exercise.place() + " | \\ref " + exercise.id() + " " + quoted(exercise.title) + " | " +
                 escape_markdown(exercise.practises) + " | " + exercise.level + " |\n";
    }
    return table;
}

/// A declaration; a long one has a line for each parameter, which a narrow page does not cut.
std::string in_lines(const std::string& declaration) {
    if (declaration.size() <= 40) {
        return declaration;
    }
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
std::string exercises_markdown(Context& context) {
    std::string text;
    std::vector<std::filesystem::path> inputs;
    if (context.chapter() != nullptr) {
        text = in_brief(load_exercises(context.root(), context.chapter()->folder, inputs));
    } else {
        for (const Chapter& chapter : context.chapters()) {
            const auto exercises = load_exercises(context.root(), chapter.folder, inputs);
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
    }
    context.inputs.insert(inputs.begin(), inputs.end());
    return text;
}

}  // namespace page
