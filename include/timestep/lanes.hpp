#pragma once
/// \file
/// Several real numbers in one SIMD vector: the unchanged formulas of a step move many bodies at
/// once.
///
/// A processor adds eight or sixteen numbers as fast as one. `Lanes<float, 8>` holds eight numbers
/// that add, multiply and divide as one number does, lane by lane. So `Spring<Lanes<float, 8>>` is
/// eight springs, and every template of this library steps them with the source that steps one. The
/// type decides what is vectorised, not the optimiser.

#include <cmath>
#include <cstddef>
#include <type_traits>

#if defined(__AVX__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>  // the other one takes half a second to read
#endif

#include <timestep/inline.hpp>
#include <timestep/own_math.hpp>
#include <timestep/real.hpp>

namespace timestep {

/// \cond
namespace detail {
#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

// For compilers without vector types: an array, whose loops the optimiser may vectorise.
template <class Real, int N>
struct ArrayPack {
    Real number[std::size_t(N)];
    Real operator[](int i) const { return number[i]; }
    Real& operator[](int i) { return number[i]; }
    template <class Operation>
    static ArrayPack made(const Operation& of) {
        ArrayPack all;
        for (int i = 0; i < N; ++i) all.number[i] = of(i);
        return all;
    }
    friend ArrayPack operator+(const ArrayPack& a, const ArrayPack& b) {
        return made([&](int i) { return a[i] + b[i]; });
    }
    friend ArrayPack operator-(const ArrayPack& a, const ArrayPack& b) {
        return made([&](int i) { return a[i] - b[i]; });
    }
    friend ArrayPack operator*(const ArrayPack& a, const ArrayPack& b) {
        return made([&](int i) { return a[i] * b[i]; });
    }
    friend ArrayPack operator/(const ArrayPack& a, const ArrayPack& b) {
        return made([&](int i) { return a[i] / b[i]; });
    }
    friend ArrayPack operator-(const ArrayPack& a) {
        return made([&](int i) { return -a[i]; });
    }
    friend ArrayPack operator-(Real a, const ArrayPack& b) {
        return made([&](int i) { return a - b[i]; });
    }
};

#if defined(__GNUC__)
template <class Real, int N>
struct VectorOf {
    typedef Real type __attribute__((vector_size(N * sizeof(Real))));
};
template <class Real, int N>
using Pack = typename VectorOf<Real, N>::type;
#else
template <class Real, int N>
using Pack = ArrayPack<Real, N>;
#endif
}  // namespace detail
/// \endcond

/// The number of lanes that the processor adds at once, by the compiler's flags: with -march=native
/// its full width.
template <class Real>
inline constexpr int native_width = detail::register_bytes / int(sizeof(Real));

/// `N` real numbers (a power of two) in one value. There are no comparisons, because lanes may
/// differ: a formula with a branch does not compile. In Eigen's vectors, `N` is at most the native
/// width.
template <class Real, int N = native_width<Real>, class Pack = detail::Pack<Real, N>>
class Lanes {
public:
    using Number = Real;             ///< the number in a lane
    static constexpr int lanes = N;  ///< the number of lanes

    Lanes() = default;
    /// Puts `all` into every lane.
    TIMESTEP_INLINE Lanes(Real all) : pack_(all - Pack{}) {}  // −0 − 0 is −0; −0 + 0 is not

    /// The number in lane `i`.
    TIMESTEP_INLINE Real operator[](int i) const { return pack_[i]; }
    /// Puts `value` into lane `i`.
    TIMESTEP_INLINE void set(int i, Real value) { pack_[i] = value; }

