// What the pages say of the exercises.

#include "directives.hpp"
#include "exercise.hpp"
#include "text.hpp"

namespace page {
namespace {

std::string quoted(const std::string& text) {
    return "\"" + replace_all(text, "\"", "'") + "\"";
}

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

std::string in_full(const Exercise& exercise) {
    std::string text = "\n### " + exercise.place() + " " + exercise.title + " {#" + exercise.id() + "}\n\n*" +
                       exercise.level + "; practises " + escape_markdown(exercise.practises) + "*\n\n```cpp\n" +
                       exercise.declaration + "\n```\n\n" + exercise.task +
                       "\nYour file is `exercises/" + exercise.chapter + "/" + exercise.name +
                       ".cpp`; `./course check " + exercise.name + "` checks it.\n";
    for (std::size_t i = 0; i < exercise.hints.size(); ++i) {
        text += "\n\\htmlonly[block]<details class=\"hint\"><summary>Hint " + std::to_string(i + 1) +
                "</summary>\\endhtmlonly\n" + escape_markdown(exercise.hints[i]) +
                "\n\\htmlonly[block]</details>\\endhtmlonly\n";
    }
    return text;
}

}  // namespace

std::string exercises_markdown(Context& context) {
    std::string text;
    std::vector<std::filesystem::path> inputs;
    if (context.chapter() != nullptr) {
        text = in_brief(load_exercises(context.root(), context.chapter()->folder, inputs));
    } else {
        for (const Chapter& chapter : context.chapters()) {
            const auto exercises = load_exercises(context.root(), chapter.folder, inputs);
            if (!exercises.empty()) {
                text += "\n## " + chapter.heading() + " {#exercises_" + std::to_string(chapter.number) + "}\n";
            }
            for (const Exercise& exercise : exercises) {
                text += in_full(exercise);
            }
        }
    }
    context.inputs.insert(inputs.begin(), inputs.end());
    return text;
}

}  // namespace page
