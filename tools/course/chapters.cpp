#include "chapters.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "files.hpp"
#include "paths.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace fs = std::filesystem;

namespace {

bool is_number_sign(char c) { return c >= '0' && c <= '9'; }

// A chapter's folder is two digits, an underscore and the name of its program.
bool is_chapter(const std::string& folder) {
    return folder.size() > 3 && is_number_sign(folder[0]) && is_number_sign(folder[1]) && folder[2] == '_';
}

Chapter read_chapter(const fs::path& folder) {
    const fs::path about = folder / "about.json";
    const std::string name = folder.filename().string();
    try {
        const auto json = nlohmann::json::parse(contents(about));
        const std::string picture = json.at("picture");
        return {name,
                name.substr(3),
                json.at("title"),
                json.at("question"),
                picture,
                json.value("figures", std::vector{picture}),
                json.value("claims", std::vector<std::string>())};
    } catch (const nlohmann::json::exception& error) {
        throw Stop(Status::bad_use, about.string() + ": " + error.what());
    }
}

}  // namespace

int Chapter::number() const { return std::stoi(folder.substr(0, 2)); }
fs::path Chapter::sources() const { return paths().source / "chapters" / folder; }
bool Chapter::has_study() const { return fs::exists(sources() / "study/figures.gp"); }
fs::path Chapter::run() const { return paths().build / "chapters" / folder / "run"; }

std::vector<Chapter> read_chapters() {
    std::vector<Chapter> chapters;
    for (const auto& entry : fs::directory_iterator(paths().source / "chapters"))
        if (is_chapter(entry.path().filename().string())) chapters.push_back(read_chapter(entry));
    std::sort(chapters.begin(), chapters.end(), [](const Chapter& a, const Chapter& b) { return a.folder < b.folder; });
    return chapters;
}

std::optional<Chapter> chapter_of(const std::string& name) {
    for (const auto& chapter : read_chapters()) {
        for (const auto& meant :
             {std::to_string(chapter.number()), chapter.folder.substr(0, 2), chapter.program, chapter.folder})
            if (name == meant) return chapter;
        if ((name + "/").starts_with("chapters/" + chapter.folder + "/")) return chapter;  // or a file of its own
    }
    return {};
}

Chapter find_chapter(const std::string& name) {
    if (const auto chapter = chapter_of(name)) return *chapter;
    std::string known;
    for (const auto& chapter : read_chapters())
        known += (known.empty() ? "" : ", ") + std::to_string(chapter.number()) + " " + chapter.program;
    throw Stop(Status::bad_use, "'" + sanitized_line(name) + "' is no chapter; there are " + known);
}

}  // namespace course
