#pragma once
/// \file
/// Inlining of functions that decide the cost of a step, and functions that are compiled only if
/// they are called.

/// For a function of a few dozen instructions that is called once per body and step. At -O2 a
/// compiler may call it instead of inlining it, and pass its vectors through memory, which doubles
/// the cost of a gyroscopic step.
#if defined(__GNUC__)
#define TIMESTEP_INLINE [[gnu::always_inline]] inline
#elif defined(_MSC_VER)
#define TIMESTEP_INLINE __forceinline
#else
#define TIMESTEP_INLINE inline
#endif

/// For a function that visits all methods. As a template it is compiled only where it is called; as
/// an inline function it would be compiled, for seconds, in every source that includes its header.
#define TIMESTEP_WHERE_CALLED template <int = 0>
