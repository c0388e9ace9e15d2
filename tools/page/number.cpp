#include "number.hpp"

#include "text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace page {
namespace {

constexpr std::string_view minus = "\u2212";
constexpr std::string_view narrow_space = "\u202f";

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

/// m/s^2 as m/s<sup>2</sup>.
std::string typeset_unit(std::string_view unit) {
    std::string set;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        if (unit[i] != '^') {
            set += unit[i];
            continue;
        }
        set += "<sup>";
        for (++i; i < unit.size() && (unit[i] == '-' || std::isdigit(static_cast<unsigned char>(unit[i])) != 0); ++i)
            set += unit[i] == '-' ? std::string{minus} : std::string{unit[i]};
        --i;
        set += "</sup>";
    }
    return set;
}

}  // namespace

std::optional<Parts> parse_number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // Out of range (1e-400, which long double can print) is a number all the same.
    const bool whole = end == text.data() + text.size() && !text.empty();
    if (!whole || error == std::errc::invalid_argument || value != value) return std::nullopt;
    Parts parts{};
    parts.negative = text.front() == '-';
    text.remove_prefix(parts.negative ? 1 : 0);
    if (text.front() == 'i' || text.front() == 'I') {
        parts.mantissa = "\u221e";
        return parts;
    }
    const std::size_t e = text.find_first_of("eE");
    parts.mantissa = group_thousands(std::string{text.substr(0, e)}, narrow_space);
    if (e != std::string_view::npos) {
        std::string exponent{text.substr(e + 1)};
        const bool down = exponent.front() == '-';
        exponent.erase(0, exponent.find_first_of("123456789"));
        if (!exponent.empty()) parts.exponent = (down ? "-" : "") + exponent;
    }
    return parts;
}

std::string typeset(std::string_view value, std::string_view unit) {
    std::string set;
    if (const std::optional<Parts> parts = parse_number(value)) {
        set += parts->negative ? minus : "";
        if (parts->exponent.empty()) {
            set += parts->mantissa;
        } else {
            const std::string power = "10<sup>" + replace_all(parts->exponent, "-", minus) + "</sup>";
            // 1e-06 is a power of ten, not one times it.
            set += parts->mantissa == "1" ? power : parts->mantissa + "\u202f×\u202f" + power;
        }
    } else {
        set += escape_markdown(value);
    }
    return unit.empty() ? set : set + std::string{narrow_space} + typeset_unit(unit);
}

std::string typeset_tex(std::string_view value, std::string_view unit) {
    std::string set;
    if (const std::optional<Parts> parts = parse_number(value)) {
        set += parts->negative ? "-" : "";
        std::string mantissa = replace_all(parts->mantissa, narrow_space, "\\,");
        mantissa = replace_all(mantissa, "\u221e", "\\infty");
        if (parts->exponent.empty()) {
            set += mantissa;
        } else {
            const std::string power = "10^{" + parts->exponent + "}";
            set += mantissa == "1" ? power : mantissa + "\\times " + power;
        }
    } else {
        set += "\\text{" + std::string{value} + "}";
    }
    return unit.empty() ? set : set + "\\,\\mathrm{" + std::string{unit} + "}";
}

}  // namespace page
