// course list

#include <cstdio>

#include <nlohmann/json.hpp>

#include "chapters.hpp"
#include "commands.hpp"
#include "progress.hpp"
#include "terminal.hpp"

namespace course {

void list(bool json) {
    const auto progress = read_progress();
    if (json) {
        nlohmann::ordered_json chapters = nlohmann::ordered_json::array();
        for (const auto& chapter : read_chapters())
            chapters.push_back({{"chapter", chapter.folder},
                                {"title", chapter.title},
                                {"question", chapter.question},
                                {"program", chapter.program},
                                {"figures", chapter.figures},
                                {"claims", chapter.claims}});
        nlohmann::ordered_json exercises = nlohmann::ordered_json::array();
        for (const auto& exercise : read_exercises())
            exercises.push_back({{"exercise", exercise.name},
                                 {"chapter", exercise.chapter},
                                 {"title", exercise.title},
                                 {"level", exercise.level},
                                 {"practises", exercise.practises},
                                 {"state", state_of(exercise, progress)},
                                 {"file", exercise.file().string()}});
        std::printf("%s\n", nlohmann::ordered_json{{"chapters", chapters}, {"exercises", exercises}}.dump(2).c_str());
        return;
    }
    const auto exercises = read_exercises();
    for (const auto& chapter : read_chapters()) {
        std::printf("%s  %s\n    %s\n    ./course run %d   chapters/%s\n\n", chapter.folder.substr(0, 2).c_str(),
                    bold(chapter.title).c_str(), chapter.question.c_str(), chapter.number(), chapter.folder.c_str());
        bool any = false;
        for (const auto& exercise : exercises) {
            if (exercise.chapter != chapter.folder) continue;
            const std::string state = state_of(exercise, progress);
            std::printf("    %s %s  %s  %s  %s\n",
                        state == "passed"    ? "✓"
                        : state == "started" ? "…"
                                             : "·",
                        exercise.place().c_str(), padded(exercise.name, 24).c_str(), padded(exercise.level, 10).c_str(),
                        exercise.title.c_str());
            any = true;
        }
        if (any) std::printf("\n");
    }
    if (exercises.empty()) return;
    std::size_t passed = 0;
    for (const auto& exercise : exercises) passed += state_of(exercise, progress) == "passed";
    std::printf(
        "%zu of %zu exercises passed. Their files are in exercises/; ./course check NAME checks "
        "one.\n",
        passed, exercises.size());
}

}  // namespace course
