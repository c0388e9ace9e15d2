#pragma once
/// \file
/// Many bodies, sorted by kind of inertia.

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

#include <timestep/rigid/body_scene.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The rotation of length one that `q`, finite and not zero, stands for: `q` over its length. A
/// quaternion of length one stays as it is, to the last bit.
template <class Real>
Quaternion<Real> as_rotation(const Quaternion<Real>& q) {
    if (std::abs(dot(q.coeffs(), q.coeffs()) - 1) <= 8 * std::numeric_limits<Real>::epsilon())
        return q;
    // Dividing by the largest number first: in `float`, squares of 1e25 overflow, of 1e-25 vanish.
    const Quaternion<Real> scaled(q.coeffs() / q.coeffs().cwiseAbs().maxCoeff());
    return over_its_length(scaled);
}

/// One vector per kind of body: `Bodies<double, Ball, Staff, Crate> all;`
///
/// Each kind is stepped in a loop of its own. So the compiler decides once what kind a body is, and
/// not each step for each body; and the loop over the balls holds no instruction that only a crate
/// needs.
template <class Real, class... Kinds>
class Bodies {
public:
    /// A body and its state.
    template <class Kind>
    struct Member {
        Kind body;              ///< mass, size and inertia
        BodyState<Real> state;  ///< position, orientation and velocities
    };

    /// Adds a body to the others of its kind, with its orientation scaled to length one. Throws
    /// `std::invalid_argument`, as `checked` does, if a scene could not step it.
    template <class Kind>
    void add(const Kind& body, const BodyState<Real>& start) {
        Member<Kind> member{checked(body), checked(start)};
        member.state.turning.q = as_rotation(start.turning.q);
        of<Kind>().push_back(member);
    }

    /// All bodies of one kind, in the order in which they were added.
    template <class Kind>
    std::vector<Member<Kind>>& of() {
        return std::get<std::vector<Member<Kind>>>(groups_);
    }
    /// All bodies of one kind, read-only.
    template <class Kind>
    const std::vector<Member<Kind>>& of() const {
        return std::get<std::vector<Member<Kind>>>(groups_);
    }

    /// The number of bodies of all kinds.
    std::size_t size() const { return (of<Kinds>().size() + ...); }

    /// Steps every body by `h` seconds in `scene`, kind after kind.
    /// [step]
    template <class Scene>
    void step(const Scene& scene, Real h) {
        const auto step_all = [&](auto& group) {
            for (auto& [body, state] : group) scene.step(body, state, h);
        };
        (step_all(of<Kinds>()), ...);
    }
    /// [step]

private:
    std::tuple<std::vector<Member<Kinds>>...> groups_;
};

}  // namespace timestep
