#pragma once
// A step on the plane, one type for all ways to treat the gyroscopic torque.

#include <string>
#include <vector>

#include "plane_scene.hpp"

namespace scene {

using Pill = plane::Capsule<timestep::SymmetricInertia<double>>;
using Ball = plane::Capsule<timestep::UniformInertia<double>>;

// Each is compiled for a capsule and for a ball once, in solvers.cpp, and every section calls it
// there.
struct PlaneSolver {
    using BodyState = plane::BodyState;

    std::string key;   // in the data files and numbers; that of style.gp
    std::string name;  // in tables
    BodyState (*step_pill)(const Pill&, const plane::Ground&, const BodyState&, double h, plane::Contacts&);
    BodyState (*step_ball)(const Ball&, const plane::Ground&, const BodyState&, double h, plane::Contacts&);

    BodyState step(const Pill& body, const plane::Ground& ground, const BodyState& m, double h,
                   plane::Contacts& contacts) const {
        return step_pill(body, ground, m, h, contacts);
    }
    BodyState step(const Ball& body, const plane::Ground& ground, const BodyState& m, double h,
                   plane::Contacts& contacts) const {
        return step_ball(body, ground, m, h, contacts);
    }
};
const std::vector<PlaneSolver>& plane_solvers();          // all, in the order of the course
const PlaneSolver& plane_solver(const std::string& key);  // explicit, dropped, …, passive
const PlaneSolver& passive_after_contacts();              // the passive step between the contacts and the turn

}  // namespace scene
