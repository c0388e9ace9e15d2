#include "chapter.hpp"

#include "error.hpp"
#include "json.hpp"
#include "text.hpp"

#include <algorithm>
#include <cctype>

namespace page {
namespace {

std::string one(const Json& about, const std::string& key, const std::string& file) {
    const auto found = about.find(key);
    if (found == about.end() || found->second.size() != 1 || found->second.front().empty()) {
        throw Error{file, 1, "\"" + key + "\" must be a string"};
    }
    return found->second.front();
}

std::vector<std::string> list(const Json& about, const std::string& key) {
    const auto found = about.find(key);
    return found == about.end() ? std::vector<std::string>{} : found->second;
}

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
            if (entry.is_directory() && is_chapter(folder)) {
                folders.push_back(folder);
            }
        }
    }
    std::sort(folders.begin(), folders.end());

    std::vector<Chapter> chapters;
    for (const std::string& folder : folders) {
        Chapter chapter{};
        chapter.folder = folder;
        chapter.number = std::stoi(folder.substr(0, 2));
        const std::string file = chapter.about();
        const Json about = parse_json(read_file(root / file), file);
        chapter.title = one(about, "title", file);
        chapter.question = one(about, "question", file);
        chapter.picture = one(about, "picture", file);
        chapter.builds_on = list(about, "builds_on");
        chapter.claims = list(about, "claims");
        chapter.figures = list(about, "figures");
        if (chapter.figures.empty()) {
            chapter.figures = {chapter.picture};
        }
        chapter.has_more = std::filesystem::exists(root / chapter.source(true));
        for (const std::string& row : chapter.claims) {
            if (!is_row(row)) {
                throw Error{file, 1, "\"" + row + "\" is no claim (N or I and two digits)"};
            }
        }
        chapters.push_back(chapter);
    }
    return chapters;
}

}  // namespace page
