#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace page {

/// One chapter, as its about.json tells it.
struct Chapter {
    std::string folder;    ///< `03_euler_variants`
    int number;            ///< 3
    std::string title;     ///< `Three ways to take a step`
    std::string question;  ///< in a game programmer's words
    std::string picture;  ///< one of the figures: what its program draws
    std::vector<std::string> builds_on, claims, figures;

    /// The page's id and the stem of its file: `chapter_03`.
    std::string id() const;
    /// What every section id begins with: `ch3_`.
    std::string section_prefix() const;
    /// `3 · Three ways to take a step`
    std::string heading() const;
    /// Its program's source: `chapters/03_euler_variants/euler_variants.cpp`.
    std::string program() const;
    std::string about() const;
};

/// Every chapter below `root`/chapters, in order. Throws Error for a faulty about.json.
std::vector<Chapter> load_chapters(const std::filesystem::path& root);

}  // namespace page
