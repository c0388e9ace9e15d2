#include "property.hpp"

#include <cmath>

#include <catch2/interfaces/catch_interfaces_capture.hpp>

namespace checker {

namespace {

// SplitMix64 (Steele, Lea and Flood 2014): one line, and the same numbers with every compiler.
std::uint64_t next(std::uint64_t& state) {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

}  // namespace

Draw::Draw() : state_(session().seed()) {
    for (const char c : Catch::getResultCapture().getCurrentTestName()) {
        state_ ^= static_cast<unsigned char>(c);
        next(state_);
    }
}

double Draw::real(double low, double high) {
    const double unit = static_cast<double>(next(state_) >> 11) * 0x1p-53;
    return low + unit * (high - low);
}

double Draw::log(double low, double high) {
    return std::exp(real(std::log(low), std::log(high)));
}

int Draw::integer(int low, int high) {
    return low + static_cast<int>(real(0, 1) * (high - low + 1));
}

bool close(double a, double b, double relative, double absolute) {
    return std::fabs(a - b) <= std::max(relative * std::max(std::fabs(a), std::fabs(b)), absolute);
}

double order(double error, double error_of_half) {
    return std::log2(error / error_of_half);
}

}  // namespace checker
