# Our own code compiles without a warning; TIMESTEP_STRICT (on in the presets for development and
# tests) makes a warning an error. Plain IEEE arithmetic everywhere: no fused multiply-add behind
# our back, so that g++ and clang give the same bits.
option(TIMESTEP_STRICT "Treat warnings as errors" OFF)

add_library(timestep_warnings INTERFACE)
if(MSVC)
  target_compile_options(timestep_warnings INTERFACE /W4 /utf-8 $<$<BOOL:${TIMESTEP_STRICT}>:/WX>)
else()
  target_compile_options(timestep_warnings INTERFACE
    -Wall -Wextra -Wpedantic -ffp-contract=off $<$<BOOL:${TIMESTEP_STRICT}>:-Werror>)
  # g++ 12 takes "text" + std::string for a memcpy onto itself (GCC bug 105651), mingw's also for one past its end.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(timestep_warnings INTERFACE -Wno-restrict $<$<BOOL:${MINGW}>:-Wno-array-bounds>)
  endif()
endif()
