// course list

#include <cstdio>

#include <nlohmann/json.hpp>

#include "chapters.hpp"
#include "commands.hpp"
#include "terminal.hpp"

namespace course {

void list(bool json) {
    if (json) {
        nlohmann::ordered_json chapters = nlohmann::ordered_json::array();
        for (const auto& chapter : read_chapters())
            chapters.push_back({{"chapter", chapter.folder},
                                {"title", chapter.title},
                                {"question", chapter.question},
                                {"program", chapter.program},
                                {"figures", chapter.figures},
                                {"rows", chapter.rows}});
        std::printf("%s\n", nlohmann::ordered_json{{"chapters", chapters}}.dump(2).c_str());
        return;
    }
    for (const auto& chapter : read_chapters())
        std::printf("%s  %s\n    %s\n    ./course run %d   chapters/%s\n\n",
                    chapter.folder.substr(0, 2).c_str(), bold(chapter.title).c_str(),
                    chapter.question.c_str(), chapter.number(), chapter.folder.c_str());
}

}  // namespace course
