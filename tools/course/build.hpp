#pragma once
/// \file
/// Building through CMake, with progress for people and a log for whoever has to look closer.

#include <filesystem>
#include <string>
#include <vector>

#include "exercises.hpp"
#include "terminal.hpp"

namespace course {

/// Brings the targets up to date and shows how far it is. All that the build prints goes to
/// course.log in the build folder; where it fails, the lines that say why are shown, and Stop
/// (wrong) is thrown. A user who waits for more than a second is told `what`, or that another build is running.
/// Without targets a learner's edition is only configured.
void build(const std::vector<std::string>& targets, ProgressLine& progress, const std::string& what = {});

/// Builds what a check of these exercises needs: their hidden tests.
void make_ready(const std::vector<Exercise>& exercises, ProgressLine& progress);

/// Builds again the built files for a check of these exercises: the precompiled header, or all.
void make_again(const std::vector<Exercise>& exercises, bool header, ProgressLine& progress);

/// The address of the site's first page, as a browser takes it.
std::string site_address();
/// A file's address, as a browser takes it.
std::string address_of(const std::filesystem::path& page);

/// Lets CMake read again what there is. Throws Stop(bad_use) with its first error, in one line.
void configure();

}  // namespace course
