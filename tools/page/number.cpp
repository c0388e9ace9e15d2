#include "number.hpp"

#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <regex>

namespace page {
namespace {

/// What a number is set with, on the page or within a formula: −3.2 × 10⁻¹⁶.
struct Style {
    std::string minus, space, infinity, times, begin_power, minus_in_power, end_power;
};
const Style on_page{"\u2212", "\u202f", "\u221e", "\u202f×\u202f", "10<sup>", "\u2212", "</sup>"};
const Style in_formula{"-", "\\,", "\\infty", "\\times ", "10^{", "-", "}"};

/// 1234567 as 1 234 567; four digits stay together.
std::string group_thousands(const std::string& digits, std::string_view space) {
    const std::size_t whole = std::min(digits.find('.'), digits.size());
    if (whole < 5) return digits;
    std::string grouped;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && i < whole && (whole - i) % 3 == 0) grouped += space;
        grouped += digits[i];
    }
    return grouped;
}

/// The number `text`, which is one.
std::string set_number(std::string_view text, const Style& style) {
    std::string set = text.front() == '-' ? style.minus : "";
    text.remove_prefix(text.front() == '-' ? 1 : 0);
    if (text.front() == 'i' || text.front() == 'I') return set + style.infinity;
    const std::size_t e = text.find_first_of("eE");
    const std::string mantissa = group_thousands(std::string{text.substr(0, e)}, style.space);
    std::string exponent{e == std::string_view::npos ? "" : text.substr(e + 1)};
    const bool down = exponent.starts_with('-');
    exponent.erase(0, exponent.find_first_of("123456789"));
    if (exponent.empty()) return set + mantissa;
    // 1e-06 is a power of ten, not one times it.
    return set + (mantissa == "1" ? "" : mantissa + style.times) + style.begin_power +
           (down ? style.minus_in_power : "") + exponent + style.end_power;
}

}  // namespace

bool is_number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // Out of range (1e-400, which long double can print) is a number all the same.
    return !text.empty() && end == text.data() + text.size() && error != std::errc::invalid_argument && value == value;
}

std::string typeset(std::string_view value, std::string_view unit) {
    static const std::regex power{"\\^(-?)([0-9]*)"};  // m/s^2 is m/s<sup>2</sup>
    const std::string set = is_number(value) ? set_number(value, on_page) : escape_markdown(value);
    if (unit.empty()) return set;
    const std::string raised = std::regex_replace(std::string{unit}, power, "<sup>$1$2</sup>");
    return set + on_page.space + replace_all(raised, "<sup>-", "<sup>" + on_page.minus);
}

std::string typeset_tex(std::string_view value, std::string_view unit) {
    const std::string set = is_number(value) ? set_number(value, in_formula) : "\\text{" + std::string{value} + "}";
    return unit.empty() ? set : set + "\\,\\mathrm{" + std::string{unit} + "}";
}

}  // namespace page
