// SPDX-License-Identifier: MIT
/// \file
/// What stands behind gyroscopic.h, for one kind of real number: bodies, rules for ω. gyroscopic.h
/// includes it twice, with TIMESTEP_REAL float and double; nobody else does. Each formula is
/// explained where the library has it: in inertia.hpp, passive_gyroscopic.hpp,
/// half_step_jacobian.hpp and calm_half_step.hpp.

/// \cond
static inline TIMESTEP_BODY TIMESTEP_NAME(gyroscopic_from_moments)(TIMESTEP_REAL x, TIMESTEP_REAL y,
                                                                   TIMESTEP_REAL z) {
    TIMESTEP_BODY body = {0, 2, 0, {1, 1, 1}, {0, 0, 0}, {0, 0, 0}, 2097152};  // a ball; 2²¹ rad
    TIMESTEP_REAL moment[3];
    TIMESTEP_REAL largest = 0, middle, steepest = 1, mean;
    int i;
    moment[0] = x, moment[1] = y, moment[2] = z;
    for (i = 0; i < 3; ++i) {
        if (!(moment[i] >= TIMESTEP_SMALLEST && moment[i] <= TIMESTEP_LARGEST))
            return body;  // a locked axis
        if (moment[i] > largest) largest = moment[i];
    }
    for (i = 0; i < 3; ++i)
        moment[i] = TIMESTEP_NAME(fmax)(moment[i], TIMESTEP_NUMBER(1e-12) * largest);

    body.kind = 2;
    for (i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (TIMESTEP_NAME(fabs)(moment[i] - moment[j]) <= 8 * TIMESTEP_EPSILON * moment[i]) {
            moment[j] = moment[i];
            body.kind = 1;
            body.odd = k;
        }
    }
    if (moment[0] == moment[1] && moment[1] == moment[2]) {
        body.kind = 0;
        return body;
    }
    mean = TIMESTEP_NAME(timestep_cbrt)(moment[0]) * TIMESTEP_NAME(timestep_cbrt)(moment[1]) *
           TIMESTEP_NAME(timestep_cbrt)(moment[2]);
    for (i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        body.ratio[i] = (moment[k] - moment[j]) / moment[i];
        body.unit[i] = moment[i] / mean;
        steepest = TIMESTEP_NAME(fmax)(steepest, TIMESTEP_NAME(fabs)(body.ratio[i]));
    }
    for (i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        body.circling[i] = TIMESTEP_NAME(fabs)(body.ratio[j] * body.ratio[k]);
        middle = body.unit[i];
        if (TIMESTEP_NAME(fmin)(body.unit[j], body.unit[k]) <= middle &&
            middle <= TIMESTEP_NAME(fmax)(body.unit[j], body.unit[k]))
            body.middle = i;
    }
    body.longest = body.longest / steepest;  // above one only for moments that no body has
    return body;
}

static inline TIMESTEP_BODY TIMESTEP_NAME(gyroscopic_from_inverse_moments)(TIMESTEP_REAL x,
                                                                           TIMESTEP_REAL y,
                                                                           TIMESTEP_REAL z) {
    if (!(x > 0 && y > 0 && z > 0))
        return TIMESTEP_NAME(gyroscopic_from_moments)(0, 0, 0);  // never divides by zero
    return TIMESTEP_NAME(gyroscopic_from_moments)(1 / x, 1 / y, 1 / z);
}

TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_on_axis)(const TIMESTEP_REAL w[3]) {
    return w[0] == 0 ? w[1] == 0 || w[2] == 0 : w[1] == 0 && w[2] == 0;
}
TIMESTEP_C_INLINE int TIMESTEP_NAME(gyroscopic_idle)(const TIMESTEP_BODY* body,
                                                     const TIMESTEP_REAL omega[3]) {
    return body->kind == 0 || TIMESTEP_NAME(timestep_on_axis)(omega) ||
           (body->kind == 1 && omega[body->odd] == 0);
}

