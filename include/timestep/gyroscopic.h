#pragma once
// SPDX-License-Identifier: MIT
/// \file
/// The gyroscopic torque for an engine of any kind: plain functions for C99 and C++, in `float` and
/// `double`. No Eigen, no exceptions, no templates; nothing is allocated, nothing is kept, and of
/// the standard library there is <math.h>.
///
///     gyroscopic_bodyf body = gyroscopic_from_inverse_momentsf(4.0f, 1.2f, 1.0f);  // once, when
///     the body is loaded gyroscopic_calm_half_step_in_worldf(&body, &q.x, &w.x, h / 2); // in each
///     step, before the contacts; and after
///
/// Names are those of C's mathematics: `gyroscopic_passive` for `double`, `gyroscopic_passivef` for
/// `float`.
///
/// - A vector is three numbers side by side, x, y, z; a quaternion four, x, y, z, w, of length one.
/// It turns the body's
///   axes into the world's. `omega` (rad/s) is read and written in place. `h` is the step, s; it
///   may be negative.
/// - The body's axes are the principal ones: those about which it has the moments. Where an engine
/// keeps a full matrix,
///   find them once, and hand over the product of the orientation and their rotation for `q`.
/// - The moments' unit drops out, and so does the body's size: they are scaled first. A body of a
/// millimetre is as good
///   in `float` as one of a metre.
///
/// Which one?
///
///     gyroscopic_calm_half_step       a body in a game: energy and |L| stay, at any spin and with
///     any steps gyroscopic_passive              the cheapest that is safe: by itself it adds no
///     energy gyroscopic_half_step            with one step throughout, up to
///     gyroscopic_half_step_limit gyroscopic_ball_and_remainder_2 what flies: the engine's own turn
///     of the orientation is left out, too gyroscopic_ball_and_remainder_4 the same in long steps
///
/// Finite input gives finite output:
///
/// - A moment that is zero, negative or infinite, and an inverse moment of zero, is an axis that is
/// locked; so is one
///   that is subnormal, below 1e-38 in `float`. ω about it is zero, or another part of the engine
///   holds it; either way there is no gyroscopic torque, and ω stays as it is. A moment between
///   that and 1e-12 of the largest is raised to 1e-12 of it. Moments that no body has (one larger
///   than the sum of the others) are taken as they are.
/// - h = 0 and ω = 0 change nothing. Nor does a spin about a principal axis, and no bit of it, but
/// that −0 may become 0.
/// - ω with a number that is none, or that is infinite, comes back as it was, and so does `q`.
/// - Where the numbers of a step would overflow, h|ω| beyond a million or two is taken for two
/// millions (sooner for
///   moments that no body has; the half step, which means nothing there, may leave ω as it is).
///   Where that is not enough, as ω's numbers come to more than 1e25 in `float`, 1e250 in `double`,
///   nothing is done; and so where they overflow on the way back to the world.
///
/// All that holds for IEEE arithmetic. -ffast-math takes the infinities and what is no number out
/// of it, and is refused: an engine that has it on keeps the calls in a file of its own that is
/// compiled with -fno-fast-math.
///
/// Bit for bit, where neither contracts a product and a sum to one operation, and up to the bounds
/// above, these are the steps of the library's PassiveGyroscopic, HalfStepJacobian, CalmHalfStep,
/// BallAndRemainder2 and 4 (the last two with `omega` in the body's axes); there stands where
/// they come from. Two equal moments turn as they do there with SymmetricInertia, by each of the
/// first three.

// /fp:fast is Microsoft's word for it.
#if (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(_M_FP_FAST)
#error \
    "timestep: not with -ffast-math or -ffinite-math-only: keep what calls gyroscopic.h in a file that is compiled without"
#endif

#include <float.h>
#include <math.h>

#include <timestep/own_math.h>

/// A body: what the rules take from its moments. Made once by gyroscopic_from_moments(); not to be
/// filled in by hand.
typedef struct gyroscopic_body {
    int kind;         ///< 0: no gyroscopic torque; 1: two equal moments; 2: three
    int odd;          ///< of two equal moments: the axis of the third, 0, 1 or 2
    int middle;       ///< the axis of the intermediate moment
    double unit[3];   ///< the moments over their geometric mean
    double ratio[3];  ///< (I₃ − I₂)/I₁ and so on round: ω̇₁ = −ratio₁ ω₂ ω₃
    double circling[3];  ///< |ratio₂ ratio₃| and so on round: the share of ω₁² in the square of how
                         ///< fast ω circles
    double longest;  ///< no larger number is taken for h|ω|, rad
} gyroscopic_body;
/// The same in `float`; each function has its twin, whose name ends in f.
typedef struct gyroscopic_bodyf {
    /// \cond
    int kind, odd, middle;
    float unit[4], ratio[4], circling[4], longest;  // four, for lanes
    /// \endcond
} gyroscopic_bodyf;

