// The table of bits: every method on every model, and every rule for a body that turns, in float and in double. Two
// desks whose tables are the same may play in lockstep, as far as this library goes. With an argument it prints each
// scene, too: held to another desk's, that names the scene that differs. One file for the compiler: most of what it
// takes is to read Eigen.
#include <vector>

#include <timestep/damper_sweep.hpp>
#include <timestep/own_math.hpp>
#include <timestep/rope.hpp>

#include "bodies.hpp"
#include "forces.hpp"

namespace {

void print_rope() {
    row("rope", "Verlet, 5 sweeps", []<class Real>(Hash& hash) {
        using V = Vector3<Real>;
        const Projectile<V> gravity(V(0, 0, Real(-9.81)));
        Rope<V> rope(V(0, 0, 0), V(Real(0.9), Real(0.3), Real(0.1)), 12, Real(0.11), gravity);
        for (int i = 0; i < steps / 2; ++i) {
            rope.step(Real(0.0173), 5);
            for (const auto& point : rope.points()) hash.add(point.x);
        }
    });
}

void print_dampers() {
    row("springs and dampers", "dampers there and back", []<class Real>(Hash& hash) {
        using V = Vector3<Real>;
        DamperSweep<V> sweep({Real(0.7), 0, Real(1.9)});
        sweep.add(0, 1, V(Real(0.9), Real(0.3), Real(0.1)), Real(31.7));
        sweep.add(2, 0, V(Real(-0.2), Real(1.3), Real(0.7)), Real(0.0113));
        sweep.add(1, 2, V(0, 0, 1), Real(1e5));
        std::vector<V> x{V(1, 2, 3), V(0, 0, 0), V(-1, 0, Real(0.3))}, v(3, V(0, 0, 0));
        for (int i = 0; i < steps; ++i) {
            for (std::size_t k : {0u, 2u}) v[k] -= Real(0.0173 * 900) * x[k];
            sweep.there_and_back(v, Real(0.0173));
            for (std::size_t k = 0; k < 3; ++k) x[k] += Real(0.0173) * v[k], hash.add(x[k]);
        }
    });
}

// The library's own functions, by themselves: few of the other rows' numbers are such that another library rounds them
// in another way.
void print_math() {
    row("cube roots, sines and cosines", "own mathematics", []<class Real>(Hash& hash) {
        for (int i = -steps; i < steps; ++i)
            for (const Real x : {Real(i) * Real(0.0731) / 64, Real(i) * Real(0.0731), Real(i) * Real(579)}) {
                const auto [sine, cosine] = timestep::sine_cosine(x);
                hash.add(timestep::cube_root(x)), hash.add(sine), hash.add(cosine);
            }
    });
}

}  // namespace

int main(int argc, char**) {
    prints_scenes = argc > 1;
    forces::print_rows();
    bodies::print_rows();
    print_rope();
    print_dampers();
    bodies::print_lanes();
    print_math();
    for (const auto& [method, all] : table) print(method, all);
}
