#pragma once
/// \file
/// Inlining where it decides the cost of a step.

/// A function of a few dozen instructions that is called once a body and step. At -O2 a compiler may
/// call it instead, and pass its vectors through memory: that doubles the cost of a gyroscopic step.
#if defined(__GNUC__)
#define TIMESTEP_INLINE [[gnu::always_inline]] inline
#elif defined(_MSC_VER)
#define TIMESTEP_INLINE __forceinline
#else
#define TIMESTEP_INLINE inline
#endif