/// The body with these moments about its axes x, y and z; any unit. Two that differ by at most
/// eight roundoffs are equal. Takes three cube roots and some divisions: for loading, not for every
/// step.
static inline gyroscopic_body gyroscopic_from_moments(double x, double y, double z);
/// The same of one over each, as engines keep them: zero is a locked axis.
static inline gyroscopic_body gyroscopic_from_inverse_moments(double x, double y, double z);

/// Is there no gyroscopic torque now: for a ball, a locked axis, a spin about a principal axis?
/// `omega` in the body's axes. Needs no multiplication. No rule changes ω there.
static inline int gyroscopic_idle(const gyroscopic_body* body, const double omega[3]);

/// One passive step, `omega` in the body's axes: (I − h [L]) ω₂ = I ω, as ODE has it, solved in
/// closed form. Order one; the energy never grows, whatever the body, spin and step (roundoff: some
/// ε), but where numbers underflow. A body left alone ends about the axis of its largest moment.
/// Two equal moments turn exactly but for θ⁵/120 of a step's angle θ, and lose nothing: before an
/// engine's contacts, which may add energy, no loss hides that.
static inline void gyroscopic_passive(const gyroscopic_body* body, double omega[3], double h);
/// One step of the half-step Jacobian, `omega` in the body's axes: Box3D's and Bullet's solver with
/// h/2 where their Jacobian has h (Kahan 1993; Hirota and Kimura 2000). Order two. In equal steps,
/// the first no longer than gyroscopic_half_step_limit(), the energy is at most 16/15 of the first.
/// Beyond it may grow without limit; where its equations have no solution, ω stays.
static inline void gyroscopic_half_step(const gyroscopic_body* body, double omega[3], double h);
/// The same in as many equal parts as it takes, 32 at most, and scaled back to the energy that it
/// began with; `omega` in the body's axes. Order two; energy and |L| stay to roundoff at any spin,
/// in steps of any length. Where 32 parts are not enough, at h|ω| of about 16, ω circles too
/// slowly. Two equal moments turn in one part, as by gyroscopic_passive(): 0.8 % too slowly where a
/// step's angle is one radian, 9 % where it is two; and from three on less, the faster they spin.
static inline void gyroscopic_calm_half_step(const gyroscopic_body* body, double omega[3],
                                             double h);

/// gyroscopic_passive() with `omega` in the world's axes, and the orientation `q`, which stays: the
/// engine turns it.
static inline void gyroscopic_passive_in_world(const gyroscopic_body* body, const double q[4],
                                               double omega[3], double h);
/// gyroscopic_half_step() in the same way.
static inline void gyroscopic_half_step_in_world(const gyroscopic_body* body, const double q[4],
                                                 double omega[3], double h);
/// gyroscopic_calm_half_step() in the same way.
static inline void gyroscopic_calm_half_step_in_world(const gyroscopic_body* body,
                                                      const double q[4], double omega[3], double h);

/// One step of a body that flies: turns the orientation `q` as well. A turn of a ball and two of
/// what is left over, one of them in halves. Order two; exact for two equal moments; |L| stays in
/// any step. `omega` in the body's axes.
static inline void gyroscopic_ball_and_remainder_2(const gyroscopic_body* body, double q[4],
                                                   double omega[3], double h);
/// The same in thirteen parts (Blanes and Moan 2002, S6). Order four.
static inline void gyroscopic_ball_and_remainder_4(const gyroscopic_body* body, double q[4],
                                                   double omega[3], double h);
/// gyroscopic_ball_and_remainder_2() with `omega` in the world's axes. All of it goes through `q`
/// and back, in `double`, and comes back rounded.
static inline void gyroscopic_ball_and_remainder_2_in_world(const gyroscopic_body* body,
                                                            double q[4], double omega[3], double h);
/// gyroscopic_ball_and_remainder_4() in the same way.
static inline void gyroscopic_ball_and_remainder_4_in_world(const gyroscopic_body* body,
                                                            double q[4], double omega[3], double h);

/// How fast can it get, rad/s? The largest |ω| on the way of a body that nothing touches, or the
/// largest number if that is less; `omega` in the body's axes.
static inline double gyroscopic_fastest(const gyroscopic_body* body, const double omega[3]);
/// Up to which h, in s, may gyroscopic_half_step() be taken, in equal steps from here? `omega` in
/// the body's axes. The largest number where any h will do. (The other rules may be taken for any
/// h.)
static inline double gyroscopic_half_step_limit(const gyroscopic_body* body, const double omega[3]);

/// \cond
// All of them in `float`.
static inline gyroscopic_bodyf gyroscopic_from_momentsf(float x, float y, float z);
static inline gyroscopic_bodyf gyroscopic_from_inverse_momentsf(float x, float y, float z);
static inline int gyroscopic_idlef(const gyroscopic_bodyf* body, const float omega[3]);
static inline void gyroscopic_passivef(const gyroscopic_bodyf* body, float omega[3], float h);
static inline void gyroscopic_half_stepf(const gyroscopic_bodyf* body, float omega[3], float h);
static inline void gyroscopic_calm_half_stepf(const gyroscopic_bodyf* body, float omega[3],
                                              float h);
