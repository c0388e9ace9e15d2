#pragma once
/// \file
/// What the library does with input that it refuses: one function, and one macro to replace it.

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

// The checks ask whether numbers are finite. Under -ffast-math the answer is always yes.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error \
    "timestep: not with -ffast-math or -ffinite-math-only: its checks could not see what is not finite"
#endif
// <windows.h> defines these as macros unless NOMINMAX is defined.
#if defined(min) || defined(max)
#error "timestep: min and max are macros here: define NOMINMAX before <windows.h> is included"
#endif

namespace timestep {

/// Refuses with one line, which names the value and the rule that it breaks. Does not return.
///
/// If `TIMESTEP_REFUSED(line)` is defined before the first header of the library, it is called with
/// that line, a `const char*`; if it returns, the program is aborted. Otherwise
/// `std::invalid_argument` is thrown; without exceptions (-fno-exceptions) the line is printed and
/// the program aborted. All sources of a program must define the macro alike. With
/// `TIMESTEP_REFUSED_BRIEFLY` the line is the rule alone: putting name and value into it needs C's
/// `printf`, 14 kB of a WebAssembly module.
[[noreturn]] inline void refuse(const char* line) {
#if defined(TIMESTEP_REFUSED)
    TIMESTEP_REFUSED(line);
    std::abort();
#elif defined(__cpp_exceptions)
    throw std::invalid_argument(line);
#else
    std::fprintf(stderr, "timestep: %s\n", line);
    std::abort();
#endif
}
/// Refuses with a line that was put together at run time.
[[noreturn]] inline void refuse(const std::string& line) { refuse(line.c_str()); }

}  // namespace timestep
