#pragma once
// A physics engine, as the scenes of this benchmark see it. The z axis points up; SI units.

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <timestep/rigid/rotation.hpp>

namespace engines {

using Vector = timestep::Vector3<double>;
using Quaternion = timestep::Quaternion<double>;

// A box of these half extents, or a capsule along z: its radius is half.x, from its middle to the centre of an
// end are half.z. The moments are the body's own affair, as in an engine.
struct Shape {
    enum Kind { box, capsule } kind;
    Vector half;
    Vector moments;  // kg m²; infinite: in Jolt an inverse moment of zero
    double mass = 1;
    std::array<bool, 3> locked{};  // no rotation about these axes of the world, where an engine has that: Box3D, Jolt
    Quaternion axes = Quaternion::Identity();  // of the moments, in the body; Box3D and Jolt take others than its own
};

struct State {
    Vector x = Vector::Zero(), v = Vector::Zero();
    Quaternion q = Quaternion::Identity();
    Vector omega = Vector::Zero();  // in the world
    bool asleep = false;
};

class World {
public:
    virtual ~World() = default;
    virtual void ground() = 0;  // the plane z = 0
    virtual int add(const Shape& shape, const State& state) = 0;
    // Holds a point of body `a` to one of body `b`, both in the bodies' axes; b = −1 is the world.
    virtual void pin(int a, const Vector& on_a, int b, const Vector& on_b) = 0;
    virtual void step(double h) = 0;
    virtual State state(int body) const = 0;
};

inline constexpr double friction = 0.6;
inline constexpr double rolling = 0.02;  // in what an engine takes for it, of capsules

// What a scene wants of its world.
struct Wanted {
    double gravity = 0;  // m/s², downwards
    bool sleeping = false;
    bool damping = false;  // the engine's own, where it has some without being asked
    bool smooth = false;   // neither friction nor rolling resistance
    bool fast = false;     // no cap on how far a body turns in a step, where an engine has one for each body: Box3D
    bool rule = true;      // false: none for the gyroscopic torque, where an engine has a switch for each body: Jolt
};

struct Engine {
    std::string name;  // "Bullet", "Box3D, 4 substeps"
    std::string rule;  // "as it is", …
    std::function<std::unique_ptr<World>(const Wanted&)> world;
};

// The engines that are there, in the order of the tables; `missing` takes a line for each that is not.
void enter_bullet(std::vector<Engine>& engines, std::vector<std::string>& missing);
void enter_ode(std::vector<Engine>& engines, std::vector<std::string>& missing);
void enter_checkouts(std::vector<Engine>& engines, std::vector<std::string>& missing);

}  // namespace engines
