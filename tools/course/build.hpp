#pragma once
/// \file
/// Building through CMake, with progress for people and a log for whoever has to look closer.

#include <filesystem>
#include <string>
#include <vector>

#include "exercises.hpp"
#include "terminal.hpp"

namespace course {

/// Builds the targets and shows progress. All that the build prints goes to course.log in the build folder. If it
/// fails, prints the lines that say why and throws Stop(wrong). After one second it prints `what`, or that another
/// build is running. Without targets it only configures a learner's edition.
void build(const std::vector<std::string>& targets, ProgressLine& progress, const std::string& what = {});

/// Builds what a check of these exercises needs, unless nothing has changed since it was last built.
void make_ready(const std::vector<Exercise>& exercises, ProgressLine& progress);

/// The address of the site's first page, as a browser takes it.
std::string site_address();
/// A file's address, as a browser takes it.
std::string address_of(const std::filesystem::path& page);

/// Runs CMake, which writes the files of exercises/ among others. Throws Stop(bad_use) with its first error, in one
/// line.
void configure();

/// CMake's first error in what it has said, in one line and without the place in our scripts; "" if there is none.
std::string cmake_error(const std::string& said);

}  // namespace course
