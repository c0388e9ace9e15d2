/* What in_your_engine.md shows: a rule in an engine's step, in C. */
#include "taken_home.h"

// [taken]
void after_loading(Body* b) {
    const float* inverse = b->inverse_moments;
    b->gyroscopic = gyroscopic_from_inverse_momentsf(inverse[0], inverse[1], inverse[2]);
}

/* Each line for all bodies, before the next one. */
void step(Body* b, float h) {
    gyroscopic_calm_half_step_in_worldf(&b->gyroscopic, b->q, b->omega, h / 2);
    solve_contacts_and_joints(b, h);
    gyroscopic_calm_half_step_in_worldf(&b->gyroscopic, b->q, b->omega, h / 2);
    turn(b, h);
}
// [taken]