// The rules are homogeneous: a step of h with ω is a step of ch with ω/c, times c. So ω and h can
// be brought to where no product overflows. Are they there already?
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_tame)(const TIMESTEP_BODY* body,
                                                   const TIMESTEP_REAL w[3], TIMESTEP_REAL h) {
    return TIMESTEP_NAME(fabs)(h) <= 1 &&
           TIMESTEP_NAME(fabs)(w[0]) + TIMESTEP_NAME(fabs)(w[1]) + TIMESTEP_NAME(fabs)(w[2]) <=
               body->longest;
}
// Brings them there. Gives back c; zero where ω is beyond all bounds.
static inline TIMESTEP_REAL TIMESTEP_NAME(timestep_taming)(const TIMESTEP_BODY* body,
                                                           TIMESTEP_REAL w[3], TIMESTEP_REAL* h) {
    const TIMESTEP_REAL step = TIMESTEP_NAME(fabs)(*h);
    const TIMESTEP_REAL size =
        TIMESTEP_NAME(fabs)(w[0]) + TIMESTEP_NAME(fabs)(w[1]) + TIMESTEP_NAME(fabs)(w[2]);
    TIMESTEP_REAL c = 1;
    if (!(size <= TIMESTEP_TOO_FAST)) return 0;
    if (step * size > body->longest) *h = TIMESTEP_NAME(copysign)(body->longest / size, *h);
    if (size > 1048576) c = TIMESTEP_NUMBER(18446744073709551616.0);  // 2⁶⁴
    if (step > 1048576 && size <= 1) c = 1 / TIMESTEP_NUMBER(18446744073709551616.0);
    w[0] /= c, w[1] /= c, w[2] /= c, *h *= c;
    return c;
}

// Two equal moments: a turn about the odd axis k, in three shears (PassiveGyroscopic).
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_shears)(const TIMESTEP_BODY* body, TIMESTEP_REAL w[3],
                                                      TIMESTEP_REAL h, int i, int j, int k) {
    const TIMESTEP_REAL u = h / 2 * body->ratio[i] * w[k];
    const TIMESTEP_REAL p = u * u / 3;
    const TIMESTEP_REAL t = u / (1 - p + p * p);
    const TIMESTEP_REAL s = 2 * t / (1 + t * t);
    const TIMESTEP_REAL x = w[i] - t * w[j];
    const TIMESTEP_REAL y = w[j] + s * x;
    w[i] = x - t * y;
    w[j] = y;
}
// Is the result a number? Then no product on its way was none.
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_symmetric)(const TIMESTEP_BODY* body,
                                                        TIMESTEP_REAL w[3], TIMESTEP_REAL h, int i,
                                                        int j, int k) {
    TIMESTEP_REAL after[3], zero;
    after[0] = w[0], after[1] = w[1], after[2] = w[2];
    TIMESTEP_NAME(timestep_shears)(body, after, h, i, j, k);
    zero = after[i] - after[i];
    if (zero != zero) return 0;
    w[i] = after[i];
    w[j] = after[j];
    return 1;
}
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_turn_about_odd)(const TIMESTEP_BODY* body,
                                                             TIMESTEP_REAL w[3], TIMESTEP_REAL h) {
    if (body->odd == 2) return TIMESTEP_NAME(timestep_symmetric)(body, w, h, 0, 1, 2);
    if (body->odd == 1) return TIMESTEP_NAME(timestep_symmetric)(body, w, h, 2, 0, 1);
    return TIMESTEP_NAME(timestep_symmetric)(body, w, h, 1, 2, 0);
}

TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_passive)(const TIMESTEP_BODY* body,
                                                       TIMESTEP_REAL w[3], TIMESTEP_REAL h) {
    const TIMESTEP_REAL* U = body->unit;
    const TIMESTEP_REAL a0 = h * body->ratio[0], a1 = h * body->ratio[1], a2 = h * body->ratio[2];
    const TIMESTEP_REAL l0 = h * (U[0] * w[0]), l1 = h * (U[1] * w[1]), l2 = h * (U[2] * w[2]);
    const TIMESTEP_REAL x = w[0], y = w[1], z = w[2];
    const TIMESTEP_REAL share = 1 / (1 + (U[0] * l0 * l0 + U[1] * l1 * l1 + U[2] * l2 * l2));
    const TIMESTEP_REAL l_l = l0 * l0 + (l1 * l1 + l2 * l2);
    w[0] = share * x - a0 * y * (share * z) + l_l * U[0] * (share * x);
    w[1] = share * y - a1 * z * (share * x) + l_l * U[1] * (share * y);
    w[2] = share * z - a2 * x * (share * y) + l_l * U[2] * (share * z);
}

