// Where the inputs of a check come from.
#include <catch2/catch_test_macros.hpp>

#include <string>

#include "random_stream.hpp"

TEST_CASE("the draws are SipHash, as its authors' test vectors have it") {
    std::string text;  // the key is the bytes 0 to 15, the text the bytes from 0 on
    for (char byte = 0; byte < 15; ++byte) text += byte;
    const auto hash = [&](std::size_t size) {
        return checker::siphash({0x0706050403020100, 0x0f0e0d0c0b0a0908}, text.substr(0, size));
    };
    CHECK(hash(0) == 0x726fdb47dd0e0e31);
    CHECK(hash(8) == 0x93f5f5799a932462);
    CHECK(hash(15) == 0xa129ca6149be45e5);
}
