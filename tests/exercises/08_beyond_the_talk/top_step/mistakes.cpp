#include "exercise_eigen.hpp"

#include <functional>

// A top and the parts of its step, as they should be; what a mistake changes it overrides.
struct Top {
    Vector3d inertia;
    double mgl;
    Vector3d L, up;

    void kick(double time) { L += time * mgl * Vector3d(up.y(), -up.x(), 0); }
    // Turned backwards by so much about axis i.
    static Vector3d back(int i, double angle, const Vector3d& v) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double c = std::cos(angle), s = std::sin(angle);
        Vector3d turned = v;
        turned[j] = c * v[j] + s * v[k];
        turned[k] = c * v[k] - s * v[j];
        return turned;
    }
    void turn(int i, double angle) { L = back(i, angle, L), up = back(i, angle, up); }
    void spin(int i, double time) { turn(i, time * L[i] / inertia[i]); }
    std::array<Vector3d, 2> state() const { return {L, up}; }
};

// The course's step, of the parts `kick(time)` and `spin(axis, time)`.
static void steps(double h, const std::function<void(double)>& kick, const std::function<void(int, double)>& spin) {
    kick(h / 2);
    spin(0, h / 2), spin(1, h / 2), spin(2, h), spin(1, h / 2), spin(0, h / 2);
    kick(h / 2);
}

// Its own parts, in the order and of the times that are told: axes 0, 1 and 2, and 3 for gravity.
static std::array<Vector3d, 2> in_order(Top top, double h, std::initializer_list<std::pair<int, double>> parts) {
    for (const auto& [part, share] : parts) {
        if (part == 3)
            top.kick(share * h);
        else
            top.spin(part, share * h);
    }
    return top.state();
}

// Says: L and up turn forwards with the top. In the top's own axes it is the world that turns, and
//       backwards.
// Hint: Take a spin about z and up along x. What is up x omega, and so which way does up go?
namespace forwards {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(time); }, [&](int i, double time) { top.spin(i, -time); });
    return top.state();
}

}  // namespace forwards

// Says: Only L turns. up is at rest in the world, too, and must turn with it.
// Hint: The two equations have the same x omega. A part turns both vectors.
namespace up_left {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(time); }, [&](int i, double time) { top.L = top.back(i, time * top.L[i] / inertia[i], top.L); });
    return top.state();
}

}  // namespace up_left

// Says: Only up turns, and L stays as it is but for gravity.
// Hint: The first equation begins with L x omega. A spin about one axis turns the rest of L about it.
namespace L_left {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(time); }, [&](int i, double time) { top.up = top.back(i, time * top.L[i] / inertia[i], top.up); });
    return top.state();
}

}  // namespace L_left

// Says: Gravity pulls upwards: its torque has the wrong sign.
// Hint: A cross product changes its sign when its two vectors change places.
namespace gravity_up {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(-time); }, [&](int i, double time) { top.spin(i, time); });
    return top.state();
}

}  // namespace gravity_up

// Says: Gravity at the end of the step acts as at the beginning, in axes that have turned since.
// Hint: Compute the torque from up as it is when gravity acts.
namespace old_gravity {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    const Vector3d torque = mgl * Vector3d(up.y(), -up.x(), 0);
    steps(h, [&](double time) { top.L += time * torque; }, [&](int i, double time) { top.spin(i, time); });
    return top.state();
}

}  // namespace old_gravity

// Says: All angles are taken from the spin at the beginning of the step. Then the parts are not exact: each
//       part changes L for the next.
// Hint: A part turns by h L_i / I_i with the L that it finds.
namespace old_spin {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    const Vector3d omega = L.cwiseQuotient(inertia);
    steps(h, [&](double time) { top.kick(time); }, [&](int i, double time) { top.turn(i, time * omega[i]); });
    return top.state();
}

}  // namespace old_spin

// Says: The angles are taken from L, without the moments.
// Hint: Angular momentum times time is no angle. What is omega about axis i?
namespace no_inertia {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(time); }, [&](int i, double time) { top.turn(i, time * top.L[i]); });
    return top.state();
}

}  // namespace no_inertia

// Says: The three spins are taken as one turn about omega. While the top turns, omega does not stay: this is
//       not exact, and its order is one.
// Hint: About one principal axis alone the spin is steady. Take the axes one after the other.
namespace one_turn {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    top.kick(h / 2);
    const Vector3d omega = top.L.cwiseQuotient(inertia);
    const Eigen::AngleAxisd back(-h * omega.norm(), omega.normalized());
    top.L = back * top.L, top.up = back * top.up;
    top.kick(h / 2);
    return top.state();
}

}  // namespace one_turn

// Says: Gravity does not act at all.
// Hint: With gravity alone up stays, and L changes at a constant rate.
namespace no_gravity {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return in_order({inertia, mgl, L, up}, h, {{0, 0.5}, {1, 0.5}, {2, 1}, {1, 0.5}, {0, 0.5}});
}

}  // namespace no_gravity