// With `singular` equations that have no solution leave ω as it is; without, they give what is no
// number.
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_half_step)(const TIMESTEP_BODY* body,
                                                         TIMESTEP_REAL w[3], TIMESTEP_REAL h,
                                                         int singular) {
    const TIMESTEP_REAL half = h / 2;
    const TIMESTEP_REAL a0 = half * body->ratio[0], a1 = half * body->ratio[1],
                        a2 = half * body->ratio[2];
    const TIMESTEP_REAL x = w[0], y = w[1], z = w[2];
    const TIMESTEP_REAL r0 = 2 * (a0 * y * z), r1 = 2 * (a1 * z * x), r2 = 2 * (a2 * x * y);
    // The columns a, b, c of the Jacobian, and Cramer's rule.
    const TIMESTEP_REAL ay = a1 * z, az = a2 * y, bx = a0 * z, bz = a2 * x, cx = a0 * y,
                        cy = a1 * x;
    const TIMESTEP_REAL bc0 = 1 - bz * cy, bc1 = bz * cx - bx, bc2 = bx * cy - cx;
    const TIMESTEP_REAL ca0 = cy * az - ay, ca1 = 1 - cx * az, ca2 = cx * ay - cy;
    const TIMESTEP_REAL ab0 = ay * bz - az, ab1 = az * bx - bz, ab2 = 1 - ay * bx;
    const TIMESTEP_REAL volume = bc0 + (ay * bc1 + az * bc2);
    const TIMESTEP_REAL share = singular && volume == 0 ? 0 : 1 / volume;
    w[0] = x - share * (r0 * bc0 + (r1 * bc1 + r2 * bc2));
    w[1] = y - share * (r0 * ca0 + (r1 * ca1 + r2 * ca2));
    w[2] = z - share * (r0 * ab0 + (r1 * ab1 + r2 * ab2));
}

TIMESTEP_C_INLINE TIMESTEP_REAL TIMESTEP_NAME(timestep_energy)(const TIMESTEP_BODY* body,
                                                               const TIMESTEP_REAL w[3],
                                                               TIMESTEP_REAL h) {
    const TIMESTEP_REAL x = h * w[0], y = h * w[1], z = h * w[2];
    return body->unit[0] * (x * x) + (body->unit[1] * (y * y) + body->unit[2] * (z * z));
}

// The square of the angle by which ω circles in a step, or more.
TIMESTEP_C_INLINE TIMESTEP_REAL TIMESTEP_NAME(timestep_circled2)(const TIMESTEP_BODY* body,
                                                                 const TIMESTEP_REAL w[3],
                                                                 TIMESTEP_REAL h) {
    const TIMESTEP_REAL x = h * w[0], y = h * w[1], z = h * w[2];
    return body->circling[0] * (x * x) +
           (body->circling[1] * (y * y) + body->circling[2] * (z * z));
}
// Scales ω to the energy that it had before; in parts of a step, whose angles are such that their
// squares are numbers.
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_scale_back)(const TIMESTEP_BODY* body,
                                                          const TIMESTEP_REAL before[3],
                                                          TIMESTEP_REAL w[3], TIMESTEP_REAL part) {
    const TIMESTEP_REAL E1 = TIMESTEP_NAME(timestep_energy)(body, before, part);
    const TIMESTEP_REAL E2 = TIMESTEP_NAME(timestep_energy)(body, w, part);
    const TIMESTEP_REAL share = E2 > 0 ? (E1 - E2) / (E2 + TIMESTEP_NAME(sqrt)(E1 * E2)) : 0;
    w[0] = w[0] + share * w[0];
    w[1] = w[1] + share * w[1];
    w[2] = w[2] + share * w[2];
}
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_calm_half_step)(const TIMESTEP_BODY* body,
                                                              TIMESTEP_REAL w[3], TIMESTEP_REAL h) {
    const TIMESTEP_REAL circled2 = TIMESTEP_NAME(timestep_circled2)(body, w, h);
    TIMESTEP_REAL part = h, parts = 1, n, before[3];
    before[0] = w[0], before[1] = w[1], before[2] = w[2];
    if (circled2 > TIMESTEP_NUMBER(0.25)) {  // half a radian
        const TIMESTEP_REAL wanted =
            TIMESTEP_NAME(ceil)(TIMESTEP_NAME(sqrt)(circled2) / TIMESTEP_NUMBER(0.5));
        part = h / wanted;
        parts = wanted < 32 ? wanted : 32;
    }
    for (n = 0; n < parts; n += 1) TIMESTEP_NAME(timestep_half_step)(body, w, part, 1);
    TIMESTEP_NAME(timestep_scale_back)(body, before, w, part);
}

