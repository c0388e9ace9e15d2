# How a misuse is compiled: `compile`, and `use_ready` to take Eigen from what beforehand.cmake has left
# in READY. Expects COMPILER, EIGEN and READY.
set(compile "${COMPILER}" -std=c++20 -Wall -Wextra -Wpedantic -Werror -isystem "${EIGEN}")
set(header "${READY}/ready.hpp")
get_filename_component(name "${COMPILER}" NAME)
if(name MATCHES "clang")
  set(compiled "${header}.pch")
  set(use_ready -include-pch "${compiled}")
else()
  set(compiled "${header}.gch")  # g++ looks for it beside the header
  set(use_ready -Winvalid-pch -include "${header}")
endif()
