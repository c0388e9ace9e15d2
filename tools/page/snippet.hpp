#pragma once

#include <filesystem>
#include <string>

namespace page {

/// Lines quoted from a source file: what stands between two marker lines, `/// [tag]`.
struct Snippet {
    std::string code;  ///< moved to the left margin, without markers of other snippets
    int first_line;    ///< of the quoted lines in the file
};

/// Quotes a snippet. A tag that does not stand in the file exactly twice, or has nothing between,
/// is a std::out_of_range with one clear sentence.
Snippet quote(const std::filesystem::path& root, const std::string& file, const std::string& tag);

/// The tag on a marker line (`/// [tag]`, `//! [tag]`, `// [tag]`, `# [tag]`), else empty.
std::string marker_tag(std::string_view line);

}  // namespace page
