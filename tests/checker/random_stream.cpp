// Where the inputs of a check come from: the hash is the one whose strength is known, and each seed
// and property has numbers of its own.

#include "random_stream.hpp"

#include <cstdio>
#include <set>
#include <string>

namespace {

int failures = 0;

void expect(bool so, const char* what) {
    if (so) return;
    ++failures;
    std::printf("not so: %s\n", what);
}

}  // namespace

int main() {
    using checker::RandomStream, checker::siphash;
    // The test vectors of its authors: the key is the bytes 0 to 15, the text the bytes from 0 on.
    std::string text;
    for (char byte = 0; byte < 15; ++byte) text += byte;
    const auto of = [&](std::size_t size) {
        return siphash({0x0706050403020100, 0x0f0e0d0c0b0a0908}, text.substr(0, size));
    };
    expect(of(0) == 0x726fdb47dd0e0e31, "the hash of nothing");
    expect(of(1) == 0x74f839c593dc67fd, "the hash of one byte");
    expect(of(8) == 0x93f5f5799a932462, "the hash of eight bytes");
    expect(of(15) == 0xa129ca6149be45e5, "the hash of fifteen bytes");

    std::set<std::uint64_t> all;
    for (const std::uint64_t seed : {0ull, 1ull, 1ull << 63})
        for (const char* const name : {"", "a property", "another property"}) {
            RandomStream keyed(seed, name), again(seed, name);
            for (int i = 0; i < 1000; ++i) {
                const std::uint64_t number = keyed.next();
                expect(number == again.next(), "a seed repeats its numbers");
                all.insert(number);
            }
        }
    expect(all.size() == 9000, "no two seeds, properties or draws have a number in common");
    return failures == 0 ? 0 : 1;
}
