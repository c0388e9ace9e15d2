#include "suspension.hpp"

#include "property.hpp"

EXERCISE(suspension);

PROPERTY("at the sag, the four springs together carry the weight of the car") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double mass = draw.log(0.1, 1e5), sag = draw.log(1e-3, 1), g = draw.real(0.1, 25);
        const auto [k, c] = learner(mass, sag, draw.real(0, 2), g);
        REQUIRE(close(4 * k * sag, mass * g, 1e-13));
    }
}

// m r² + C r + K = 0 has one root of two where C² = 4 m K: of the whole car, C = 4c and K = 4k.
PROPERTY("at a damping ratio of 1 the car just does not swing") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double mass = draw.log(0.1, 1e5), sag = draw.log(1e-3, 1), g = draw.real(0.1, 25);
        const auto [k, c] = learner(mass, sag, 1, g);
        REQUIRE(c > 0);
        REQUIRE(close(16 * c * c, 16 * mass * k, 1e-13));
    }
}

PROPERTY("below 1, an oscillation fades at the rate zeta omega, where omega is that of the car undamped") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double mass = draw.log(0.1, 1e5), sag = draw.log(1e-3, 1), g = draw.real(0.1, 25);
        const double zeta = draw.log(1e-4, 0.99);
        const auto [k, c] = learner(mass, sag, zeta, g);
        const double decay = 4 * c / (2 * mass), omega = std::sqrt(4 * k / mass);
        REQUIRE(close(decay, zeta * omega, 1e-13));
    }
}

// Vieta: the rates p and q have the sum C/m and the product K/m.
PROPERTY("above 1, the slow and the fast return have the rates that zeta and the sag say") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double mass = draw.log(0.1, 1e5), sag = draw.log(1e-3, 1), g = draw.real(0.1, 25);
        const double zeta = draw.log(1.01, 1e3), root = std::sqrt(zeta * zeta - 1);
        const double omega = std::sqrt(g / sag);
        const double p = omega / (zeta + root), q = omega * (zeta + root);
        const auto [k, c] = learner(mass, sag, zeta, g);
        REQUIRE(close(4 * c / mass, p + q, 1e-13));
        REQUIRE(close(4 * k / mass, p * q, 1e-13));
    }
}

// A toy and a ship, on any planet. In each call both numbers must be the right ones.
PROPERTY("cars of any size on any planet, with any damping, get their springs and dampers") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double mass = draw.log(1e-6, 1e9), sag = draw.log(1e-9, 1e3), g = draw.log(1e-6, 1e4);
        const auto [k, c] = learner(mass, sag, draw.any_of(0, 100, {0, 1, 2}), g);
        REQUIRE(close(4 * k * sag, mass * g, 1e-12));
    }
}

PROPERTY("no car, no sag, no gravity and no damping is too small or too large for it") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double mass = draw.spread(1e-12, 1e12, i, 20), sag = draw.spread(1e-12, 1e12, i, 21);
        const double g = draw.spread(1e-12, 1e12, i, 19), zeta = draw.spread(1e-12, 1e12, i, 17);
        REQUIRE(learner(mass, sag, zeta, g)[1] > 0);
    }
}
