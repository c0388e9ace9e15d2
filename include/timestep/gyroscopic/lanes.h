// SPDX-License-Identifier: MIT
/// \file
/// What stands behind gyroscopic.h in `float`, where the compiler (of GNU's kind) and the processor
/// have vectors of four lanes: the short way of rules.h with x, y and z side by side. Each number
/// is made of the same numbers in the same order as there, so it has the same bits where both ways
/// are enough, as a test finds for h up to a second and h|ω| up to a million. For the passive step
/// they ask another product whether they are: in longer steps one may be where the other is not.
/// The fourth lane is nobody's.

/// \cond
typedef float timestep_lanes __attribute__((vector_size(16)));
#define TIMESTEP_YZX(v) __builtin_shufflevector(v, v, 1, 2, 0, 3)
#define TIMESTEP_ZXY(v) __builtin_shufflevector(v, v, 2, 0, 1, 3)
#define TIMESTEP_ALL(v, i) __builtin_shufflevector(v, v, i, i, i, i)
// a's x, b's x, a's y and b's y.
#define TIMESTEP_IN_TURNS(a, b) __builtin_shufflevector(a, b, 0, 4, 1, 5)
// a's x, b's y and c's z.
#define TIMESTEP_DIAGONAL(a, b, c) __builtin_shufflevector(TIMESTEP_IN_TURNS(a, b), c, 0, 3, 6, 7)

TIMESTEP_C_INLINE timestep_lanes timestep_of_three(const float v[3]) {
    timestep_lanes lanes = {v[0], v[1], v[2], 0};
    TIMESTEP_C_ALONE(lanes);  // g++ makes each permutation anew from the numbers in memory
    return lanes;
}
TIMESTEP_C_INLINE timestep_lanes timestep_of_four(const float v[4]) {
    timestep_lanes lanes;
    __builtin_memcpy(&lanes, v, sizeof lanes);
    return lanes;
}

// *idle is zero about a principal axis, and where the step divides by infinity.
TIMESTEP_C_INLINE timestep_lanes timestep_passive_lanes(const gyroscopic_bodyf* body,
                                                        timestep_lanes w, float h, float* idle) {
    const timestep_lanes U = timestep_of_four(body->unit);
    const timestep_lanes l = h * (U * w), Ull = U * l * l, ll = l * l;
    const timestep_lanes p =
        h * timestep_of_four(body->ratio) * TIMESTEP_YZX(w);  // a0 y, a1 z, a2 x
    const timestep_lanes s = 1 / (1 + (Ull[0] + Ull[1] + Ull[2])) * w;
    *idle = p[0] * s[0];
    return s - p * TIMESTEP_ZXY(s) + (ll[0] + (ll[1] + ll[2])) * U * s;
}

TIMESTEP_C_INLINE timestep_lanes timestep_half_step_lanes(const gyroscopic_bodyf* body,
                                                          timestep_lanes w, float h) {
    const timestep_lanes one = {1, 1, 1, 1};
    const timestep_lanes a = h / 2 * timestep_of_four(body->ratio);
    const timestep_lanes p = a * TIMESTEP_YZX(w),
                         q = a * TIMESTEP_ZXY(w);  // cx, ay, bz; bx, cy, az
    const timestep_lanes half = p * TIMESTEP_ZXY(w), r = half + half;
    const timestep_lanes d = one - TIMESTEP_ZXY(p) * TIMESTEP_YZX(q);  // bc0, ca1, ab2
    const timestep_lanes e = TIMESTEP_ZXY(p) * p - q;                  // bc1, ca2, ab0
    const timestep_lanes f = q * TIMESTEP_YZX(q) - p;                  // bc2, ca0, ab1
    const float share = 1 / (d[0] + (p[1] * e[0] + q[2] * f[0]));
    return w - share * (TIMESTEP_ALL(r, 0) * TIMESTEP_DIAGONAL(d, f, e) +
                        (TIMESTEP_ALL(r, 1) * TIMESTEP_DIAGONAL(e, d, f) +
                         TIMESTEP_ALL(r, 2) * TIMESTEP_DIAGONAL(f, e, d)));
}

