#include "longest_kutta_step.hpp"

#include "property.hpp"

// How far off an answer may be, as the task says: whoever asks the step's matrix for its two roots gets them to eight
// digits only where they meet, at critical damping.
static constexpr double near_enough = 4e-8;
EXERCISE_WITHIN(longest_kutta_step, near_enough);

namespace {

using Complex = std::complex<double>;

// What a step makes of y1 = 1 with the rate lambda: as the task writes it.
Complex kutta_step(Complex lambda, double h) {
    const auto f = [&](Complex y) { return lambda * y; };
    const Complex y1 = 1, k1 = f(y1), k2 = f(y1 + h / 2 * k1), k3 = f(y1 + h * (2.0 * k2 - k1));
    return y1 + h / 6 * (k1 + 4.0 * k2 + k3);
}

struct Door {
    double omega, zeta;

    double answer() const { return learner(omega, zeta); }
    // The two rates. The slow one as the quotient, which loses no digits.
    std::array<Complex, 2> rates() const {
        const Complex fast = -omega * (zeta + std::sqrt(Complex(zeta * zeta - 1)));
        return {fast, omega * omega / fast};
    }
    // The larger of the two factors of a step.
    double growth(double h) const {
        const auto [one, other] = rates();
        return std::max(std::abs(kutta_step(one, h)), std::abs(kutta_step(other, h)));
    }
    // Is that the limit? Around it |R| rises by 0.75 of the change of the step, or more, relative
    // to its length: by 3e-8 here, far above roundoff.
    bool is_limit(double h) const { return growth(h * (1 - near_enough)) < 1 && growth(h * (1 + near_enough)) > 1; }
    // How large x and v/omega of a run get, in so many steps.
    double farthest(double h, int steps) const {
        const auto f = [&](const std::array<double, 2>& y) {
            return std::array{y[1], -omega * omega * y[0] - 2 * zeta * omega * y[1]};
        };
        const auto plus = [](std::array<double, 2> y, double c, const std::array<double, 2>& k) {
            return std::array{y[0] + c * k[0], y[1] + c * k[1]};
        };
        std::array<double, 2> y{1, omega};
        double far = 0;
        for (int n = 0; n < steps && far < 1e12; ++n) {
            const auto k1 = f(y), k2 = f(plus(y, h / 2, k1));
            const auto k3 = f(plus(plus(y, 2 * h, k2), -h, k1));
            y = plus(plus(plus(y, h / 6, k1), 4 * h / 6, k2), h / 6, k3);
            far = std::max({far, std::fabs(y[0]), std::fabs(y[1]) / omega});
        }
        return far;
    }
};

double draw_omega(Draw& draw) { return draw.log(1e-6, 1e6); }

// Of every size, and many of them where the limit has its hills and valleys.
Door draw_door(Draw& draw) {
    const double omega = draw_omega(draw);
    switch (draw.integer(0, 2)) {
        case 0:
            return {omega, draw.log(1e-4, 1e4)};
        case 1:
            return {omega, draw.log(0.03, 3)};
        default:
            return {omega, draw.real(0.2, 1.1)};
    }
}

}  // namespace

PROPERTY("with the step that you give, and with shorter ones, neither of the two decays grows") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const Door door = draw_door(draw);
        const double longest = door.answer();
        REQUIRE(longest > 0);
        for (const double share : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1 - near_enough})
            REQUIRE(door.growth(share * longest) <= 1 + 1e-15);
    }
}

PROPERTY("with a step a little longer one of them grows") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const Door door = draw_door(draw);
        REQUIRE(door.growth(door.answer() * (1 + near_enough)) > 1);
    }
}

PROPERTY("without a damper there is a longest step, too") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Door door{draw_omega(draw), 0};
        REQUIRE(door.is_limit(door.answer()));
    }
}

// A step multiplies a decay by 1 ± 0.75 · 0.02 or farther from one. Near critical damping the two
// decays are nearly alike: then a run grows to some twenty before it dies.
PROPERTY("a run of the door stays bounded with a step 2 % shorter, and explodes with one longer") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Door door = i < 3 ? Door{draw_omega(draw), 0} : draw_door(draw);
        const double longest = door.answer();
        REQUIRE(door.farthest(0.98 * longest, 3000) < 100);
        REQUIRE(door.farthest(1.02 * longest, 3000) > 1e6);
    }
}

PROPERTY("it is right wherever the task allows: hardly a damper, a huge one, and either side of critical") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 300; ++i) {
        const double omega = draw.any_of(1e-6, 1e6, {1e-6, 1, 1e6});
        const double near = 1 + draw.sign() * draw.log(1e-7, 0.1);
        const Door door{omega, i % 3 == 0 ? near : draw.any_of(1e-4, 1e4, {0, 1e-4, 0.5, 1e4})};
        all &= door.is_limit(door.answer());
    }
    REQUIRE(all);
}
