#pragma once
// SPDX-License-Identifier: MIT
/// \file
/// The gyroscopic torque for any engine: plain functions for C99 and C++, in `float` and `double`.
/// No Eigen, exceptions, templates, allocation or state; of the standard library only <math.h>.
///
///     // once, when the body is loaded
///     gyroscopic_bodyf body = gyroscopic_from_inverse_momentsf(4.0f, 1.2f, 1.0f);
///     // in each step, before the contacts and again after them
///     gyroscopic_calm_half_step_in_worldf(&body, &q.x, &w.x, h / 2);
///
/// Names follow C's mathematics: `gyroscopic_passive` for `double`, `gyroscopic_passivef` for
/// `float`.
///
/// - A vector is three numbers side by side, x, y, z; a quaternion four, x, y, z, w, of length one.
///   The quaternion rotates the body's axes into the world's.
/// - `omega` (rad/s) is read and written in place. `h` is the step, s; it may be negative.
/// - The body's axes are its principal axes, to which the moments belong. If an engine keeps a full
///   matrix, find them once, and pass the product of the orientation and their rotation as `q`.
/// - The moments may have any unit, and the body any size, because the moments are scaled first. A
///   body of a millimetre is as accurate in `float` as one of a metre.
///
/// Which function to use:
///
/// - gyroscopic_calm_half_step(): a body in a game; energy and |L| stay for any spin and step.
/// - gyroscopic_passive(): the cheapest safe step; by itself it adds no energy.
/// - gyroscopic_half_step(): with a constant step, up to gyroscopic_half_step_limit().
/// - gyroscopic_ball_and_remainder_2(): a body in flight; it replaces the engine's own rotation of
///   the orientation too.
/// - gyroscopic_ball_and_remainder_4(): a body in flight, in long steps.
///
/// Finite input gives finite output:
///
/// - A moment that is zero, negative, subnormal (below 1e-38 in `float`) or infinite is a locked
///   axis, and so is an inverse moment of zero. ω about it is zero, or another part of the engine
///   holds it. Either way there is no gyroscopic torque, and ω is unchanged. Smaller moments than
///   1e-12 of the largest are raised to 1e-12 of it. Moments that no body has (one larger than the
///   sum of the others) are used as they are.
/// - h = 0 and ω = 0 change nothing. A spin about a principal axis keeps every bit, except that −0
///   may become 0.
/// - If ω has a NaN or an infinity, `omega` and `q` are unchanged.
/// - If the numbers of a step would overflow, an h|ω| beyond one or two million counts as two
///   million. (The limit is lower for moments that no body has; the half step, which is meaningless
///   there, may leave ω unchanged.) If ω's numbers exceed 1e25 in `float` or 1e250 in `double`, or
///   overflow on the way back to the world, nothing changes.
///
/// This holds for IEEE arithmetic. -ffast-math breaks it and is refused: an engine that uses it
/// keeps the calls in a file of its own, compiled with -fno-fast-math.
///
/// Up to the bounds above, and if no product and sum are contracted to one operation, these are,
/// bit for bit, the steps of the library's PassiveGyroscopic, HalfStepJacobian, CalmHalfStep,
/// BallAndRemainder2 and 4 (the last two with `omega` in the body's axes), whose pages derive them.
/// For two equal moments the first three are the steps of SymmetricInertia.

// /fp:fast is Microsoft's word for it.
#if (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(_M_FP_FAST)
#error \
    "timestep: not with -ffast-math or -ffinite-math-only: keep what calls gyroscopic.h in a file that is compiled without"
#endif

#include <float.h>
#include <math.h>

#include <timestep/own_math.h>

/// The numbers of a body that the rules use. Call gyroscopic_from_moments() once to make one; do
/// not fill it in yourself.
typedef struct gyroscopic_body {
    int kind;         ///< 0: no gyroscopic torque; 1: two equal moments; 2: three
    int odd;          ///< of two equal moments: the axis of the third, 0, 1 or 2
    int middle;       ///< the axis of the intermediate moment
    double unit[3];   ///< the moments over their geometric mean
    double ratio[3];  ///< (I₃ − I₂)/I₁ and so on round: ω̇₁ = −ratio₁ ω₂ ω₃
    double circling[3];  ///< |ratio₂ ratio₃| and so on round: the share of ω₁² in the square of how
                         ///< fast ω circles
    double longest;  ///< the largest h|ω| that is used, rad
} gyroscopic_body;
/// The numbers of a body in `float`. Every function has a version for it, whose name ends in f.
typedef struct gyroscopic_bodyf {
    /// \cond
    int kind, odd, middle;
    float unit[4], ratio[4], circling[4], longest;  // four, for lanes
    /// \endcond
} gyroscopic_bodyf;

/// The body with these moments about its axes x, y and z, in any unit. Moments that differ by at
/// most eight roundoffs count as equal. Costs three cube roots and some divisions: call it when the
/// body is loaded, not in every step.
static inline gyroscopic_body gyroscopic_from_moments(double x, double y, double z);
/// The body with these inverse moments, which engines store; zero is a locked axis.
static inline gyroscopic_body gyroscopic_from_inverse_moments(double x, double y, double z);

