#include "property.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/interfaces/catch_interfaces_capture.hpp>

namespace checker {

Draw::Draw() : stream_(session().seed(), Catch::getResultCapture().getCurrentTestName()) {}

double Draw::share() {
    return static_cast<double>(stream_.next() >> 11) * 0x1p-53;
}

double Draw::real(double low, double high) {
    const double drawn = low + share() * (high - low);
    if (simple_-- <= 0) return drawn;
    // A tenth of the range or somewhat less: 1, 2 or 5 and zeros.
    const double tenth = (high - low) / 10, power = std::pow(10, std::floor(std::log10(tenth)));
    const double step = tenth >= 5 * power ? 5 * power : tenth >= 2 * power ? 2 * power : power;
    const double count = std::round(drawn / step);
    const double round = power < 1 ? count / std::round(1 / step) : count * step;  // 3/10, not 3·0.1
    return round >= low && round < high ? round + 0.0 : drawn;  // no -0
}

double Draw::log(double low, double high) {
    const double drawn = std::exp(std::log(low) + share() * (std::log(high) - std::log(low)));
    if (simple_-- <= 0) return drawn;
    const double power = std::pow(10, std::floor(std::log10(drawn)));
    const double count = std::round(drawn / power);
    const double round = power < 1 ? count / std::round(1 / power) : count * power;
    return round >= low && round < high ? round + 0.0 : drawn;  // no -0
}

double Draw::any_of(double low, double high, std::initializer_list<double> special) {
    if (special.size() > 0 && share() < 0.3) {
        const double one = special.begin()[static_cast<std::size_t>(share() * static_cast<double>(special.size()))];
        if (share() < 0.6) return one;
        const double near = one * (1 + sign() * log(1e-4, 0.03));  // nearly equal is not equal
        return near >= low && near <= high ? near : one;
    }
    if (share() < 0.5) return real(low, high);
    const double most = std::max(std::fabs(low), std::fabs(high)), least = low > 0 ? low : 1e-12 * most;
    for (;;) {
        const double size = log(least, most), drawn = low < 0 && share() < 0.5 ? -size : size;
        if (drawn >= low && drawn <= high) return drawn;
    }
}

double Draw::spread(double low, double high, int i, int parts) {
    const double at = (i % parts + share()) / parts;
    return std::clamp(std::exp(std::log(low) + at * (std::log(high) - std::log(low))), low, high);
}

int Draw::integer(int low, int high) {
    return low + static_cast<int>(share() * (high - low + 1));
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
