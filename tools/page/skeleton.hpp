#pragma once

#include "context.hpp"
#include "scanner.hpp"

#include <string>
#include <vector>

namespace page {

/// A chapter's page has the title of its about.json, and its sections have ids that tell whose they are. Throws Error.
void check_skeleton(const std::vector<Piece>& pieces, const Chapter& chapter, const std::string& file);

/// A chapter's second page has sections of its own, and ids that tell whose they are. Throws Error.
void check_more(const std::vector<Piece>& pieces, const Chapter& chapter, const std::string& file);

/// A chapter shows all its figures and teaches all its rows, on this page or the other of its two. Throws Error where
/// this one should have. To be asked when all of the page is filled.
void check_complete(const Context& context);

}  // namespace page
