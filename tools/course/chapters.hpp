#pragma once
/// \file
/// The chapters, as their folders say.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace course {

struct Chapter {
    std::string folder;   ///< `03_euler_variants`
    std::string program;  ///< `euler_variants`
    std::string title;
    std::string question;
    std::string picture;  ///< what the program draws, one of the figures
    std::vector<std::string> figures;
    std::vector<std::string> claims;

    /// 3
    int number() const;
    /// Has it a program that measures its page's numbers and checks?
    bool has_study() const;
    /// That program: `euler_variants_study`.
    std::string study() const { return program + "_study"; }
    /// Its short program, below the course's folder: `chapters/03_euler_variants/euler_variants.cpp`.
    std::string source() const { return "chapters/" + folder + "/" + program + ".cpp"; }
    /// Where the sources are: `chapters/03_euler_variants` in the checkout.
    std::filesystem::path sources() const;
    /// Where the build keeps the run that the page is made from.
    std::filesystem::path run() const;
};

/// All chapters, in order. Throws Stop(bad_use) naming an about.json that cannot be used.
std::vector<Chapter> read_chapters();

/// The chapter meant by `3`, `03`, `euler_variants` or `03_euler_variants`, if there is one.
std::optional<Chapter> chapter_of(const std::string& name);

/// That chapter. Throws Stop(bad_use) if there is none.
Chapter find_chapter(const std::string& name);

}  // namespace course
