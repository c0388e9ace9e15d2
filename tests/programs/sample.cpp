// A study in small: it uses the lab as the chapters' studies do. SAMPLE=fails in the environment makes its check fail,
// SAMPLE=nan writes a NaN.
#include <cmath>
#include <cstdlib>

#include "lab.hpp"

int main(int argc, char** argv) {
    double omega = 1, damping = 0, shift = 0;
    long steps = 3;
    std::string method = "explicit";
    lab::Program program("sample", "a study in small");
    program.option("--omega", omega, lab::above_zero, "angular frequency, rad/s");
    program.option("--damping", damping, lab::zero_or_more, "damping ratio");
    program.option("--shift", shift, lab::any_number, "where it starts, m");
    program.option("--steps", steps, 1, 10, "steps taken");
    program.option("--method", method, {"explicit", "implicit"}, "the method");
    return program.run(argc, argv, [&](lab::Findings& out) {
        const char* const sample = std::getenv("SAMPLE");
        const std::string wish = sample == nullptr ? "" : sample;
        out.section("A section");
        out.number("omega", omega, "rad/s", "the angular frequency");
        out.number("third", wish == "nan" ? std::nan("") : 1.0 / 3, "m", "a third");
        out.text("method", method, "the method");
        out.check("slow", omega < 5 && wish != "fails", "omega is below 5 rad/s");
        auto& table = out.table("steps.tsv", {"step", "x"});
        for (long i = 0; i < steps; ++i) table.row({double(i), shift + 0.5 * double(i)});
    });
}
