#pragma once
/// \file
/// Many springs: one array per quantity, in packs.

#include <cstddef>
#include <utility>
#include <vector>

#include <timestep/lanes.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/state.hpp>

namespace timestep {

/// Springs by the thousand, all at one time `t`. Positions, velocities and springs lie in an array
/// each, so that one instruction loads a pack of them.
///
/// The last pack is filled up with copies of the last spring, whose results are not read. So there
/// is no second loop for the rest, and no lane computes with garbage, which might be slow.
template <class Real>
class Springs {
public:
    using Pack = Lanes<Real>;  ///< springs stepped at once

    /// Adds a spring at `x` m with `v` m/s. Throws `std::invalid_argument` if one of them is not
    /// finite.
    void add(const Spring<Real>& spring, Real x, Real v) {
        finite("position", x), finite("velocity", v);
        const int lane = int(size_ % Pack::lanes);
        if (lane == 0) springs_.emplace_back(spring.omega), x_.emplace_back(x), v_.emplace_back(v);
        for (int i = lane; i < Pack::lanes; ++i) {
            springs_.back().omega.set(i, spring.omega);
            x_.back().set(i, x);
            v_.back().set(i, v);
        }
        ++size_;
    }

    /// The number of springs.
    std::size_t size() const { return size_; }
    /// The number of packs that they fill.
    std::size_t packs() const { return x_.size(); }
    /// The state of spring `i`.
    State<Real> operator[](std::size_t i) const {
        const std::size_t pack = i / Pack::lanes;
        const int lane = int(i % Pack::lanes);
        return {Real(t), x_[pack][lane], v_[pack][lane]};
    }

    /// Takes `steps` steps of `h` seconds. A spring takes all of them while it is in the
    /// processor's registers, because fetching it from memory takes longer than a step.
    template <class Method>
    void step(const Method& method, Real h, long steps = 1) {
        step(method, h, steps, 0, packs());
        for (long n = 0; n < steps; ++n) t += double(h);
    }

    /// Takes the steps for the packs from `first` to before `last`, a thread's share, and leaves
    /// `t` as it is.
    template <class Method>
    void step(const Method& method, Real h, long steps, std::size_t first, std::size_t last) {
        for (; first + under_way <= last; first += under_way)
            together<under_way>(method, h, steps, first);
        rest<under_way - 1>(method, h, steps, first, last);
    }

    double t = 0;  ///< time, s; a sum in `float` would be off by seconds per hour

private:
    // A step waits for the one before it, a few cycles per operation. With several packs under way
    // the processor need not wait. Its registers hold this many: 32 of 64 bytes, or 16 shorter
    // ones.
    static constexpr std::size_t under_way = detail::register_bytes == 64 ? 8 : 6;

    /// [together]
    template <std::size_t Packs, class Method>
    TIMESTEP_INLINE void together(const Method& method, Pack h, long steps, std::size_t first) {
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            const Spring<Pack> spring[] = {springs_[first + i]...};
            State<Pack> s[] = {State<Pack>{0, x_[first + i], v_[first + i]}...};
            for (long n = 0; n < steps; ++n) ((s[i] = method.step(spring[i], s[i], h)), ...);
            ((x_[first + i] = s[i].x, v_[first + i] = s[i].v), ...);
        }
        (std::make_index_sequence<Packs>());
    }
    /// [together]

    template <std::size_t Packs, class Method>
    void rest(const Method& method, Real h, long steps, std::size_t first, std::size_t last) {
        if (last - first == Packs)
            together<Packs>(method, h, steps, first);
        else if constexpr (Packs > 1)
            rest<Packs - 1>(method, h, steps, first, last);
    }

    std::size_t size_ = 0;
    std::vector<Spring<Pack>> springs_;
    std::vector<Pack> x_, v_;
};

}  // namespace timestep