// The long way, for any numbers. (No pointer to a function for the rule: some compilers then cannot
// inline what they are told to.) Has ω changed?
TIMESTEP_C_APART int TIMESTEP_NAME(timestep_take_with_care)(const TIMESTEP_BODY* body,
                                                            TIMESTEP_REAL w[3], TIMESTEP_REAL h,
                                                            int rule) {
    TIMESTEP_REAL c;
    if (h == 0 || TIMESTEP_NAME(gyroscopic_idle)(body, w)) return 0;
    c = TIMESTEP_NAME(timestep_tame)(body, w, h) ? 1 : TIMESTEP_NAME(timestep_taming)(body, w, &h);
    if (c == 0) return 0;
    if (body->kind == 1)
        TIMESTEP_NAME(timestep_turn_about_odd)(body, w, h);
    else if (rule == 0)
        TIMESTEP_NAME(timestep_passive)(body, w, h);
    else if (rule == 1)
        TIMESTEP_NAME(timestep_half_step)(body, w, h, 1);
    else
        TIMESTEP_NAME(timestep_calm_half_step)(body, w, h);
    w[0] *= c, w[1] *= c, w[2] *= c;
    return 1;
}

// The short way takes its formula and looks whether the result is a number: if no product
// overflows, it is. About a principal axis most give back every bit, and so does the scaling; the
// passive step of three moments does not, so of the product of two of the numbers that it has made
// must not be zero.

// The columns of R are the body's axes in the world.
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_matrix)(const TIMESTEP_REAL q[4],
                                                      TIMESTEP_REAL R[3][3]) {
    const TIMESTEP_REAL tx = 2 * q[0], ty = 2 * q[1], tz = 2 * q[2];
    const TIMESTEP_REAL twx = tx * q[3], twy = ty * q[3], twz = tz * q[3];
    const TIMESTEP_REAL txx = tx * q[0], txy = ty * q[0], txz = tz * q[0];
    const TIMESTEP_REAL tyy = ty * q[1], tyz = tz * q[1], tzz = tz * q[2];
    R[0][0] = 1 - (tyy + tzz), R[0][1] = txy - twz, R[0][2] = txz + twy;
    R[1][0] = txy + twz, R[1][1] = 1 - (txx + tzz), R[1][2] = tyz - twx;
    R[2][0] = txz - twy, R[2][1] = tyz + twx, R[2][2] = 1 - (txx + tyy);
}
// ω into the body.
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_in_body)(TIMESTEP_REAL R[3][3],
                                                       const TIMESTEP_REAL omega[3],
                                                       TIMESTEP_REAL w[3]) {
    TIMESTEP_REAL x = R[0][0] * omega[0] + R[1][0] * omega[1] + R[2][0] * omega[2];
    TIMESTEP_REAL y = R[0][1] * omega[0] + R[1][1] * omega[1] + R[2][1] * omega[2];
    TIMESTEP_REAL z = R[0][2] * omega[0] + R[1][2] * omega[1] + R[2][2] * omega[2];
    TIMESTEP_C_ALONE(x);
    TIMESTEP_C_ALONE(y);
    TIMESTEP_C_ALONE(z);
    w[0] = x, w[1] = y, w[2] = z;
}
// And its change back: rounded, R is no exact rotation, so not all of it
// (after_gyroscopic_torque()).
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_change)(TIMESTEP_REAL R[3][3],
                                                      const TIMESTEP_REAL before[3],
                                                      const TIMESTEP_REAL w[3],
                                                      TIMESTEP_REAL omega[3]) {
#if defined(__clang__) && \
    defined(__GNUC__)  // shown a pair, it takes two numbers at once from here on
    typedef TIMESTEP_REAL pair __attribute__((vector_size(2 * sizeof(TIMESTEP_REAL))));
    const pair after_xy = {w[0], w[1]}, before_xy = {before[0], before[1]},
               xy = after_xy - before_xy;
    const TIMESTEP_REAL x = xy[0], y = xy[1], z = w[2] - before[2];
#else
    const TIMESTEP_REAL x = w[0] - before[0], y = w[1] - before[1], z = w[2] - before[2];
#endif
    const TIMESTEP_REAL X = R[0][0] * x + R[0][1] * y + R[0][2] * z;
    const TIMESTEP_REAL Y = R[1][0] * x + R[1][1] * y + R[1][2] * z;
    const TIMESTEP_REAL Z = R[2][0] * x + R[2][1] * y + R[2][2] * z;
    omega[0] = omega[0] + X, omega[1] = omega[1] + Y, omega[2] = omega[2] + Z;
}

