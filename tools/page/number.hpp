#pragma once

#include <string>
#include <string_view>

namespace page {

/// Is it a number as C++ prints it ("-3.2e-16")?
bool is_number(std::string_view text);

/// For Markdown and HTML: a proper minus, a superscript exponent, the unit behind a narrow
/// no-break space. Text that is no number is shown as it is.
std::string typeset(std::string_view value, std::string_view unit);

/// The same within a formula.
std::string typeset_tex(std::string_view value, std::string_view unit);

}  // namespace page
