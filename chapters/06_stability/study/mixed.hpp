#pragma once
// A crowd of balls, capsules and boxes, kept in the usual ways: what sorting them by kind is
// measured against. Every crowd has `add(kind, motion)` and `step(scene, h)`.

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/bodies.hpp>
#include <timestep/rigid/shapes.hpp>

namespace mixed {

using timestep::BodyState, timestep::Vector3;

struct Ball {
    timestep::UniformInertia<double> inertia;
};
struct Capsule {
    timestep::SymmetricInertia<double> inertia;
};
struct Box {
    timestep::PrincipalInertia<double> inertia;
};

using Sorted = timestep::Bodies<double, Ball, Capsule, Box>;

// One vector of whatever it is, asked in every step.
class Variants {
public:
    template <class Kind>
    void add(const Kind& kind, const BodyState<double>& start) {
        all_.push_back({kind, start});
    }
    template <class Scene>
    void step(const Scene& scene, double h) {
        for (auto& [any, motion] : all_)
            std::visit([&, &m = motion](const auto& kind) { scene.step(kind, m, h); }, any);
    }

private:
    std::vector<std::pair<std::variant<Ball, Capsule, Box>, BodyState<double>>> all_;
};

// One vector of pointers, with a virtual function.
template <class Scene>
class Virtuals {
public:
    template <class Kind>
    void add(const Kind& kind, const BodyState<double>& start) {
        all_.push_back(std::make_unique<ThingOf<Kind>>(kind, start));
    }
    void step(const Scene& scene, double h) {
        for (auto& thing : all_) thing->step(scene, h);
    }

private:
    struct Thing {
        virtual ~Thing() = default;
        virtual void step(const Scene&, double h) = 0;
    };
    template <class Kind>
    struct ThingOf final : Thing {
        Kind kind;
        BodyState<double> motion;
        ThingOf(const Kind& k, const BodyState<double>& m) : kind(k), motion(m) {}
        void step(const Scene& scene, double h) override { scene.step(kind, motion, h); }
    };
    std::vector<std::unique_ptr<Thing>> all_;
};

// Every body a box, so that there is but one kind: no question, and nothing spared.
class Alike {
public:
    template <class Kind>
    void add(const Kind& kind, const BodyState<double>& start) {
        // Every inertia answers with the momentum of a unit spin about an axis: the moment about
        // it.
        const auto I = [&](int axis) { return kind.inertia.momentum(Vector3<double>::Unit(axis))[axis]; };
        boxes_.add(Box{{I(0), I(1), I(2)}}, start);
    }
    template <class Scene>
    void step(const Scene& scene, double h) {
        boxes_.step(scene, h);
    }

private:
    timestep::Bodies<double, Box> boxes_;
};

// The i-th body of a crowd; sizes and spins differ.
inline BodyState<double> motion(int i) {
    const timestep::Quaternion<double> q(1 + i % 3, i % 5, i % 7, 1);
    return {{0, q.normalized(), Vector3<double>(1 + i % 4, 2 - i % 6, i % 9)},
            Vector3<double>(i, 0, 1),
            Vector3<double>(0, 1, i % 2)};
}
inline double size(int i) { return 1 + 0.1 * (i % 11); }

template <class Crowd>
void add_ball(Crowd& crowd, int i) {
    crowd.add(Ball{timestep::sphere(1.0, size(i))}, motion(i));
}
template <class Crowd>
void add_capsule(Crowd& crowd, int i) {
    crowd.add(Capsule{timestep::capsule(1.0, 0.2, size(i))}, motion(i));
}
template <class Crowd>
void add_box(Crowd& crowd, int i) {
    crowd.add(Box{timestep::box(1.0, 1.0, 1.5, size(i))}, motion(i));
}

}  // namespace mixed