// The long way in the world.
TIMESTEP_C_APART void TIMESTEP_NAME(timestep_take_with_care_in_world)(const TIMESTEP_BODY* body,
                                                                      const TIMESTEP_REAL q[4],
                                                                      TIMESTEP_REAL omega[3],
                                                                      TIMESTEP_REAL h, int rule) {
    TIMESTEP_REAL R[3][3], before[3], w[3];
    TIMESTEP_NAME(timestep_matrix)(q, R);
    TIMESTEP_NAME(timestep_in_body)(R, omega, before);
    w[0] = before[0], w[1] = before[1], w[2] = before[2];
    if (TIMESTEP_NAME(timestep_take_with_care)(body, w, h, rule))
        TIMESTEP_NAME(timestep_change)(R, before, w, omega);
}

// Two equal moments; or a ball, for which there is nothing to do.
TIMESTEP_C_APART void TIMESTEP_NAME(timestep_take_odd)(const TIMESTEP_BODY* body,
                                                       TIMESTEP_REAL omega[3], TIMESTEP_REAL h) {
    if (body->kind == 0) return;
    if (!TIMESTEP_NAME(timestep_turn_about_odd)(body, omega, h))
        TIMESTEP_NAME(timestep_take_with_care)(body, omega, h, 0);
}
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_symmetric_in_world)(const TIMESTEP_BODY* body,
                                                                 const TIMESTEP_REAL q[4],
                                                                 TIMESTEP_REAL omega[3],
                                                                 TIMESTEP_REAL h, int i, int j,
                                                                 int k) {
    TIMESTEP_REAL R[3][3], before[3], w[3], x, y, X, Y, Z, sum;
    TIMESTEP_NAME(timestep_matrix)(q, R);
    TIMESTEP_NAME(timestep_in_body)(R, omega, before);
    w[0] = before[0], w[1] = before[1], w[2] = before[2];
    TIMESTEP_NAME(timestep_shears)(body, w, h, i, j, k);
    x = w[i] - before[i], y = w[j] - before[j];
    X = omega[0] + (R[0][i] * x + R[0][j] * y);
    Y = omega[1] + (R[1][i] * x + R[1][j] * y);
    Z = omega[2] + (R[2][i] * x + R[2][j] * y);
    TIMESTEP_C_ALONE(X);
    TIMESTEP_C_ALONE(Y);
    TIMESTEP_C_ALONE(Z);
    sum = X + Y + Z;
    sum -= sum;
    if (sum != sum) return 0;
    omega[0] = X, omega[1] = Y, omega[2] = Z;
    return 1;
}
TIMESTEP_C_APART void TIMESTEP_NAME(timestep_take_odd_in_world)(const TIMESTEP_BODY* body,
                                                                const TIMESTEP_REAL q[4],
                                                                TIMESTEP_REAL omega[3],
                                                                TIMESTEP_REAL h) {
    if (body->kind == 0) return;
    if (body->odd == 2   ? TIMESTEP_NAME(timestep_symmetric_in_world)(body, q, omega, h, 0, 1, 2)
        : body->odd == 1 ? TIMESTEP_NAME(timestep_symmetric_in_world)(body, q, omega, h, 2, 0, 1)
                         : TIMESTEP_NAME(timestep_symmetric_in_world)(body, q, omega, h, 1, 2, 0))
        return;
    TIMESTEP_NAME(timestep_take_with_care_in_world)(body, q, omega, h, 0);
}

