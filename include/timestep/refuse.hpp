#pragma once
/// \file
/// What the library does with what it cannot take: one function, and one macro for those who want
/// something else.

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

// The checks ask whether numbers are finite, and -ffast-math answers that they all are.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error \
    "timestep: not with -ffast-math or -ffinite-math-only: its checks could not see what is not finite"
#endif
// Without NOMINMAX <windows.h> makes macros of these.
#if defined(min) || defined(max)
#error "timestep: min and max are macros here: define NOMINMAX before <windows.h> is included"
#endif

namespace timestep {

/// Refuses, by one line that names the value and the rule it breaks, and does not return.
///
/// Where `TIMESTEP_REFUSED(line)` is defined before the first header of the library, it is called
/// with that line, a `const char*`; if it returns, the program is aborted. Otherwise
/// `std::invalid_argument` is thrown, and where there are no exceptions (-fno-exceptions) the line
/// is printed and the program aborted. Define it alike everywhere. With `TIMESTEP_REFUSED_BRIEFLY`
/// the line is the rule alone: to put name and value into it takes C's `printf`, 14 kB of a module
/// of WebAssembly.
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
/// The same, of a line that is put together.
[[noreturn]] inline void refuse(const std::string& line) { refuse(line.c_str()); }

}  // namespace timestep
