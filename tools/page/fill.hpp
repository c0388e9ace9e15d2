#pragma once

#include "context.hpp"

#include <string>
#include <string_view>

namespace page {

/// Fills a page's source: the Markdown that Doxygen reads. `file` is the source's name in errors.
/// Throws Error.
std::string fill(Context& context, std::string_view source, const std::string& file);

}  // namespace page
