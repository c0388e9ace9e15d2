// The gyroscopic torque of a box, a cube and a ball; and the orientation that follows from a spin.

#include <cmath>
#include <cstdio>

#include <timestep/measured_order.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;

double degrees_between(const V& a, const V& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / pi; }

// The angle between two orientations, rad.
double angle_between(const Quaternion<double>& a, const Quaternion<double>& b) {
    return 2 * std::asin(std::min(1.0, (a.conjugate() * b).vec().norm()));
}

}  // namespace

void torque(const Settings&, lab::Findings& out) {
    out.section("The gyroscopic torque");
    const double mass = 12;
    const auto brick = box(mass, 1.0, 2.0, 3.0);
    const auto dice = cube(mass, 2.0);
    const V omega(1, 2, 2);
    const V L = brick.momentum(omega);
    std::printf("  a box of 12 kg, 1 x 2 x 3 m: I = (%g, %g, %g) kg m^2\n", brick.moments.x(), brick.moments.y(),
                brick.moments.z());
    std::printf("  omega = (1, 2, 2) rad/s: L = (%g, %g, %g), %.1f degrees off omega\n", L.x(), L.y(), L.z(),
                degrees_between(omega, L));
    std::printf("  torque -omega x L = (%g, %g, %g) N m\n", -omega.cross(L).x(), -omega.cross(L).y(),
                -omega.cross(L).z());
    const V cube_L = dice.momentum(omega);
    std::printf("  a cube of 12 kg, 2 m: L is %.1f degrees off omega, the torque %g N m\n",
                degrees_between(omega, cube_L), omega.cross(cube_L).norm());
    out.number("box_angle", degrees_between(omega, L), "°", "between angular velocity and momentum of the box");
    out.text("box_omega", "(1, 2, 2) rad/s", "the spin with that angle");
    out.check("cube_no_torque", omega.cross(cube_L).norm() == 0, "a cube has no gyroscopic torque");

    // A ball passes through a solver that has no step at all: nothing gyroscopic is compiled for
    // it.
    struct Nothing {};
    const auto ball = sphere(12.0, 1.0);
    const auto rolled = step_rotation(Nothing{}, ball, spinning(1, 2, 2), 0.1);
    out.check("sphere_compiles_nothing", !decltype(ball)::gyroscopic && rolled.omega == omega,
              "a ball is stepped by a solver without any code, and keeps its spin bit for bit");

    // ω in the plane of the box's first and last axis, half round.
    const double spin = 3;
    auto& table = out.table("torque.tsv", {"direction", "box", "cube"});
    double largest = 0;
    for (int i = 0; i <= 180; ++i) {
        const double angle = i * pi / 180;
        const V w(spin * std::cos(angle), 0, spin * std::sin(angle));
        const double of_box = w.cross(brick.momentum(w)).norm();
        largest = std::max(largest, of_box);
        table.row({double(i), of_box, w.cross(dice.momentum(w)).norm()});
    }
    out.number("torque_mass", mass, "kg", "mass of the box and of the cube");
    out.number("torque_spin", spin, "rad/s", "the length of ω as it is turned");
    out.check("box_torque_off_axis", largest > 1, "the box has a torque where it spins between its axes");

    // The exact solution, put into the equation it claims to solve.
    const auto exact = ExactFreeBody<double>(brick, spinning(1, 2, 2));
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) {
        const auto s = exact(i * 0.01);
        const V w = s.q.conjugate() * s.omega, Lb = brick.momentum(w);
        const V rest = brick.momentum(exact.acceleration(i * 0.01)) + w.cross(Lb);
        worst = std::max(worst, rest.norm() / (w.norm() * Lb.norm()));
    }
    std::printf("  the exact motion leaves %.1e of Euler's equations\n", worst);
    out.number("exact_residual", worst, "", "what the exact motion leaves of Euler's equations, relative", 1);
    out.check("exact_solves", worst < 1e-12, "the exact motion obeys Euler's equations");
}

void orientation(const Settings&, lab::Findings& out) {
    out.section("From the spin to the orientation");
    const auto brick = box(12.0, 1.0, 2.0, 3.0);
    const auto start = spinning(1, 2, 2);
    const ExactFreeBody<double> exact(brick, start);
    auto& table = out.table("orientation.tsv", {"step", "explicit", "implicit", "passive"});
    std::vector<double> h, error;
    double norm_off = 0, price = 0;
    for (long steps = 64; steps <= 4096; steps *= 2) {
        const double step = 1.0 / double(steps);
        const auto miss = [&](const char* key) {
            RigidState<double> end = start;
            spin_on(solver(key), brick, start, step, steps, [&](const RigidState<double>& s) {
                norm_off = std::max(norm_off, std::fabs(s.q.norm() - 1));
                end = s;
                return true;
            });
            return angle_between(end.q, exact(1).q);
        };
        const double passive = miss("passive");
        const double implicit = miss("implicit");
        table.row({step, miss("explicit"), implicit, passive});
        price = passive / implicit;
        h.push_back(step), error.push_back(passive);
    }
    const double order = measured_order(h, error);
    std::printf("  after a second the orientation is off with order %.2f in the step\n", order);
    out.number("orientation_price", price, "", "error of the passive step over that of one Newton step", 2);
    out.number("orientation_order", order, "", "measured order of the orientation");
    out.check("orientation_order", std::fabs(order - 1) < 0.1, "the orientation is of order one");
    // A quarter turn about z, and a spin along the body's x: that is the world's y.
    const Quaternion<double> quarter(Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()));
    const Quaternion<double> along_x(0, 1, 0, 0);  // (0, ω), ω in the axes of the body
    const auto axis = [&](const Quaternion<double>& rate) { return (rate * quarter.conjugate()).vec().eval(); };
    out.check("wrong_side",
              (axis(quarter * along_x) - Eigen::Vector3d::UnitY()).norm() < 1e-15 &&
                  (axis(along_x * quarter) - Eigen::Vector3d::UnitX()).norm() < 1e-15,
              "a quarter turn about z, a spin along the body's x: the factor on the right turns "
              "about the world's y, as it "
              "should, that on the left about the world's x");
    // Scaling rounds four squares, a sum, a root and a quotient: a few ε.
    out.check("orientation_norm", norm_off < 8 * 2.3e-16, "the quaternion's length stays one, to roundoff");
}
