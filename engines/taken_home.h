#pragma once
/* A body as an engine may have it. */

#include <timestep/gyroscopic.h>

typedef struct Body {
    float q[4], omega[3];     /* the orientation, x, y, z, w; rad/s in the world */
    float inverse_moments[3]; /* about the body's own axes, 1/(kg m^2); zero: locked */
    gyroscopic_bodyf gyroscopic;
} Body;

#ifdef __cplusplus
extern "C" {
#endif
void after_loading(Body* b);
void step(Body* b, float h);
/* The engine's own: here the test's. */
void solve_contacts_and_joints(Body* b, float h);
void turn(Body* b, float h);
#ifdef __cplusplus
}
#endif
