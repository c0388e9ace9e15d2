// Chapter 1: slopes from differences, and how far off they are.

#include <cmath>

#include "derivatives.hpp"

namespace {

const lab::Rule near_zero{[](double x) { return std::fabs(x) <= 10; }, "from -10 to 10"};
const lab::Rule up_to_one{[](double h) { return h > 0 && h <= 1; }, "above zero and at most 1"};
const lab::Rule frame_rate{[](double f) { return f >= 10 && f <= 500; }, "from 10 to 500"};

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("derivatives", "slopes from differences, and how far off they are");
    program.option("--function", settings.function, {"exp", "sin", "cube"}, "the function whose slope is taken");
    program.option("--at", settings.at, near_zero, "the x where it is taken");
    program.option("--step", settings.step, up_to_one, "the h of its differences");
    program.option("--grid", settings.grid, up_to_one, "what the hand's positions are rounded to, m");
    program.option("--rate", settings.rate, frame_rate, "how often they come, frames a second");
    return program.run(argc, argv, [&](lab::Findings& out) {
        frames(settings, out);
        curves(settings, out);
        orders(settings, out);
        best_steps(settings, out);
        taylor_series(out);
        mistakes(settings, out);
    });
}
