/* C99 and nothing else, with every warning that an engine may have on. (<complex.h> has a macro I.) */
#include <complex.h>

#include "calls.h"

const Calls calls = {gyroscopic_from_moments,
                     gyroscopic_from_inverse_moments,
                     gyroscopic_idle,
                     {gyroscopic_passive, gyroscopic_half_step, gyroscopic_calm_half_step},
                     {gyroscopic_passive_in_world, gyroscopic_half_step_in_world, gyroscopic_calm_half_step_in_world},
                     {gyroscopic_ball_and_remainder_2, gyroscopic_ball_and_remainder_4},
                     {gyroscopic_ball_and_remainder_2_in_world, gyroscopic_ball_and_remainder_4_in_world},
                     gyroscopic_fastest,
                     gyroscopic_half_step_limit};

const Callsf callsf = {
    gyroscopic_from_momentsf,
    gyroscopic_from_inverse_momentsf,
    gyroscopic_idlef,
    {gyroscopic_passivef, gyroscopic_half_stepf, gyroscopic_calm_half_stepf},
    {gyroscopic_passive_in_worldf, gyroscopic_half_step_in_worldf, gyroscopic_calm_half_step_in_worldf},
    {gyroscopic_ball_and_remainder_2f, gyroscopic_ball_and_remainder_4f},
    {gyroscopic_ball_and_remainder_2_in_worldf, gyroscopic_ball_and_remainder_4_in_worldf},
    gyroscopic_fastestf,
    gyroscopic_half_step_limitf};
