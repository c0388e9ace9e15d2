#include "property.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/interfaces/catch_interfaces_capture.hpp>

#include "last_comparison.hpp"

namespace checker {

namespace {

double power_of_ten(double exponent) {
    return exponent < 0 ? 1 / std::round(std::pow(10, -exponent)) : std::round(std::pow(10, exponent));
}

// The multiple of a step that is 1, 2 or 5 and zeros: 3/10, not 3·0.1.
double multiple(double number, double step) {
    const double count = std::round(number / step);
    return (step < 1 ? count / std::round(1 / step) : count * step) + 0.0;  // no -0
}

// The largest of 1, 2, 5 and zeros that is no larger.
double below(double number) {
    const double power = std::pow(10, std::floor(std::log10(number)));
    return number >= 5 * power ? 5 * power : number >= 2 * power ? 2 * power : power;
}

}  // namespace

Draw::Draw()
    : stream_(session().seed(), Catch::getResultCapture().getCurrentTestName() + std::string(session().stream(), '\n')),
      roundest_(session().stream() > 0),
      coarse_(session().stream() % 2 == 1),
      simple_(roundest_ ? 10'000 : 48) {}

double Draw::share() { return static_cast<double>(stream_.next() >> 11) * 0x1p-53; }

double Draw::real(double low, double high) {
    const double drawn = low + share() * (high - low);
    if (!draws_round()) return drawn;
    for (const double parts : {coarse_ && roundest_ ? 2.0 : roundest_ ? 5.0 : 10.0, 10.0}) {
        const double round = multiple(drawn, below((high - low) / parts));
        if (round >= low && round < high) return round;
    }
    return drawn;
}

double Draw::log(double low, double high) {
    const double drawn = std::exp(std::log(low) + share() * (std::log(high) - std::log(low)));
    if (!draws_round()) return drawn;
    const double least = std::ceil(std::log10(low)), most = std::floor(std::log10(high));
    if (roundest_ && least <= most) {  // rather near one
        const double power = power_of_ten(std::clamp(std::round(std::log10(drawn) * share()), least, most));
        constexpr double first[] = {1, 2, 5, 4, 1.5, 2.5};  // a power of ten may not be what a property looks for
        for (const double one : {power * (coarse_ && simple_ > 9'000 ? 1 : first[choice(6)]), power})
            if (one >= low && one < high) return one;
    }
    const double power = std::pow(10, std::floor(std::log10(drawn)));
    const double round = multiple(drawn, power);
    return round >= low && round < high ? round : drawn;
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
    if (is_roundest() && coarse_) return log(low, high);
    const double at = (i % parts + share()) / parts;
    const double drawn = std::clamp(std::exp(std::log(low) + at * (std::log(high) - std::log(low))), low, high);
    const double round = is_roundest() ? power_of_ten(std::round(std::log10(drawn))) : drawn;
    return round >= low && round <= high ? round : drawn;
}

int Draw::integer(int low, int high) {
    const double part = is_roundest() ? share() * share() * share() : share();
    return low + static_cast<int>(part * (high - low + 1));
}

double allowed_share(double relative) { return relative > 0 ? std::max(relative, session().near_enough()) : 0; }

bool close(double a, double b, double relative, double absolute) {
    const double tolerance = std::max(allowed_share(relative) * std::max(std::fabs(a), std::fabs(b)), absolute);
    // What is infinite lies near nothing, though inf <= relative * inf.
    if (std::isfinite(tolerance) && std::fabs(a - b) <= tolerance) return true;
    return told(false, "Two numbers that must agree are " + in_words(a) + " and " + in_words(b) + ": they differ by " +
                           in_words(std::fabs(a - b)) + ".");
}

double order(double error, double error_of_half) { return std::log2(error / error_of_half); }

}  // namespace checker
