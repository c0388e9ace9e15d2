#include "random_stream.hpp"

#include <bit>

namespace checker {

namespace {

// The first eight bytes of the text, or as many as there are, the lowest first.
std::uint64_t word_of(std::string_view text) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < text.size() && i < 8; ++i)
        word |= static_cast<std::uint64_t>(static_cast<unsigned char>(text[i])) << (8 * i);
    return word;
}

}  // namespace

std::uint64_t siphash(const std::array<std::uint64_t, 2>& key, std::string_view text) {
    std::uint64_t a = key[0] ^ 0x736f6d6570736575, b = key[1] ^ 0x646f72616e646f6d, c = key[0] ^ 0x6c7967656e657261,
                  d = key[1] ^ 0x7465646279746573;
    const auto rounds = [&](int count) {
        for (; count > 0; --count) {
            a += b, b = std::rotl(b, 13) ^ a, a = std::rotl(a, 32);
            c += d, d = std::rotl(d, 16) ^ c;
            a += d, d = std::rotl(d, 21) ^ a;
            c += b, b = std::rotl(b, 17) ^ c, c = std::rotl(c, 32);
        }
    };
    const auto take = [&](std::uint64_t word) {
        d ^= word;
        rounds(2);
        a ^= word;
    };
    const auto last = static_cast<std::uint64_t>(text.size()) << 56;
    for (; text.size() >= 8; text.remove_prefix(8)) take(word_of(text));
    take(word_of(text) | last);
    c ^= 0xff;
    rounds(4);
    return a ^ b ^ c ^ d;
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view name)
    : key_{siphash({seed, 0}, name), siphash({seed, 1}, name)} {}

std::uint64_t RandomStream::next() {
    char text[8];
    for (int i = 0; i < 8; ++i) text[i] = static_cast<char>(count_ >> (8 * i));
    ++count_;
    return siphash(key_, {text, sizeof text});
}

}  // namespace checker
