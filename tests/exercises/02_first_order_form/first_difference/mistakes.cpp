#include "exercise.hpp"

#include <bit>
#include <cstdint>
#include <functional>

static bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

// The first step at which `same` says no; then what is told of recordings of other lengths.
static int first(const std::vector<double>& here, const std::vector<double>& there,
                 const std::function<bool(double, double)>& same) {
    const std::size_t both = std::min(here.size(), there.size());
    for (std::size_t k = 0; k < both; ++k)
        if (!same(here[k], there[k])) return static_cast<int>(k);
    return here.size() == there.size() ? -1 : static_cast<int>(both);
}

// Says: Values are compared, not bits: zeros of two signs pass for equal, and a NaN differs from itself.
// Hint: What do 0.0 == -0.0 and NaN == NaN give? std::bit_cast<std::uint64_t> hands out the bits.
namespace values {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    return first(here, there, [](double a, double b) { return a == b; });
}

}  // namespace values

// Says: A difference counts only above a tolerance.
// Hint: The last bit is where it begins: a tolerance finds it seconds later, or never.
namespace tolerance {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    return first(here, there, [](double a, double b) { return std::fabs(a - b) <= 1e-9; });
}

}  // namespace tolerance

// Says: A difference counts only above a tolerance, a share of the number.
// Hint: The last bit is where it begins, however small the number: a tolerance that is a share of it misses that bit, too.
namespace relative_tolerance {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    return first(here, there, [](double a, double b) { return same_bits(a, b) || std::fabs(a - b) <= 1e-12 * std::fabs(a); });
}

}  // namespace relative_tolerance

// Says: The numbers are rounded to single precision before they are compared.
// Hint: A float has 24 bits, a double 53: what is lost are the bits where the difference begins.
namespace single_precision {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    return first(here, there, [](double a, double b) { return same_bits(static_cast<float>(a), static_cast<float>(b)); });
}

}  // namespace single_precision

// Says: The last difference is told, not the first.
// Hint: Stop at the first: what comes after it are its consequences.
namespace last {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    int found = here.size() == there.size() ? -1 : static_cast<int>(std::min(here.size(), there.size()));
    for (std::size_t k = 0; k < std::min(here.size(), there.size()); ++k)
        if (!same_bits(here[k], there[k])) found = static_cast<int>(k);
    return found;
}

}  // namespace last

// Says: The search goes by halves, as if runs that have parted never met again.
// Hint: It is right for a hash of all that was so far. Of states, look at each.
namespace by_halves {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    std::size_t low = 0, high = std::min(here.size(), there.size());
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (same_bits(here[middle], there[middle])) low = middle + 1;
        else high = middle;
    }
    return low == here.size() && low == there.size() ? -1 : static_cast<int>(low);
}

}  // namespace by_halves

// Says: A recording that ends early is taken for equal.
// Hint: If one goes on and the other does not, there is a step that only one of them has.
namespace common_part {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    for (std::size_t k = 0; k < std::min(here.size(), there.size()); ++k)
        if (!same_bits(here[k], there[k])) return static_cast<int>(k);
    return -1;
}

}  // namespace common_part

// Says: Lengths are compared first: a difference before the end of the shorter one is passed over.
// Hint: The first difference counts. Look through what both have, and only then at the lengths.
namespace lengths_first {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    if (here.size() != there.size()) return static_cast<int>(std::min(here.size(), there.size()));
    return first(here, there, same_bits);
}

}  // namespace lengths_first

// Says: Steps are counted from one.
// Hint: The first step of a recording has the number zero.
namespace from_one {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const int k = first(here, there, same_bits);
    return k < 0 ? -1 : k + 1;
}

}  // namespace from_one

// Says: Equal recordings give their length, not -1.
// Hint: The task asks for -1 where nothing differs.
namespace length_if_equal {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const int k = first(here, there, same_bits);
    return k < 0 ? static_cast<int>(here.size()) : k;
}

}  // namespace length_if_equal

// Says: A NaN on both machines counts as a difference.
// Hint: The same bits are no desync, whatever they mean.
namespace nan_differs {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    return first(here, there, [](double a, double b) { return same_bits(a, b) && !std::isnan(a); });
}

}  // namespace nan_differs

// Says: Zeros of two signs pass for equal.
// Hint: -0.0 and 0.0 have other bits, and 1/x or atan2 make two games of them.
namespace zeros_alike {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    return first(here, there, [](double a, double b) { return same_bits(a, b) || (a == 0 && b == 0); });
}

}  // namespace zeros_alike

// Says: The last step that both recordings have is not compared: your loop ends one too soon.
// Hint: How many steps have both? Which number has the last of them?
namespace last_step_not_compared {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const std::size_t both = std::min(here.size(), there.size());
    for (std::size_t k = 0; k + 1 < both; ++k)
        if (std::bit_cast<std::uint64_t>(here[k]) != std::bit_cast<std::uint64_t>(there[k])) return static_cast<int>(k);
    return here.size() == there.size() ? -1 : static_cast<int>(both);
}

}  // namespace last_step_not_compared

// Says: Where one recording ends early, you return the length of the longer one.
// Hint: The first step that one of them lacks: which number has it?
namespace end_of_the_longer {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const std::size_t both = std::min(here.size(), there.size());
    for (std::size_t k = 0; k < both; ++k)
        if (std::bit_cast<std::uint64_t>(here[k]) != std::bit_cast<std::uint64_t>(there[k])) return static_cast<int>(k);
    return here.size() == there.size() ? -1 : static_cast<int>(std::max(here.size(), there.size()));
}

}  // namespace end_of_the_longer
