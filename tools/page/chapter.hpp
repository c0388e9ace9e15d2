#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace page {

/// One chapter, as its about.json tells it.
struct Chapter {
    std::string folder;    ///< `03_euler_variants`
    int number;            ///< 3
    std::string title;     ///< `Three ways to take a step`
    std::string question;  ///< in a game programmer's words
    std::string picture;   ///< one of the figures: what its program draws
    std::vector<std::string> builds_on, claims, figures;
    bool has_more;  ///< is there a second page, more.md?

    // Of its second page each of these with `more`.
    /// The page's id and the stem of its file: `chapter_03`, `more_03`.
    std::string id(bool more = false) const;
    /// What every section id begins with: `ch3_`, `more3_`.
    std::string section_prefix(bool more = false) const;
    /// What the page is made from: `chapters/03_euler_variants/chapter.md`, `…/more.md`.
    std::string source(bool more = false) const;

    /// `3 · Three ways to take a step`
    std::string heading() const;
    /// Its program's source: `chapters/03_euler_variants/euler_variants.cpp`.
    std::string program() const;
    std::string about() const;
};

/// Every chapter below `root`/chapters, in order. Throws Error for a faulty about.json.
std::vector<Chapter> load_chapters(const std::filesystem::path& root);

/// Hands an about.json to `read`; CMake has held it to its rules (tools/cmake/chapter.cmake, exercise.cmake). What is
/// wrong with it all the same is an Error.
void read_about(const std::filesystem::path& root, const std::string& file,
                const std::function<void(const nlohmann::json&)>& read);

}  // namespace page
