// How two numbers are compared, and from where on.

// Says: Numbers that lie near each other are taken for the same, and NaN for any number: no comparison with it is
//       true, nor is that with your tolerance. Of a replay even the last bit counts.
// Hint: Sooner or later a difference of one bit is one that can be seen. With what do you compare?
namespace small_differences_missed {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const std::size_t both = std::min(here.size(), there.size());
    for (std::size_t k = 0; k < both; ++k)
        if (std::fabs(here[k] - there[k]) > 1e-9) return static_cast<int>(k);
    return here.size() == there.size() ? -1 : static_cast<int>(both);
}

}  // namespace small_differences_missed

// Says: Only the lower half of the bits is compared. Sign, exponent and the first digits stand in the upper
//       one.
// Hint: A double has 64 bits. How many has the type that yours go through?
namespace half_of_the_bits {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const std::size_t both = std::min(here.size(), there.size());
    for (std::size_t k = 0; k < both; ++k)
        if (static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(here[k]) ^ std::bit_cast<std::uint64_t>(there[k])) != 0)
            return static_cast<int>(k);
    return here.size() == there.size() ? -1 : static_cast<int>(both);
}

}  // namespace half_of_the_bits

// Says: You return where the recordings part for good: a difference after which they meet again is missed.
// Hint: Two wrong replays may meet by chance. Which step is the first that differs?
namespace until_they_meet_again {

int first_difference(const std::vector<double>& here, const std::vector<double>& there) {
    const std::size_t both = std::min(here.size(), there.size());
    std::size_t k = both;
    const auto differs = [&](std::size_t i) { return std::bit_cast<std::uint64_t>(here[i]) != std::bit_cast<std::uint64_t>(there[i]); };
    if (here.size() != there.size()) {
        for (k = 0; k < both && !differs(k); ++k) {}
        return static_cast<int>(k);
    }
    while (k > 0 && differs(k - 1)) --k;
    return k == both ? -1 : static_cast<int>(k);
}

}  // namespace until_they_meet_again
