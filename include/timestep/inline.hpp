#pragma once
/// \file
/// Inlining where it decides the cost of a step; and functions that cost nothing where they are not
/// called.

/// A function of a few dozen instructions that is called once a body and step. At -O2 a compiler
/// may call it instead, and pass its vectors through memory: that doubles the cost of a gyroscopic
/// step.
#if defined(__GNUC__)
#define TIMESTEP_INLINE [[gnu::always_inline]] inline
#elif defined(_MSC_VER)
#define TIMESTEP_INLINE __forceinline
#else
#define TIMESTEP_INLINE inline
#endif

/// A function that goes through all methods. It is compiled where it is called: as an inline
/// function it would have every source that reads its header compile all of them, for several
/// seconds.
#define TIMESTEP_WHERE_CALLED template <int = 0>
