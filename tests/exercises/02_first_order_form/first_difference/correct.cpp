#include "exercise.hpp"

#include <bit>
#include <cstdint>
#include <cstring>

namespace mismatch {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const auto same = [](double a, double b) {
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
    };
    const auto [a, b] = std::mismatch(here.begin(), here.end(), there.begin(), there.end(), same);
    return a == here.end() && b == there.end() ? -1 : static_cast<int>(a - here.begin());
}

}  // namespace mismatch

namespace memory {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const int most = static_cast<int>(std::max(here.size(), there.size()));
    for (int k = 0; k < most; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (i >= here.size() || i >= there.size()) return k;
        if (std::memcmp(&here[i], &there[i], sizeof(double)) != 0) return k;
    }
    return -1;
}

}  // namespace memory

namespace by_values {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    int k = 0;
    for (auto a = here.begin(), b = there.begin(); a != here.end() && b != there.end(); ++a, ++b, ++k) {
        if (std::isnan(*a) && std::isnan(*b)) continue;
        if (!(*a == *b) || std::signbit(*a) != std::signbit(*b)) return k;
    }
    return here.size() == there.size() ? -1 : k;
}

}  // namespace by_values
