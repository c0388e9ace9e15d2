#pragma once
/// \file
/// The order of a formula or a method, measured: how fast its error falls with the step (N60).

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace timestep {

/// The measured order p. If error = C hᵖ, log(error) against log(h) is a line of slope p; the slope
/// is found by least squares over all pairs (`steps[i]`, `errors[i]`).
///
/// NaN if fewer than two steps have different logarithms, or if a step or an error is not above
/// zero.
inline double measured_order(const std::vector<double>& steps, const std::vector<double>& errors) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (steps.size() != errors.size()) return nan;
    const double n = static_cast<double>(steps.size());
    double mean_x = 0, mean_y = 0;
    bool differ = false;  // asked of the logarithms: their rounded mean may differ from equal ones
    for (std::size_t i = 0; i < steps.size(); ++i) {
        mean_x += std::log(steps[i]) / n;
        mean_y += std::log(errors[i]) / n;
        if (std::log(steps[i]) != std::log(steps[0])) differ = true;
    }
    if (!differ) return nan;
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double x = std::log(steps[i]) - mean_x;
        xx += x * x;
        xy += x * (std::log(errors[i]) - mean_y);
    }
    return xy / xx;
}

}  // namespace timestep