// timestep_by_rulef() in lanes: was it possible?
TIMESTEP_C_INLINE int timestep_take_lanes(int rule, const gyroscopic_bodyf* body,
                                          timestep_lanes* omega, float h, float* idle) {
    timestep_lanes w = *omega;
    if (rule == 0)
        w = timestep_passive_lanes(body, w, h, idle);
    else if (rule == 1)
        w = timestep_half_step_lanes(body, w, h);
    else {
        const timestep_lanes U = timestep_of_four(body->unit), angle = h * w,
                             square = angle * angle;
        const timestep_lanes circled = timestep_of_four(body->circling) * square,
                             before = U * square;
        timestep_lanes after;
        float E1, E2;
        if (!(circled[0] + (circled[1] + circled[2]) <= 0.25f)) return 0;
        w = timestep_half_step_lanes(body, w, h);
        after = h * w;
        after = U * (after * after);
        E1 = before[0] + (before[1] + before[2]), E2 = after[0] + (after[1] + after[2]);
        w = w + (E1 - E2) / (E2 + sqrtf(E1 * E2)) * w;  // no number where E2 is zero
    }
    *omega = w;
    return 1;
}
// timestep_goodf() in lanes.
TIMESTEP_C_INLINE int timestep_good_lanes(int rule, timestep_lanes w, float idle) {
    float sum = w[0] + w[1] + w[2];
    sum -= sum;
    return rule == 0 ? TIMESTEP_C_NOT_ZERO(idle + sum)
                     : sum == sum;  // no number is no greater, and no less
}

TIMESTEP_C_INLINE int timestep_take_threef(int rule, const gyroscopic_bodyf* body, float omega[3],
                                           float h) {
    timestep_lanes w = timestep_of_three(omega);
    float idle = 0;
    if (!timestep_take_lanes(rule, body, &w, h, &idle) || !timestep_good_lanes(rule, w, idle))
        return 0;
    omega[0] = w[0], omega[1] = w[1], omega[2] = w[2];
    return 1;
}

TIMESTEP_C_INLINE int timestep_take_three_in_worldf(int rule, const gyroscopic_bodyf* body,
                                                    const float orientation[4], float omega[3],
                                                    float h) {
    const timestep_lanes one = {1, 1, 1, 1};
    timestep_lanes q, twice, twice_w, product, diagonal, plus, minus, row0, row1, row2, xy, z, w,
        before, after;
    float idle = 0;
    q = timestep_of_four(orientation);
    twice = q + q;
    twice_w = twice * TIMESTEP_ALL(q, 3);
    product = TIMESTEP_YZX(q) * TIMESTEP_ZXY(twice);  // tyz, txz, txy
    plus = TIMESTEP_ZXY(product + twice_w),
    minus = TIMESTEP_YZX(product - twice_w);  // R10, R21, R02; R20, R01, R12
    diagonal = q * twice;
    diagonal = one - (TIMESTEP_YZX(diagonal) + TIMESTEP_ZXY(diagonal));
    row0 = TIMESTEP_DIAGONAL(diagonal, minus, plus);
    row1 = TIMESTEP_DIAGONAL(plus, diagonal, minus);
    row2 = TIMESTEP_DIAGONAL(minus, plus, diagonal);

    w = timestep_of_three(omega);
    before = row0 * TIMESTEP_ALL(w, 0) + row1 * TIMESTEP_ALL(w, 1) + row2 * TIMESTEP_ALL(w, 2);
    after = before;
    if (!timestep_take_lanes(rule, body, &after, h, &idle)) return 0;
    after = after - before;
    xy = TIMESTEP_IN_TURNS(row0, row1), z = __builtin_shufflevector(row0, row1, 2, 6, 3, 7);
    w = w + (TIMESTEP_ALL(after, 0) * __builtin_shufflevector(xy, row2, 0, 1, 4, 7) +
             TIMESTEP_ALL(after, 1) * __builtin_shufflevector(xy, row2, 2, 3, 5, 7) +
             TIMESTEP_ALL(after, 2) * __builtin_shufflevector(z, row2, 0, 1, 6, 7));
    if (!timestep_good_lanes(rule, w, idle)) return 0;
    omega[0] = w[0], omega[1] = w[1], omega[2] = w[2];
    return 1;
}
#undef TIMESTEP_YZX
#undef TIMESTEP_ZXY
#undef TIMESTEP_ALL
#undef TIMESTEP_IN_TURNS
#undef TIMESTEP_DIAGONAL
/// \endcond
