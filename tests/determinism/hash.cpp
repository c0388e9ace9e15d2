// A long run of every method, folded into one number a run. Only +, −, ×, ÷ and comparisons stand
// between the start and the number: nothing that a mathematical library could compute otherwise.

#include <bit>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

namespace {

// FNV-1a over the bits of real numbers, the lowest byte first on every machine.
class Hash {
public:
    template <class Real>
    void add(Real value) {
        using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
        const auto bits = std::bit_cast<Bits>(value);
        for (std::size_t i = 0; i < sizeof bits; ++i)
            value_ = (value_ ^ ((bits >> 8 * i) & 255)) * 1099511628211u;
    }
    template <class Real>
    void add(const State<Real>& s) {
        add(s.t), add(s.x), add(s.v);
    }
    template <class Real>
    void add(const FirstOrder<Real>& s) {
        add(s.t), add(s.y);
    }
    unsigned long long value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037u;
};

// A spring that stiffens, a = −x − x³: implicit methods need Newton–Raphson.
template <class Real>
struct StiffeningSpring {
    Real acceleration(Real x) const { return -x - x * x * x; }
    Real slope_x(Real x, Real) const { return -1 - 3 * x * x; }
    Real slope_v(Real, Real) const { return 0; }
};

// ẏ = −y³.
template <class Real>
struct Cooling {
    Real operator()(Real, Real y) const { return -y * y * y ; }
    Real slope_y(Real, Real y) const { return -3 * y * y ; }
};

template <class S, class Method, class Model>
void print(const char* scene, const char* real, const Method& method, const Model& model, const S& start) {
    Hash hash;
    // 20,000 steps of 1/128 s: explicit Euler lets the spring grow by e^(h²n/2) = 1.8 only. Past the
    // largest number there would be NaNs, whose bits are nobody's promise.
    const S end = run(method, model, start, real_of<S>(0.0078125), 20000, [&](const S& s) { hash.add(s); });
    if (!is_finite(end)) throw std::runtime_error(std::string(Method::name) + " blew up: " + scene);
    std::printf("%016llx  %-6s  %-17s  %s\n", hash.value(), real, scene, Method::name);
}

// These have no velocity to hand to a damper.
template <class Method>
inline constexpr bool for_position_forces = std::is_same_v<Method, Verlet> || std::is_same_v<Method, VelocityVerlet> ||
                                            std::is_same_v<Method, Leapfrog>;

template <class Real, class Method>
void print_all(const char* real, const Method& method) {
    const State<Real> start{0, 1, 0};
    print("spring", real, method, Spring<Real>(1), start);
    if constexpr (!for_position_forces<Method>)
        print("damped spring", real, method, DampedSpring<Real>(1, Real(0.01)), start);
    if constexpr (!std::is_same_v<Method, SemiImplicitEulerNewDamping>)
        print("stiffening spring", real, method, StiffeningSpring<Real>(), State<Real>{0, Real(0.5), 0});
    const FirstOrder<Real> warm{0, 1};
    if constexpr (requires { method.step(Cooling<Real>(), warm, Real(1)); } ||
                  requires { method.step(Cooling<Real>(), warm, warm, Real(1)); })
        print("cooling", real, method, Cooling<Real>(), warm);
}

template <class Method>
void print_all(const Method& method) {
    print_all<float>("float", method);
    print_all<double>("double", method);
}

}  // namespace

int main() {
    for_each_method([](const auto& method) { print_all(method); });
    print_all(semi_implicit_euler_new_damping);
    for_each_verlet_method([](const auto& method) { print_all(method); });
}
