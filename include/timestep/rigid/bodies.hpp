#pragma once
/// \file
/// Many bodies, sorted by what their inertia needs.

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

#include <timestep/rigid/body_scene.hpp>
#include <timestep/sums.hpp>

namespace timestep {

/// The rotation that a quaternion stands for, of length one: `q`, finite
/// and not zero, over its length. A rotation stays as it is, to the last bit.
template <class Real>
Quaternion<Real> as_rotation(const Quaternion<Real>& q) {
    if (std::abs(dot(q.coeffs(), q.coeffs()) - 1) <= 8 * std::numeric_limits<Real>::epsilon())
        return q;
    // Over the largest number first: in `float` neither 1e25 nor 1e-25 has a square.
    const Quaternion<Real> scaled(q.coeffs() / q.coeffs().cwiseAbs().maxCoeff());
    return over_its_length(scaled);
}

/// One vector a kind of body: `Bodies<double, Ball, Staff, Crate> all;`
///
/// Each kind is stepped in a loop of its own. So the question "what kind is this body?" is asked
/// once, by the compiler, and not once a body and step; and the loop over the balls holds no
/// instruction that only a crate needs.
template <class Real, class... Kinds>
class Bodies {
public:
    /// A body and its state.
    template <class Kind>
    struct Member {
        Kind body;              ///< what it is
        BodyState<Real> state;  ///< what it does
    };

    /// Adds a body to the others of its kind, its orientation scaled to length one. Throws
    /// `std::invalid_argument`, as `checked` does, where a scene could not step it.
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
    /// The same, to read.
    template <class Kind>
    const std::vector<Member<Kind>>& of() const {
        return std::get<std::vector<Member<Kind>>>(groups_);
    }

    /// How many there are of all kinds.
    std::size_t size() const { return (of<Kinds>().size() + ...); }

    /// Steps every body by `h` seconds in `scene`: kind after kind.
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
