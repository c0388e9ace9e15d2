#pragma once

#include "context.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace page {

/// docs/talks.tsv: id, talk, what the talks show, erratum (or nothing), checks of the chapter's study that confirm it
/// (names with blanks between, or nothing). Throws Error.
std::map<std::string, TalkRow> load_talks(const std::filesystem::path& file);

/// Every index file in the folder.
std::vector<IndexEntry> load_indexes(const std::filesystem::path& folder);

std::string index_lines(const std::vector<IndexEntry>& index);

}  // namespace page
