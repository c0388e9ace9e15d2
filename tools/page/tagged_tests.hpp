#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace page {

/// Where a Catch2 test stands that is tagged with a claim of the talks.
struct TestPlace {
    std::string row, name, file;  ///< the file as seen from the root of the course
    int line;
};

/// The tests in the text of one source file: those whose tags name rows, [N22]. A test for several
/// types is one test.
std::vector<TestPlace> tagged_tests(std::string_view text, const std::string& file);

/// The same of every source below tests/chapters and tests/library, by file and line. Nothing is
/// compiled for it: that Catch2 sees the same tests is itself tested.
std::vector<TestPlace> load_tests(const std::filesystem::path& root);

/// The files that load_tests reads.
std::vector<std::filesystem::path> test_sources(const std::filesystem::path& root);

}  // namespace page
