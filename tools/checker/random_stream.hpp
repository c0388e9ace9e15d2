#pragma once
/// \file
/// Numbers that nobody can foretell who has seen those before.

#include <array>
#include <cstdint>
#include <string_view>

namespace checker {

/// SipHash-2-4 (Aumasson and Bernstein 2012): of a text and a key, which the hashes of other texts
/// do not tell. The same with every compiler.
std::uint64_t siphash(const std::array<std::uint64_t, 2>& key, std::string_view text);

/// 64 random bits, one after the other: the hashes of 0, 1, 2, … by a key that seed and name
/// decide.
class RandomStream {
public:
    RandomStream(std::uint64_t seed, std::string_view name);
    std::uint64_t next();

private:
    std::array<std::uint64_t, 2> key_;
    std::uint64_t count_ = 0;
};

}  // namespace checker