    /// \cond
    TIMESTEP_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return Lanes(a.pack_ + b.pack_, 0);
    }
    TIMESTEP_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return Lanes(a.pack_ - b.pack_, 0);
    }
    TIMESTEP_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return Lanes(a.pack_ * b.pack_, 0);
    }
    TIMESTEP_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return Lanes(a.pack_ / b.pack_, 0);
    }
    TIMESTEP_INLINE friend Lanes operator-(const Lanes& a) { return Lanes(-a.pack_, 0); }
    TIMESTEP_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
    TIMESTEP_INLINE Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
    TIMESTEP_INLINE Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
    TIMESTEP_INLINE Lanes& operator/=(const Lanes& b) { return *this = *this / b; }
    /// \endcond

    /// √ of every lane, in one instruction if compiler and processor have it for this width.
    TIMESTEP_INLINE friend Lanes sqrt(const Lanes& a) {
#if defined(__GNUC__) && defined(__AVX512F__)
        // g++ 12 warns of the forms without a mask (GCC bug 105593).
        if constexpr (std::is_same_v<Pack, detail::Pack<float, 16>>)
            return Lanes(Pack(_mm512_maskz_sqrt_ps(0xffff, a.pack_)), 0);
        if constexpr (std::is_same_v<Pack, detail::Pack<double, 8>>)
            return Lanes(Pack(_mm512_maskz_sqrt_pd(0xff, a.pack_)), 0);
#endif
#if defined(__GNUC__) && defined(__AVX__)
        if constexpr (std::is_same_v<Pack, detail::Pack<float, 8>>)
            return Lanes(Pack(_mm256_sqrt_ps(a.pack_)), 0);
        if constexpr (std::is_same_v<Pack, detail::Pack<double, 4>>)
            return Lanes(Pack(_mm256_sqrt_pd(a.pack_)), 0);
#endif
#if defined(__GNUC__) && defined(__SSE2__)
        if constexpr (std::is_same_v<Pack, detail::Pack<float, 4>>)
            return Lanes(Pack(_mm_sqrt_ps(a.pack_)), 0);
        if constexpr (std::is_same_v<Pack, detail::Pack<double, 2>>)
            return Lanes(Pack(_mm_sqrt_pd(a.pack_)), 0);
#endif
        return a.each([](Real x) { return std::sqrt(x); });
    }
    /// ∛ of every lane, one after another: no processor has an instruction for it.
    friend Lanes cbrt(const Lanes& a) {
        return a.each([](Real x) { return cube_root(x); });
    }
    /// The sine of every lane.
    friend Lanes sin(const Lanes& a) {
        return a.each([](Real x) { return sine_cosine(x).sine; });
    }
    /// The cosine of every lane.
    friend Lanes cos(const Lanes& a) {
        return a.each([](Real x) { return sine_cosine(x).cosine; });
    }

    /// Sine and cosine of every lane.
    friend SineCosine<Lanes> sine_cosine(const Lanes& a) {
        SineCosine<Lanes> of;
        for (int i = 0; i < N; ++i) {
            const auto [sine, cosine] = sine_cosine(a[i]);
            of.sine.set(i, sine), of.cosine.set(i, cosine);
        }
        return of;
    }

private:
    TIMESTEP_INLINE Lanes(const Pack& pack, int) : pack_(pack) {}
    template <class Function>
    TIMESTEP_INLINE Lanes each(const Function& f) const {
        Lanes result;
        for (int i = 0; i < N; ++i) result.set(i, f((*this)[i]));
        return result;
    }
    Pack pack_;
};

/// A pack counts as a number in the library.
template <class Real, int N, class Pack>
inline constexpr bool is_number<Lanes<Real, N, Pack>> = true;

}  // namespace timestep

/// \cond  Eigen's vectors of packs. Declared as Eigen declares it: this header needs no Eigen.
namespace Eigen {
template <typename T>
struct NumTraits;
template <class Number, int N, class Pack>
struct NumTraits<timestep::Lanes<Number, N, Pack>> : NumTraits<Number> {
    using Real = timestep::Lanes<Number, N, Pack>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = Real;
};
}  // namespace Eigen
/// \endcond
