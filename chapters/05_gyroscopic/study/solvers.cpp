// Every way to treat the gyroscopic torque, compiled once for all sections.

#include <stdexcept>

#include "plane_solvers.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

// A method is an empty type: Method{} is the method.
template <class Method>
Solver solver_of(const char* key, const Method&) {
    using State = RigidState<double>;
    return {key, Method::name,
            [](const Box& body, const State& s, double h) { return step_rotation(Method{}, body, s, h); },
            [](const Round& body, const State& s, double h) { return step_rotation(Method{}, body, s, h); },
            [](const Box& body, const State& s, const Vector3<double>& torque, double h) {
                return step_rotation(Method{}, body, s, torque, h);
            }};
}

template <class Method>
scene::PlaneSolver on_plane(const char* key, const Method&, const char* name = Method::name) {
    return {key, name,
            [](const scene::Pill& body, const plane::Ground& ground, const plane::BodyState& m, double h,
               plane::Contacts& contacts) { return plane::step(Method{}, body, ground, m, h, contacts); },
            [](const scene::Ball& body, const plane::Ground& ground, const plane::BodyState& m, double h,
               plane::Contacts& contacts) { return plane::step(Method{}, body, ground, m, h, contacts); }};
}

// In the order in which the course meets them; the keys are those of style.gp.
template <class Make>
auto all(const Make& make) {
    return std::vector{make("explicit", explicit_gyroscopic),   make("dropped", no_gyroscopic),
                       make("lagged_inertia", lagged_inertia),  make("implicit", implicit_gyroscopic),
                       make("converged", converged_gyroscopic), make("passive", passive_gyroscopic)};
}

template <class Any>
const Any& named(const std::string& key, const std::vector<Any>& all) {
    for (const Any& one : all)
        if (one.key == key) return one;
    throw std::invalid_argument("no solver has the key " + key);
}

}  // namespace

const std::vector<Solver>& solvers() {
    static const auto list = all([](auto key, const auto& method) { return solver_of(key, method); });
    return list;
}
const Solver& solver(const std::string& key) { return named(key, solvers()); }

const std::vector<scene::PlaneSolver>& scene::plane_solvers() {
    static const auto list = all([](auto key, const auto& method) { return on_plane(key, method); });
    return list;
}
const scene::PlaneSolver& scene::passive_after_contacts() {
    static const auto solver =
        on_plane("passive_after", plane::AroundContacts<PassiveGyroscopic>{}, "passive, after the contacts");
    return solver;
}
const scene::PlaneSolver& scene::plane_solver(const std::string& key) { return named(key, plane_solvers()); }

template class timestep::ExactFreeBody<double>;
template double timestep::kinetic_energy(const Box&, const RigidState<double>&);
template double timestep::kinetic_energy(const Round&, const RigidState<double>&);
template Vector3<double> timestep::angular_momentum(const Box&, const RigidState<double>&);
template Vector3<double> timestep::angular_momentum(const Round&, const RigidState<double>&);
