#pragma once
// The plain functions of gyroscopic.h.
#include <initializer_list>

#include <timestep/gyroscopic.h>

#include "hash.hpp"

namespace plain {

template <class Body, class Real>
struct Plain {
    const char* name;
    void (*in_body)(const Body*, Real*, Real);
    void (*in_world)(const Body*, const Real*, Real*, Real);
};

template <class Real, class Body>
void print(const Body& body, std::initializer_list<Plain<Body, Real>> rules) {
    for (const auto& rule : rules) {
        Real w[3] = {Real(0.3), Real(7.1), Real(-0.9)}, v[3] = {Real(0.3), Real(7.1), Real(-0.9)};
        const Real q[4] = {Real(0.1), Real(-0.5), Real(0.7), Real(0.5)};
        Hash hash;
        for (int i = 0; i < bits_steps; ++i) {
            rule.in_body(&body, w, Real(0.0073));
            rule.in_world(&body, q, v, Real(0.0073));
            for (int k = 0; k < 3; ++k) hash.add(w[k]), hash.add(v[k]);
        }
        row(hash, name_of<Real>, "in C, body and world", rule.name);
    }
}

template <class Real, class Body, class Fly>
void fly(const Body& body, const Fly& rule, const char* name) {
    Real w[3] = {Real(0.3), Real(7.1), Real(-0.9)}, q[4] = {Real(0.1), Real(-0.5), Real(0.7), Real(0.5)};
    Hash hash;
    for (int i = 0; i < bits_steps; ++i) {
        rule(&body, q, w, Real(0.0073));
        for (const Real x : w) hash.add(x);
        for (const Real x : q) hash.add(x);
    }
    row(hash, name_of<Real>, "in C, flying", name);
}

inline void print_rows() {
    const gyroscopic_bodyf f = gyroscopic_from_momentsf(1.3f, 2.1f, 2.9f);
    const gyroscopic_body d = gyroscopic_from_moments(1.3, 2.1, 2.9);
    using F = Plain<gyroscopic_bodyf, float>;
    using D = Plain<gyroscopic_body, double>;
    print<float>(f, {F{"passive", gyroscopic_passivef, gyroscopic_passive_in_worldf},
                     F{"half step", gyroscopic_half_stepf, gyroscopic_half_step_in_worldf},
                     F{"calm half step", gyroscopic_calm_half_stepf, gyroscopic_calm_half_step_in_worldf}});
    print<double>(d, {D{"passive", gyroscopic_passive, gyroscopic_passive_in_world},
                      D{"half step", gyroscopic_half_step, gyroscopic_half_step_in_world},
                      D{"calm half step", gyroscopic_calm_half_step, gyroscopic_calm_half_step_in_world}});
    fly<float>(f, gyroscopic_ball_and_remainder_2f, "ball and remainder 2");
    fly<float>(f, gyroscopic_ball_and_remainder_4f, "ball and remainder 4");
    fly<double>(d, gyroscopic_ball_and_remainder_2, "ball and remainder 2");
    fly<double>(d, gyroscopic_ball_and_remainder_4, "ball and remainder 4");
}

}  // namespace plain
