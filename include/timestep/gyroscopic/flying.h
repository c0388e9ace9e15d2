// SPDX-License-Identifier: MIT
/// \file
/// What stands behind gyroscopic.h, for one kind of real number: the body that flies, and limits.
/// As rules.h, it is included there twice. The formulas are explained in axis_spin.hpp and
/// ball_and_remainder.hpp.

/// \cond
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_times)(const TIMESTEP_REAL a[4],
                                                     const TIMESTEP_REAL b[4],
                                                     TIMESTEP_REAL product[4]) {
    product[3] = a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];
    product[0] = a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1];
    product[1] = a[3] * b[1] + a[1] * b[3] + a[2] * b[0] - a[0] * b[2];
    product[2] = a[3] * b[2] + a[2] * b[3] + a[0] * b[1] - a[1] * b[0];
}

// q turned by the constant angular velocity v/s for s seconds, v in the body's axes.
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_turn)(TIMESTEP_REAL q[4], TIMESTEP_REAL x,
                                                    TIMESTEP_REAL y, TIMESTEP_REAL z) {
    const TIMESTEP_REAL half = TIMESTEP_NAME(sqrt)(x * x + (y * y + z * z)) / 2;
    TIMESTEP_REAL sine, cosine, share, turn[4], turned[4];
    TIMESTEP_NAME(timestep_sine_cosine)(half, &sine, &cosine);
    share = half > 0 ? sine / half / 2 : TIMESTEP_NUMBER(0.5);
    turn[0] = share * x, turn[1] = share * y, turn[2] = share * z, turn[3] = cosine;
    TIMESTEP_NAME(timestep_times)(q, turn, turned);
    q[0] = turned[0], q[1] = turned[1], q[2] = turned[2], q[3] = turned[3];
}

TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_over_its_length)(TIMESTEP_REAL q[4]) {
    const TIMESTEP_REAL length =
        TIMESTEP_NAME(sqrt)(q[0] * q[0] + q[1] * q[1] + (q[2] * q[2] + q[3] * q[3]));
    if (length > 0) q[0] /= length, q[1] /= length, q[2] /= length, q[3] /= length;
}

// A turn by `angle` about the body's axis i; L, at rest in the world, turns the other way in the
// body (AxisSpin).
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_spin)(TIMESTEP_REAL v[4], TIMESTEP_REAL L[3], int i,
                                                    TIMESTEP_REAL angle) {
    const int j = i < 2 ? i + 1 : 0, k = 3 - i - j;
    const TIMESTEP_REAL Lj = L[j], Lk = L[k], w = v[3], vi = v[i], vj = v[j], vk = v[k];
    TIMESTEP_REAL c, s, less, sine;
    TIMESTEP_NAME(timestep_sine_cosine)(angle / 2, &s, &c);
    less = 2 * s * s, sine = 2 * s * c;
    L[j] += sine * Lk - less * Lj;
    L[k] -= sine * Lj + less * Lk;
    v[3] = c * w - s * vi;
    v[i] = c * vi + s * w;
    v[j] = c * vj + s * vk;
    v[k] = c * vk - s * vj;
}

// A ball's turn, and then the parts of a and b in turns, `pairs` of each and one of a. Has ω
// changed?
TIMESTEP_C_INLINE int TIMESTEP_NAME(timestep_fly)(const TIMESTEP_BODY* body, TIMESTEP_REAL q[4],
                                                  TIMESTEP_REAL w[3], TIMESTEP_REAL h,
                                                  const TIMESTEP_REAL a[], const TIMESTEP_REAL b[],
                                                  int pairs) {
    const TIMESTEP_REAL* U = body->unit;
    const int r = body->middle, i = r < 2 ? r + 1 : 0, j = 3 - r - i;
    const TIMESTEP_REAL A = -body->ratio[j] * U[j] * U[j], B = body->ratio[i] * U[i] * U[i],
                        ball = 1 / U[r];
    const TIMESTEP_REAL x = w[0], y = w[1], z = w[2];
    TIMESTEP_REAL c, L[3];
    int n;
    if (h == 0 || (x == 0 && y == 0 && z == 0)) return 0;
    c = TIMESTEP_NAME(timestep_tame)(body, w, h) ? 1 : TIMESTEP_NAME(timestep_taming)(body, w, &h);
    if (c == 0) return 0;
    if (TIMESTEP_NAME(gyroscopic_idle)(body, w)) {
        TIMESTEP_NAME(timestep_turn)(q, h * w[0], h * w[1], h * w[2]);
        TIMESTEP_NAME(timestep_over_its_length)(q);
        w[0] = x, w[1] = y, w[2] = z;
        return 0;
    }
    L[0] = U[0] * w[0], L[1] = U[1] * w[1], L[2] = U[2] * w[2];
    TIMESTEP_NAME(timestep_turn)(q, h * (ball * L[0]), h * (ball * L[1]), h * (ball * L[2]));
    for (n = 0; n < pairs; ++n) {
        TIMESTEP_NAME(timestep_spin)(q, L, i, a[n] * h * (A * L[i]));
        TIMESTEP_NAME(timestep_spin)(q, L, j, b[n] * h * (B * L[j]));
    }
    TIMESTEP_NAME(timestep_spin)(q, L, i, a[pairs] * h * (A * L[i]));
    TIMESTEP_NAME(timestep_over_its_length)(q);
    w[0] = L[0] / U[0] * c, w[1] = L[1] / U[1] * c, w[2] = L[2] / U[2] * c;
    return 1;
}

