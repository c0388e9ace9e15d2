// A step that changes: plain Verlet fails, and two repairs are measured.

#include <array>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/methods/verlet.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

const State<double> start{0, 1.0, 0.5};
const double seconds = 3;
const int draws = 200;  // of step lengths by chance; their mean error is shown

// The lengths of `count` steps that fill the time: long and short in turn, or by chance.
std::vector<double> steps_in_turn(int count) {
    std::vector<double> h;
    for (int i = 0; i < count; ++i) h.push_back((i % 2 == 0 ? 4.0 / 3 : 2.0 / 3) * seconds / count);
    return h;
}
std::vector<double> steps_by_chance(int count, std::mt19937& random) {
    std::vector<double> h;
    double sum = 0;
    for (int i = 0; i < count; ++i) h.push_back(0.5 + random() / 4294967296.0), sum += h.back();
    for (double& step : h) step *= seconds / sum;
    return h;
}

template <class Step>
double position_error(const std::vector<double>& h, const Step& step) {
    const Spring spring(2.0);
    State before = start, now = verlet.start(spring, start, h[0]);
    for (std::size_t i = 1; i < h.size(); ++i) {
        const State next = step(spring, before, now, h[i - 1], h[i]);
        before = now;
        now = next;
    }
    return std::fabs(now.x - spring.exact(start, seconds).x);
}

// Does a spring leave, with steps of ωh = a and b in turn? What is stable stays within some metres.
template <class Step>
bool blows_up(double a, double b, const Step& step) {
    const Spring spring(1.0);
    State before = start, now = verlet.start(spring, start, a);
    double h[] = {a, b};
    for (int n = 0; n < 1000 && std::fabs(now.x) < 1e6; ++n) {
        const State next = step(spring, before, now, h[0], h[1]);
        before = now;
        now = next;
        std::swap(h[0], h[1]);
    }
    return !(std::fabs(now.x) < 1e6);
}

const int last = 20;
int count_of(int i) { return 2 * int(std::lround(10 * std::pow(2.0, i / 2.0))); }

// The mean errors of each of the forms with count_of(0) … count_of(last) steps of lengths by
// chance, the same lengths for all.
template <class... Step>
auto mean_errors(const Step&... step) {
    std::array<std::vector<double>, sizeof...(Step)> mean;
    std::mt19937 random(1);
    for (int i = 0; i <= last; ++i) {
        std::array<double, sizeof...(Step)> sum{};
        for (int k = 0; k < draws; ++k) {
            const auto h = steps_by_chance(count_of(i), random);
            std::size_t form = 0;
            ((sum[form++] += position_error(h, step)), ...);
        }
        for (std::size_t form = 0; form < sum.size(); ++form) mean[form].push_back(sum[form] / draws);
    }
    return mean;
}

// The order that the error(i) of count_of(i) steps shows over the shorter half of the steps tried.
template <class Error>
double order(const std::string& file, const Error& error_with, lab::Findings& out) {
    auto& table = out.table(file, {"step", "error"});
    std::vector<double> h, error;
    for (int i = 0; i <= last; ++i) {
        const int count = count_of(i);
        const double off = error_with(i);
        table.row({seconds / count, off});
        if (i >= 12) h.push_back(seconds / count), error.push_back(off);
    }
    return measured_order(h, error);
}

}  // namespace

void changing_steps(const Settings&, lab::Findings& out) {
    out.section("When the step changes");
    const auto plain = [](const auto& model, const auto& s0, const auto& s1, double, double h2) {
        return verlet.step(model, s0, s1, h2);
    };
    const auto scaled = [](const auto& model, const auto& s0, const auto& s1, double h1, double h2) {
        return verlet.scaled_step(model, s0, s1, h1, h2);
    };
    const auto corrected = [](const auto& model, const auto& s0, const auto& s1, double h1, double h2) {
        return verlet.corrected_step(model, s0, s1, h1, h2);
    };
    const auto with_velocity = [](const auto& model, const auto&, const auto& s1, double, double h2) {
        return velocity_verlet.step(model, s1, h2);
    };
    bool each_leaves = true, all_stay = true;
    const auto by_chance = mean_errors(plain, scaled, corrected, with_velocity);
    std::size_t form = 0;
    const auto both = [&](const std::string& name, const auto& step, double wanted, const char* says) {
        const double turn = order(
            "turn_" + name + ".tsv", [&](int i) { return position_error(steps_in_turn(count_of(i)), step); }, out);
        const double chance = order(
            "chance_" + name + ".tsv", [&](int i) { return by_chance[form][static_cast<std::size_t>(i)]; }, out);
        ++form;
        std::printf("  %-16s order %5.2f with steps long and short in turn, %5.2f by chance\n", name.c_str(), turn,
                    chance);
        const auto hundredths = [](double value) { return std::round(100 * value) / 100 + 0.0; };
        out.number("turn_" + name, hundredths(turn), "", "order, steps long and short in turn");
        out.number("chance_" + name, hundredths(chance), "", "order, steps by chance");
        // The mean of 200 errors scatters by 1/√200 = 7 %: over the nine points of the fit, four
        // octaves, some 0.03 in the slope. The draws are the same on every machine.
        out.check("changing_" + name, std::fabs(turn - wanted) < 0.05 && std::fabs(chance - wanted) < 0.05, says);
        each_leaves = each_leaves && blows_up(1.2, 1.9, step);
        all_stay = all_stay && !blows_up(1.2, 1.2, step) && !blows_up(1.9, 1.9, step);
    };
    both("plain", plain, 0, "with a changing step plain Verlet does not converge");
    both("scaled", scaled, 1, "with a changing step the usual repair is of order one");
    both("corrected", corrected, 2, "with a changing step the time-corrected repair is of order two");
    both("velocity", with_velocity, 2, "with a changing step velocity Verlet is of order two, as it stands");
    out.check("turns_blow_up", each_leaves && all_stay,
              "steps of omega h = 1.2 and 1.9 are stable alone and blow up in turn, for plain Verlet, "
              "both repairs and velocity Verlet");
}