static inline void gyroscopic_passive_in_worldf(const gyroscopic_bodyf* body, const float q[4],
                                                float omega[3], float h);
static inline void gyroscopic_half_step_in_worldf(const gyroscopic_bodyf* body, const float q[4],
                                                  float omega[3], float h);
static inline void gyroscopic_calm_half_step_in_worldf(const gyroscopic_bodyf* body,
                                                       const float q[4], float omega[3], float h);
static inline void gyroscopic_ball_and_remainder_2f(const gyroscopic_bodyf* body, float q[4],
                                                    float omega[3], float h);
static inline void gyroscopic_ball_and_remainder_4f(const gyroscopic_bodyf* body, float q[4],
                                                    float omega[3], float h);
static inline void gyroscopic_ball_and_remainder_2_in_worldf(const gyroscopic_bodyf* body,
                                                             float q[4], float omega[3], float h);
static inline void gyroscopic_ball_and_remainder_4_in_worldf(const gyroscopic_bodyf* body,
                                                             float q[4], float omega[3], float h);
static inline float gyroscopic_fastestf(const gyroscopic_bodyf* body, const float omega[3]);
static inline float gyroscopic_half_step_limitf(const gyroscopic_bodyf* body, const float omega[3]);

// The same source twice, as C has no templates: TIMESTEP_NAME(sqrt) is sqrt, and then sqrtf.
#if defined(__GNUC__)
#define TIMESTEP_C_INLINE static inline __attribute__((always_inline))
#define TIMESTEP_C_APART static __attribute__((noinline, unused))
#elif defined(_MSC_VER)
#define TIMESTEP_C_INLINE static __forceinline
#define TIMESTEP_C_APART static inline
#else
#define TIMESTEP_C_INLINE static inline
#define TIMESTEP_C_APART static inline
#endif

// Of the three numbers of a vector g++ at -O2 makes a pair and one left over, and moves them to and
// fro: a third more instructions than one by one. This takes none, and keeps a number by itself.
#if defined(__GNUC__) && !defined(__clang__) && defined(__SSE2_MATH__)
#define TIMESTEP_C_ALONE(number) __asm__("" : "+x"(number))
#else
#define TIMESTEP_C_ALONE(number) (void)0
#endif

// C++ has warnings for a cast of C's.
#if defined(__cplusplus)
#define TIMESTEP_C_AS(type, x) static_cast<type>(x)
#else
#define TIMESTEP_C_AS(type, x) ((type)(x))
#endif

// Neither zero nor no number?
#if defined(__GNUC__)
#define TIMESTEP_C_NOT_ZERO(x) __builtin_islessgreater(x, 0)
#else
#define TIMESTEP_C_NOT_ZERO(x) ((x) < 0 || (x) > 0)
#endif

#define TIMESTEP_BODY TIMESTEP_NAME(gyroscopic_body)
#define TIMESTEP_REAL double
#define TIMESTEP_NAME(name) name
#define TIMESTEP_NUMBER(digits) digits
#define TIMESTEP_EPSILON DBL_EPSILON
#define TIMESTEP_SMALLEST DBL_MIN
#define TIMESTEP_LARGEST DBL_MAX
#define TIMESTEP_TOO_FAST 1e250
#include <timestep/gyroscopic/rules.h>
#include <timestep/gyroscopic/flying.h>
#undef TIMESTEP_REAL
#undef TIMESTEP_NAME
#undef TIMESTEP_NUMBER
#undef TIMESTEP_EPSILON
#undef TIMESTEP_SMALLEST
#undef TIMESTEP_LARGEST
#undef TIMESTEP_TOO_FAST

#define TIMESTEP_REAL float
#define TIMESTEP_NAME(name) name##f
#define TIMESTEP_NUMBER(digits) digits##f
#define TIMESTEP_EPSILON FLT_EPSILON
#define TIMESTEP_SMALLEST FLT_MIN
#define TIMESTEP_LARGEST FLT_MAX
#define TIMESTEP_TOO_FAST 1e25f
// Three numbers in a vector of four lanes; not where the processor's own arithmetic has other bits
// than its vectors.
#if defined(__GNUC__) && defined(__has_builtin) && \
    (defined(__SSE2_MATH__) || defined(__aarch64__)) && !defined(TIMESTEP_ONE_BY_ONE)
#if __has_builtin(__builtin_shufflevector)
#define TIMESTEP_C_LANES
#endif
#endif
#include <timestep/gyroscopic/rules.h>
#include <timestep/gyroscopic/flying.h>
#undef TIMESTEP_REAL
#undef TIMESTEP_NAME
#undef TIMESTEP_NUMBER
#undef TIMESTEP_EPSILON
#undef TIMESTEP_SMALLEST
#undef TIMESTEP_LARGEST
#undef TIMESTEP_TOO_FAST
#undef TIMESTEP_BODY
#undef TIMESTEP_C_INLINE
#undef TIMESTEP_C_APART
#undef TIMESTEP_C_ALONE
#undef TIMESTEP_C_NOT_ZERO
#undef TIMESTEP_C_LANES
/// \endcond
