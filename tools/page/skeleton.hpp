#pragma once

#include "chapter.hpp"
#include "scanner.hpp"

#include <string>
#include <vector>

namespace page {

/// Every chapter's page has the same nine sections in the same order. Throws Error at the heading
/// (or at the page's last line) where this one departs from them.
void check_skeleton(const std::vector<Piece>& pieces, const Chapter& chapter,
                    const std::string& file);

}  // namespace page
