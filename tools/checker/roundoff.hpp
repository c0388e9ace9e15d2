#pragma once
/// \file
/// Roundings drawn at random: what they make of an answer says how far another way to write it may be off.

#include <cstdint>
#include <limits>

namespace checker {

/// A few units of roundoff, relative to a number.
inline constexpr double few_units = 4 * std::numeric_limits<double>::epsilon();

/// The next share, from 0 to below 1, of the sequence that `state` stands for.
inline double next_share(std::uint64_t& state) {
    // SplitMix64 (Steele, Lea and Flood, 2014). All its bits are mixed: shares that follow one another in even steps
    // can all be lucky in one sum.
    std::uint64_t mixed = state += 0x9e3779b97f4a7c15;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((mixed ^ (mixed >> 31)) >> 11) * 0x1p-53;
}

}  // namespace checker
