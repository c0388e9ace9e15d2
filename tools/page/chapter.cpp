#include "chapter.hpp"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

#include "text.hpp"

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
        using Words = std::vector<std::string>;
        read_about(root, file, [&chapter](const nlohmann::json& about) {
            chapter.title = about.at("title");
            chapter.question = about.at("question");
            chapter.picture = about.at("picture");
            chapter.builds_on = about.value("builds_on", Words{});
            chapter.claims = about.value("claims", Words{});
            chapter.figures = about.value("figures", Words{chapter.picture});
        });
        chapter.has_more = std::filesystem::exists(root / chapter.source(true));
        for (const std::string& row : chapter.claims) {
            if (!is_row(row)) throw Error{file, 1, "\"" + row + "\" is no claim (N or I and two digits)"};
        }
        chapters.push_back(chapter);
    }
    return chapters;
}

void read_about(const std::filesystem::path& root, const std::string& file,
                const std::function<void(const nlohmann::json&)>& read) {
    try {
        read(nlohmann::json::parse(read_file(root / file)));
    } catch (const nlohmann::json::exception& wrong) {
        throw Error{file, 1, wrong.what()};
    }
}

}  // namespace page