// Three moments, the short way. Was that enough?
#ifdef TIMESTEP_C_LANES
#include <timestep/gyroscopic/lanes.h>
#else
// Was it possible?
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_by_rule)(int rule, const TIMESTEP_BODY* body,
                                                      TIMESTEP_REAL w[3], TIMESTEP_REAL h) {
    TIMESTEP_REAL before[3];
    before[0] = w[0], before[1] = w[1], before[2] = w[2];
    if (rule == 0)
        TIMESTEP_NAME(timestep_passive)(body, w, h);
    else {
        if (rule == 2 && !(TIMESTEP_NAME(timestep_circled2)(body, w, h) <= TIMESTEP_NUMBER(0.25)))
            return 0;
        TIMESTEP_NAME(timestep_half_step)(body, w, h, 0);
        if (rule == 2) TIMESTEP_NAME(timestep_scale_back)(body, before, w, h);
    }
    return 1;
}
// Are x, y and z numbers? For the passive step, which gives back ω in the body, a product of two of
// ω's numbers must not be zero: it is about a principal axis, and where the step divides by
// infinity.
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_good)(int rule, const TIMESTEP_REAL w[3],
                                                   TIMESTEP_REAL x, TIMESTEP_REAL y,
                                                   TIMESTEP_REAL z) {
    TIMESTEP_REAL sum = x + y + z;
    sum -= sum;
    return rule == 0 ? TIMESTEP_C_NOT_ZERO(w[0] * w[1] + sum) : sum == sum;
}
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_take_three)(int rule, const TIMESTEP_BODY* body,
                                                         TIMESTEP_REAL omega[3], TIMESTEP_REAL h) {
    TIMESTEP_REAL w[3];
    w[0] = omega[0], w[1] = omega[1], w[2] = omega[2];
    if (!TIMESTEP_NAME(timestep_by_rule)(rule, body, w, h) ||
        !TIMESTEP_NAME(timestep_good)(rule, w, w[0], w[1], w[2]))
        return 0;
    omega[0] = w[0], omega[1] = w[1], omega[2] = w[2];
    return 1;
}
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_take_three_in_world)(int rule,
                                                                  const TIMESTEP_BODY* body,
                                                                  const TIMESTEP_REAL q[4],
                                                                  TIMESTEP_REAL omega[3],
                                                                  TIMESTEP_REAL h) {
    TIMESTEP_REAL R[3][3], before[3], w[3], after[3];
    TIMESTEP_NAME(timestep_matrix)(q, R);
    TIMESTEP_NAME(timestep_in_body)(R, omega, before);
    w[0] = before[0], w[1] = before[1], w[2] = before[2];
    if (!TIMESTEP_NAME(timestep_by_rule)(rule, body, w, h)) return 0;
    after[0] = omega[0], after[1] = omega[1], after[2] = omega[2];
    TIMESTEP_NAME(timestep_change)(R, before, w, after);
    if (!TIMESTEP_NAME(timestep_good)(rule, w, after[0], after[1], after[2])) return 0;
    omega[0] = after[0], omega[1] = after[1], omega[2] = after[2];
    return 1;
}
#endif

// A rule with all that every rule asks before and after.
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_take)(int rule, const TIMESTEP_BODY* body,
                                                    TIMESTEP_REAL omega[3], TIMESTEP_REAL h) {
    if (body->kind != 2)
        TIMESTEP_NAME(timestep_take_odd)(body, omega, h);
    else if (!TIMESTEP_NAME(timestep_take_three)(rule, body, omega, h))
        TIMESTEP_NAME(timestep_take_with_care)(body, omega, h, rule);
}
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_take_in_world)(int rule, const TIMESTEP_BODY* body,
                                                             const TIMESTEP_REAL q[4],
                                                             TIMESTEP_REAL omega[3],
                                                             TIMESTEP_REAL h) {
    if (body->kind != 2)
        TIMESTEP_NAME(timestep_take_odd_in_world)(body, q, omega, h);
    else if (!TIMESTEP_NAME(timestep_take_three_in_world)(rule, body, q, omega, h))
        TIMESTEP_NAME(timestep_take_with_care_in_world)(body, q, omega, h, rule);
}

#define TIMESTEP_RULE(rule, in_body, in_world)                                                   \
    static inline void TIMESTEP_NAME(in_body)(const TIMESTEP_BODY* body, TIMESTEP_REAL omega[3], \
                                              TIMESTEP_REAL h) {                                 \
        TIMESTEP_NAME(timestep_take)(rule, body, omega, h);                                      \
    }                                                                                            \
    static inline void TIMESTEP_NAME(in_world)(const TIMESTEP_BODY* body,                        \
                                               const TIMESTEP_REAL q[4], TIMESTEP_REAL omega[3], \
                                               TIMESTEP_REAL h) {                                \
        TIMESTEP_NAME(timestep_take_in_world)(rule, body, q, omega, h);                          \
    }
TIMESTEP_RULE(0, gyroscopic_passive, gyroscopic_passive_in_world)
TIMESTEP_RULE(1, gyroscopic_half_step, gyroscopic_half_step_in_world)
TIMESTEP_RULE(2, gyroscopic_calm_half_step, gyroscopic_calm_half_step_in_world)
#undef TIMESTEP_RULE
/// \endcond
