#pragma once
// A run folded into one number, and the table: for each method its hash in float, and in double.

#include <bit>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
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
        fold(value != value ? Bits(-1) : std::bit_cast<Bits>(value));
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
    template <class Turning>
    requires requires(const Turning& s) { s.q.coeffs(), s.omega; }
    void add(const Turning& s) { add(s.t), add(s.q.coeffs()), add(s.omega); }
    void add(const Hash& other) { fold(other.value_); }
    unsigned long long value() const { return value_; }

private:
    template <class Bits>
    void fold(Bits bits) {
        for (std::size_t i = 0; i < sizeof bits; ++i) value_ = (value_ ^ ((bits >> 8 * i) & 255)) * 1099511628211u;
    }
    std::uint64_t value_ = 14695981039346656037u;
};

inline constexpr int steps = 10000;

// All runs of a method, or of another rule.
struct Row {
    Hash in_float, in_double;
};
inline std::map<std::string, Row> table;
inline bool prints_scenes = false;

inline void print(const std::string& name, const Row& row) {
    std::printf("%016llx  %016llx  %s\n", row.in_float.value(), row.in_double.value(), name.c_str());
}

// Folds a scene into its method's row. `run` adds to a Hash what it computes with numbers of type Real.
template <class Run>
void row(const std::string& scene, const std::string& method, const Run& run) {
    Row now;
    run.template operator()<float>(now.in_float);
    run.template operator()<double>(now.in_double);
    if (prints_scenes) print(method + ": " + scene, now);
    table[method].in_float.add(now.in_float), table[method].in_double.add(now.in_double);
}
