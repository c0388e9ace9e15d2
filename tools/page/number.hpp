#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace page {

/// A number in three parts, as typographers set it: −3.2 × 10⁻¹⁶.
struct Parts {
    bool negative;
    std::string mantissa;  ///< digits and point, grouped in threes when long; may be "∞"
    std::string exponent;  ///< of ten; empty when there is none
};

/// The parts of a number as C++ prints it ("-3.2e-16"), or nothing when the text is no number.
std::optional<Parts> parse_number(std::string_view text);

/// For Markdown and HTML: a proper minus, a superscript exponent, the unit behind a narrow
/// no-break space. Text that is no number is shown as it is.
std::string typeset(std::string_view value, std::string_view unit);

/// The same within a formula.
std::string typeset_tex(std::string_view value, std::string_view unit);

}  // namespace page
