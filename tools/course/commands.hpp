#pragma once
/// \file
/// What the course program can do, one function a command. Each throws Stop when it cannot.

#include <optional>
#include <string>
#include <vector>

namespace course {

/// The chapters: for people, or as JSON for programs.
void list(bool json);

/// Builds everything, runs every chapter, makes the site, and closes with a table.
void tour();

/// Builds and runs all tests. With `strict`, a skipped check counts as a failure.
void test(bool strict);

/// Runs one chapter and leaves its data, numbers and figures in the folder `out` (none given: in
/// the build folder). `options` go to the chapter's program.
void run(const std::string& chapter, const std::optional<std::string>& out,
         const std::vector<std::string>& options);

/// Brings the site up to date and says where it is; `open` shows it in the browser.
void site(bool open);

}  // namespace course