static inline int TIMESTEP_NAME(timestep_fly_2)(const TIMESTEP_BODY* body, TIMESTEP_REAL q[4],
                                                TIMESTEP_REAL w[3], TIMESTEP_REAL h) {
    const TIMESTEP_REAL a[2] = {TIMESTEP_NUMBER(0.5), TIMESTEP_NUMBER(0.5)}, b[1] = {1};
    return TIMESTEP_NAME(timestep_fly)(body, q, w, h, a, b, 1);
}
static inline int TIMESTEP_NAME(timestep_fly_4)(const TIMESTEP_BODY* body, TIMESTEP_REAL q[4],
                                                TIMESTEP_REAL w[3], TIMESTEP_REAL h) {
    const TIMESTEP_REAL a1 = TIMESTEP_NUMBER(0.0792036964311957),
                        a2 = TIMESTEP_NUMBER(0.353172906049774),
                        a3 = TIMESTEP_NUMBER(-0.0420650803577195),
                        b1 = TIMESTEP_NUMBER(0.209515106613362),
                        b2 = TIMESTEP_NUMBER(-0.143851773179818);
    const TIMESTEP_REAL a4 = 1 - 2 * (a1 + a2 + a3), b3 = TIMESTEP_NUMBER(0.5) - b1 - b2;
    TIMESTEP_REAL a[7], b[6];
    a[0] = a[6] = a1, a[1] = a[5] = a2, a[2] = a[4] = a3, a[3] = a4;
    b[0] = b[5] = b1, b[1] = b[4] = b2, b[2] = b[3] = b3;
    return TIMESTEP_NAME(timestep_fly)(body, q, w, h, a, b, 6);
}

// q v q*/|q|², and with back = −1 q* v q/|q|²: rounded, q has not quite the length one. In `double`
// for `float`, too: the errors of all of ω's turn are no chance, and in `float` an hour of them
// adds a percent to the energy.
TIMESTEP_C_INLINE void TIMESTEP_NAME(timestep_rotate)(const TIMESTEP_REAL q[4], double back,
                                                      const TIMESTEP_REAL v[3],
                                                      TIMESTEP_REAL out[3]) {
    const double x = back * TIMESTEP_C_AS(double, q[0]), y = back * TIMESTEP_C_AS(double, q[1]);
    const double z = back * TIMESTEP_C_AS(double, q[2]), w = TIMESTEP_C_AS(double, q[3]);
    const double X = TIMESTEP_C_AS(double, v[0]), Y = TIMESTEP_C_AS(double, v[1]),
                 Z = TIMESTEP_C_AS(double, v[2]);
    const double q2 = x * x + y * y + (z * z + w * w), two = q2 > 0 ? 2 / q2 : 2;
    const double a = two * (y * Z - z * Y), b = two * (z * X - x * Z), c = two * (x * Y - y * X);
    out[0] = TIMESTEP_C_AS(TIMESTEP_REAL, X + w * a + (y * c - z * b));
    out[1] = TIMESTEP_C_AS(TIMESTEP_REAL, Y + w * b + (z * a - x * c));
    out[2] = TIMESTEP_C_AS(TIMESTEP_REAL, Z + w * c + (x * b - y * a));
}