// Says: A top without any spin is left as it is. If it leans, gravity makes it fall.
// Hint: Let go of a tilted top, and look at both equations: with L = 0, what is left of the first?
namespace rest_stays {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    if (L.norm() == 0) return {L, up};
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 0.5}, {1, 0.5}, {2, 1}, {1, 0.5}, {0, 0.5}, {3, 0.5}});
}

}  // namespace rest_stays

// Says: The angles are momentum times moment, where they should be momentum over moment.
// Hint: A larger moment turns more slowly. Which way round is omega in the task?
namespace times_inertia {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(time); }, [&](int i, double time) { top.turn(i, time * top.L[i] * inertia[i]); });
    return top.state();
}

}  // namespace times_inertia

// Says: The formula is right, but it is computed with about seven digits, as float has them.
// Hint: Is there a float in your answer, or a number of few digits?
namespace single_precision {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    const auto rounded = [](const Vector3d& v) -> Vector3d { return v.cast<float>().cast<double>(); };
    Top top{inertia, mgl, rounded(L), rounded(up)};
    const auto round = [&] { top.L = rounded(top.L), top.up = rounded(top.up); };
    steps(h, [&](double time) { top.kick(time), round(); },
          [&](int i, double time) { top.turn(i, float(time * top.L[i] / inertia[i])), round(); });
    return top.state();
}

}  // namespace single_precision

// Says: A top that leans by very little is taken for upright, and does not begin to fall.
// Hint: What leans by a millionth leans. Does the step need to ask at all?
namespace nearly_upright {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    if (std::hypot(up.x(), up.y()) < 1e-6) up = Vector3d(0, 0, up.z() > 0 ? 1 : -1);
    return in_order({inertia, mgl, L, up}, h, {{3, 0.5}, {0, 0.5}, {1, 0.5}, {2, 1}, {1, 0.5}, {0, 0.5}, {3, 0.5}});
}

}  // namespace nearly_upright

// Says: The angles are turned into degrees. Eigen, as sine and cosine, wants radians.
// Hint: The angular velocity is in rad/s. By which number do you multiply it, beside the time?
namespace degrees {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(time); },
          [&](int i, double time) { top.turn(i, time * top.L[i] / inertia[i] * (180 / std::numbers::pi)); });
    return top.state();
}

}  // namespace degrees

// Says: Each turn is a first-order one, v + v × angle: it makes the vectors longer.
// Hint: A turn keeps lengths. Sine and cosine do, and so does Eigen's AngleAxisd.
namespace linear_turns {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    const auto turn = [&](int i, double t) {
        const Vector3d w = t * L[i] / inertia[i] * Vector3d::Unit(i);
        L = (L + L.cross(w)).eval(), up = (up + up.cross(w)).eval();
    };
    L += h / 2 * mgl * up.cross(Vector3d::UnitZ());
    turn(0, h / 2), turn(1, h / 2), turn(2, h), turn(1, h / 2), turn(0, h / 2);
    L += h / 2 * mgl * up.cross(Vector3d::UnitZ());
    return {L, up};
}

}  // namespace linear_turns

// Says: This is explicit Euler for gravity and spins at once: nothing is split, and nothing kept.
// Hint: The task names the parts and their order. Each of them is taken exactly.
namespace explicit_euler {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    const Vector3d omega = L.cwiseQuotient(inertia);
    return {Vector3d(L + h * (L.cross(omega) + mgl * up.cross(Vector3d::UnitZ()))), Vector3d(up + h * up.cross(omega))};
}

}  // namespace explicit_euler

// Says: Each turn is a little short: it is one by Cayley's formula, which takes the tangent of half the angle to be half
//       the angle.
// Hint: Each part is to be solved exactly. What turns by just the angle is made of its sine and cosine.
namespace turns_by_cayley {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    const auto by_cayley = [&](int i, double time) { top.turn(i, 2 * std::atan(time / 2 * top.L[i] / inertia[i])); };
    steps(h, [&](double time) { top.kick(time); }, by_cayley);
    return top.state();
}

}  // namespace turns_by_cayley

// Says: Gravity's torque is divided by the moments: that would be a change of the spin, but it is L that changes.
// Hint: A torque times a time is an angular momentum already. What stands on the left of the first equation?
namespace torque_over_inertia {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    const auto kick = [&](double time) {
        top.L += time * mgl * Vector3d(top.up.y() / inertia.x(), -top.up.x() / inertia.y(), 0);
    };
    steps(h, kick, [&](int i, double time) { top.spin(i, time); });
    return top.state();
}

}  // namespace torque_over_inertia

// Says: L turns back, as it should, but up turns forwards. Both are at rest in the world, but for gravity, and
//       turn alike.
// Hint: The two equations have the same x omega. Take a spin about z: which way does up go, seen from the top?
namespace up_forwards {

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    Top top{inertia, mgl, L, up};
    steps(h, [&](double time) { top.kick(time); },
          [&](int i, double time) {
              const double angle = time * top.L[i] / inertia[i];
              top.L = Top::back(i, angle, top.L), top.up = Top::back(i, -angle, top.up);
          });
    return top.state();
}

}  // namespace up_forwards
