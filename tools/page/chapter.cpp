#include "chapter.hpp"

#include "text.hpp"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

namespace page {
namespace {

/// Chapters live in folders like 03_euler_variants.
bool is_chapter(const std::string& folder) {
    const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(folder[i])) != 0; };
    return folder.size() > 3 && digit(0) && digit(1) && folder[2] == '_';
}

}  // namespace

std::string Chapter::id(bool more) const { return (more ? "more_" : "chapter_") + folder.substr(0, 2); }

std::string Chapter::section_prefix(bool more) const { return (more ? "more" : "ch") + std::to_string(number) + "_"; }

std::string Chapter::source(bool more) const { return "chapters/" + folder + (more ? "/more.md" : "/chapter.md"); }

std::string Chapter::heading() const { return std::to_string(number) + " · " + title; }

std::string Chapter::program() const { return "chapters/" + folder + "/" + folder.substr(3) + ".cpp"; }

std::string Chapter::about() const { return "chapters/" + folder + "/about.json"; }

std::vector<Chapter> load_chapters(const std::filesystem::path& root) {
    std::vector<std::string> folders;
    if (std::filesystem::is_directory(root / "chapters")) {
        for (const auto& entry : std::filesystem::directory_iterator{root / "chapters"}) {
            const std::string folder = entry.path().filename().string();
            if (entry.is_directory() && is_chapter(folder)) folders.push_back(folder);
        }
    }
    std::sort(folders.begin(), folders.end());

    std::vector<Chapter> chapters;
    for (const std::string& folder : folders) {
        Chapter chapter{};
        chapter.folder = folder;
        chapter.number = std::stoi(folder.substr(0, 2));
        const std::string file = chapter.about();
        const nlohmann::json about = read_json(root / file, file);
        chapter.title = required(about, "title", file);
        chapter.question = required(about, "question", file);
        chapter.picture = required(about, "picture", file);
        chapter.builds_on = strings(about, "builds_on", file);
        chapter.claims = strings(about, "claims", file);
        chapter.figures = strings(about, "figures", file);
        if (chapter.figures.empty()) chapter.figures = {chapter.picture};
        chapter.has_more = std::filesystem::exists(root / chapter.source(true));
        for (const std::string& row : chapter.claims) {
            if (!is_row(row)) throw Error{file, 1, "\"" + row + "\" is no claim (N or I and two digits)"};
        }
        chapters.push_back(chapter);
    }
    return chapters;
}

nlohmann::json read_json(const std::filesystem::path& path, const std::string& file) {
    const std::string text = read_file(path);
    try {
        nlohmann::json json = nlohmann::json::parse(text);
        if (!json.is_object()) throw Error{file, 1, "must be an object: { … }"};
        return json;
    } catch (const nlohmann::json::parse_error& wrong) {
        const std::size_t before = std::min(wrong.byte == 0 ? 0 : wrong.byte - 1, text.size());
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(before);
        throw Error{file, 1 + static_cast<int>(std::count(text.begin(), end, '\n')), wrong.what()};
    }
}

std::string required(const nlohmann::json& about, const std::string& key, const std::string& file) {
    const auto found = about.find(key);
    if (found == about.end() || !found->is_string() || found->get<std::string>().empty())
        throw Error{file, 1, "\"" + key + "\" must be a string"};
    return *found;
}

std::vector<std::string> strings(const nlohmann::json& about, const std::string& key, const std::string& file) {
    const nlohmann::json list = about.value(key, nlohmann::json::array());
    if (!list.is_array() || !std::all_of(list.begin(), list.end(), [](const auto& one) { return one.is_string(); }))
        throw Error{file, 1, "\"" + key + "\" must be a list of strings"};
    return list;
}

}  // namespace page
