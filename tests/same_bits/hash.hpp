#pragma once
// A run folded into one number, and a row of the table: hash, kind of number, scene, method.

#include <bit>
#include <cstdint>
#include <cstdio>
#include <type_traits>

#include <timestep/rigid/body_scene.hpp>
#include <timestep/rigid/spin_state.hpp>
#include <timestep/state.hpp>

using namespace timestep;

// FNV-1a over the bits of real numbers, the lowest byte first on every machine. Which bits "no number" has is nobody's
// promise: all of them count as one.
class Hash {
public:
    template <class Real>
    requires std::is_floating_point_v<Real>
    void add(Real value) {
        using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
        const auto bits = value != value ? Bits(-1) : std::bit_cast<Bits>(value);
        for (std::size_t i = 0; i < sizeof bits; ++i) value_ = (value_ ^ ((bits >> 8 * i) & 255)) * 1099511628211u;
    }
    template <class Vector>
    requires requires(const Vector& v) { v.coeff(0); }
    void add(const Vector& v) {
        for (int i = 0; i < v.size(); ++i) add(v.coeff(i));
    }
    template <class X>
    void add(const State<X>& s) {
        add(s.t), add(s.x), add(s.v);
    }
    template <class Y>
    void add(const FirstOrder<Y>& s) {
        add(s.t), add(s.y);
    }
    template <class Real>
    void add(const SpinState<Real>& s) {
        add(s.t), add(s.q.coeffs()), add(s.omega);
    }
    template <class Real>
    void add(const RigidState<Real>& s) {
        add(s.t), add(s.q.coeffs()), add(s.omega);
    }
    unsigned long long value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037u;
};

inline constexpr int bits_steps = 10000;

template <class Real>
inline constexpr const char* name_of = sizeof(Real) == 4 ? "float" : "double";

inline void row(const Hash& hash, const char* real, const char* scene, const char* method) {
    std::printf("%016llx  %-6s  %-24s  %s\n", hash.value(), real, scene, method);
}