static inline void TIMESTEP_NAME(gyroscopic_ball_and_remainder_2)(const TIMESTEP_BODY* body,
                                                                  TIMESTEP_REAL q[4],
                                                                  TIMESTEP_REAL omega[3],
                                                                  TIMESTEP_REAL h) {
    TIMESTEP_NAME(timestep_fly_2)(body, q, omega, h);
}
static inline void TIMESTEP_NAME(gyroscopic_ball_and_remainder_4)(const TIMESTEP_BODY* body,
                                                                  TIMESTEP_REAL q[4],
                                                                  TIMESTEP_REAL omega[3],
                                                                  TIMESTEP_REAL h) {
    TIMESTEP_NAME(timestep_fly_4)(body, q, omega, h);
}
static inline void TIMESTEP_NAME(gyroscopic_ball_and_remainder_2_in_world)(
    const TIMESTEP_BODY* body, TIMESTEP_REAL q[4], TIMESTEP_REAL omega[3], TIMESTEP_REAL h) {
    TIMESTEP_REAL w[3];
    TIMESTEP_NAME(timestep_rotate)(q, -1, omega, w);
    if (TIMESTEP_NAME(timestep_fly_2)(body, q, w, h))
        TIMESTEP_NAME(timestep_rotate)(q, 1, w, omega);
}
static inline void TIMESTEP_NAME(gyroscopic_ball_and_remainder_4_in_world)(
    const TIMESTEP_BODY* body, TIMESTEP_REAL q[4], TIMESTEP_REAL omega[3], TIMESTEP_REAL h) {
    TIMESTEP_REAL w[3];
    TIMESTEP_NAME(timestep_rotate)(q, -1, omega, w);
    if (TIMESTEP_NAME(timestep_fly_4)(body, q, w, h))
        TIMESTEP_NAME(timestep_rotate)(q, 1, w, omega);
}

// ω over the largest of its numbers, so that squares neither overflow nor vanish; gives back that
// number.
TIMESTEP_C_INLINE TIMESTEP_REAL TIMESTEP_NAME(timestep_scaled)(const TIMESTEP_REAL w[3],
                                                               TIMESTEP_REAL n[3]) {
    const TIMESTEP_REAL size = TIMESTEP_NAME(fmax)(
        TIMESTEP_NAME(fabs)(w[0]),
        TIMESTEP_NAME(fmax)(TIMESTEP_NAME(fabs)(w[1]), TIMESTEP_NAME(fabs)(w[2])));
    const TIMESTEP_REAL by = size > 0 ? size : 1;
    n[0] = w[0] / by, n[1] = w[1] / by, n[2] = w[2] / by;
    return size;
}

// On the curve of its energy and |L|, |ω|² is largest where the component about the intermediate
// axis r is zero, and is then |ω|² + c_r ω_r², with c_r the circling of r.
static inline TIMESTEP_REAL TIMESTEP_NAME(gyroscopic_fastest)(const TIMESTEP_BODY* body,
                                                              const TIMESTEP_REAL omega[3]) {
    const int r = body->middle;
    TIMESTEP_REAL x, y, z, fastest, n[3];
    const TIMESTEP_REAL size = TIMESTEP_NAME(timestep_scaled)(omega, n);
    x = n[0] * n[0], y = n[1] * n[1], z = n[2] * n[2];
    fastest = size * TIMESTEP_NAME(sqrt)(x + y + z + body->circling[r] * (n[r] * n[r]));
    return fastest > TIMESTEP_LARGEST ? TIMESTEP_LARGEST : fastest;
}

// The half-step Jacobian keeps the energy over Δ, its determinant for the component about the
// intermediate axis alone: Δ = 1 − h² p/4 with p = c_r ω_r², of which the curve's largest value is
// p + min(c_i ω_i², c_j ω_j²). Where h² times that is at most ¼, Δ is 15/16 or more, and the energy
// at most 16/15 of the first.
static inline TIMESTEP_REAL TIMESTEP_NAME(gyroscopic_half_step_limit)(
    const TIMESTEP_BODY* body, const TIMESTEP_REAL omega[3]) {
    const int r = body->middle, i = (r + 1) % 3, j = (r + 2) % 3;
    const TIMESTEP_REAL* c = body->circling;
    TIMESTEP_REAL n[3], p, limit;
    const TIMESTEP_REAL size = TIMESTEP_NAME(timestep_scaled)(omega, n);
    p = c[r] * (n[r] * n[r]) + TIMESTEP_NAME(fmin)(c[i] * (n[i] * n[i]), c[j] * (n[j] * n[j]));
    if (!(size > 0 && p > 0)) return TIMESTEP_LARGEST;
    limit = TIMESTEP_NUMBER(0.5) / TIMESTEP_NAME(sqrt)(p) / size;
    return limit <= TIMESTEP_LARGEST ? limit : TIMESTEP_LARGEST;
}
/// \endcond