/// Whether there is no gyroscopic torque now: a ball, a locked axis, or a spin about a principal
/// axis. `omega` in the body's axes. Needs no multiplication. No rule changes ω in these cases.
static inline int gyroscopic_idle(const gyroscopic_body* body, const double omega[3]);

/// One passive step, `omega` in the body's axes: (I − h [L]) ω₂ = I ω, as in ODE, solved in closed
/// form. Order one; the energy never grows, for any body, spin and step (roundoff: a few ε), unless
/// numbers underflow. A free body ends up spinning about the axis of its largest moment. With two
/// equal moments the angle θ of a step is off by θ⁵/120, and nothing is lost: so no loss hides the
/// energy that an engine's contacts may add afterwards.
static inline void gyroscopic_passive(const gyroscopic_body* body, double omega[3], double h);
/// One step of the half-step Jacobian, `omega` in the body's axes: Box3D's and Bullet's solver with
/// h/2 instead of h in the Jacobian (Kahan 1993; Hirota and Kimura 2000). Order two. With a
/// constant step of at most gyroscopic_half_step_limit(), the energy is at most 16/15 of that at
/// the start. With longer steps it may grow without limit. If the equations have no solution, ω is
/// unchanged.
static inline void gyroscopic_half_step(const gyroscopic_body* body, double omega[3], double h);
/// One step of the half-step Jacobian in up to 32 equal parts, scaled back to the energy that it
/// began with; `omega` in the body's axes. Order two; energy and |L| stay to roundoff at any spin,
/// in steps of any length. If 32 parts are not enough, at h|ω| of about 16, ω circles too slowly.
/// Two equal moments take one part, as in gyroscopic_passive(): 0.8 % too slow if a step's angle is
/// one radian, 9 % if it is two; beyond three radians, the faster the spin, the smaller the angle.
static inline void gyroscopic_calm_half_step(const gyroscopic_body* body, double omega[3],
                                             double h);

/// gyroscopic_passive() with `omega` in the world's axes. The orientation `q` is unchanged; the
/// engine steps it.
static inline void gyroscopic_passive_in_world(const gyroscopic_body* body, const double q[4],
                                               double omega[3], double h);
/// gyroscopic_half_step() with `omega` in the world's axes; `q` is unchanged.
static inline void gyroscopic_half_step_in_world(const gyroscopic_body* body, const double q[4],
                                                 double omega[3], double h);
/// gyroscopic_calm_half_step() with `omega` in the world's axes; `q` is unchanged.
static inline void gyroscopic_calm_half_step_in_world(const gyroscopic_body* body,
                                                      const double q[4], double omega[3], double h);

/// One step of a body in flight, which rotates the orientation `q` too: a rotation as of a ball and
/// two of the remainder, one of them in halves. Order two; exact for two equal moments; |L| stays
/// in every step. `omega` in the body's axes.
static inline void gyroscopic_ball_and_remainder_2(const gyroscopic_body* body, double q[4],
                                                   double omega[3], double h);
/// One step of a body in flight in thirteen parts (Blanes and Moan 2002, S6). Order four. `omega`
/// in the body's axes.
static inline void gyroscopic_ball_and_remainder_4(const gyroscopic_body* body, double q[4],
                                                   double omega[3], double h);
/// gyroscopic_ball_and_remainder_2() with `omega` in the world's axes. All of ω is rotated by `q`
/// and back, in `double`, and then rounded.
static inline void gyroscopic_ball_and_remainder_2_in_world(const gyroscopic_body* body,
                                                            double q[4], double omega[3], double h);
/// gyroscopic_ball_and_remainder_4() with `omega` in the world's axes.
static inline void gyroscopic_ball_and_remainder_4_in_world(const gyroscopic_body* body,
                                                            double q[4], double omega[3], double h);

/// The largest |ω|, rad/s, that a free body reaches from here, or the largest number if that is
/// less; `omega` in the body's axes.
static inline double gyroscopic_fastest(const gyroscopic_body* body, const double omega[3]);
/// The longest h, s, for gyroscopic_half_step() with a constant step from here; the largest number
/// if every h will do. `omega` in the body's axes. (The other rules take every h.)
static inline double gyroscopic_half_step_limit(const gyroscopic_body* body, const double omega[3]);

/// \cond
// All functions in `float`.
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

// One source, included twice, because C has no templates: TIMESTEP_NAME(sqrt) is sqrt, and then
// sqrtf.
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

// At -O2 g++ makes a pair of two of a vector's three numbers and moves them to and fro: a third
// more instructions than one by one. This costs no instruction and keeps a number by itself.
#if defined(__GNUC__) && !defined(__clang__) && defined(__SSE2_MATH__)
#define TIMESTEP_C_ALONE(number) __asm__("" : "+x"(number))
#else
#define TIMESTEP_C_ALONE(number) (void)0
#endif

// C++ compilers warn of C casts.
#if defined(__cplusplus)
#define TIMESTEP_C_AS(type, x) static_cast<type>(x)
#else
#define TIMESTEP_C_AS(type, x) ((type)(x))
#endif

// True for numbers other than zero; false for zero and NaN.
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
