#pragma once
// Every function of gyroscopic.h, as a C compiler has made it.

#include <timestep/gyroscopic.h>

#define CALLS(NAME, BODY, REAL)                                                   \
    typedef struct NAME {                                                         \
        BODY (*from_moments)(REAL, REAL, REAL);                                   \
        BODY (*from_inverse_moments)(REAL, REAL, REAL);                           \
        int (*idle)(const BODY*, const REAL*);                                    \
        void (*rule[3])(const BODY*, REAL*, REAL); /* passive, half-step, calm */ \
        void (*rule_in_world[3])(const BODY*, const REAL*, REAL*, REAL);          \
        void (*fly[2])(const BODY*, REAL*, REAL*, REAL); /* of order 2 and 4 */   \
        void (*fly_in_world[2])(const BODY*, REAL*, REAL*, REAL);                 \
        REAL (*fastest)(const BODY*, const REAL*);                                \
        REAL (*half_step_limit)(const BODY*, const REAL*);                        \
    } NAME;
CALLS(Calls, gyroscopic_body, double)
CALLS(Callsf, gyroscopic_bodyf, float)

#ifdef __cplusplus
extern "C" {
#endif
extern const Calls calls;
extern const Callsf callsf;
#ifdef __cplusplus
}
#endif
