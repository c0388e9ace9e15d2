#include "property.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/interfaces/catch_interfaces_capture.hpp>

namespace checker {

Draw::Draw() : stream_(session().seed(), Catch::getResultCapture().getCurrentTestName()) {}

double Draw::real(double low, double high) {
    const double unit = static_cast<double>(stream_.next() >> 11) * 0x1p-53;
    return low + unit * (high - low);
}

double Draw::log(double low, double high) {
    return std::exp(real(std::log(low), std::log(high)));
}

int Draw::integer(int low, int high) {
    return low + static_cast<int>(real(0, 1) * (high - low + 1));
}

bool close(double a, double b, double relative, double absolute) {
    const double tolerance = std::max(relative * std::max(std::fabs(a), std::fabs(b)), absolute);
    // What is infinite lies near nothing, though inf <= relative * inf.
    return std::isfinite(tolerance) && std::fabs(a - b) <= tolerance;
}

double order(double error, double error_of_half) {
    return std::log2(error / error_of_half);
}

}  // namespace checker
