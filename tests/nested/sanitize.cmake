# Included by project() of the nested build: what is compiled from the library alone, its tests and the
# chapters' programs and studies, is compiled with the flags in SANITIZE. Eigen's own checks are on.
function(timestep_sanitize)
  get_property(programs GLOBAL PROPERTY TIMESTEP_CHAPTERS)
  list(TRANSFORM programs REPLACE "^[0-9]+_" "")
  list(TRANSFORM programs APPEND "_study" OUTPUT_VARIABLE studies)
  separate_arguments(flags UNIX_COMMAND "${SANITIZE}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags -Wno-error)  # g++ warns of paths that only its sanitizers' own code makes
  endif()
  foreach(target timestep_lab timestep_eigen_ready timestep_eigen_timed timestep_contest timestep_extremes timestep_tests ${programs} ${studies})
    if(NOT TARGET ${target})  # a chapter without a study
      continue()
    endif()
    target_compile_options(${target} PRIVATE -UNDEBUG ${flags})
    target_link_options(${target} PRIVATE ${flags})
  endforeach()
  # What counts instructions is compiled without, and reads nothing that is compiled with.
  set_target_properties(spins terms kinds plain PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
  # The exercises are compiled, and tested in the build around this one.
  target_compile_options(exercise_checks PUBLIC -O0)
  set_target_properties(self_test PROPERTIES EXCLUDE_FROM_ALL ON)
endfunction()
cmake_language(DEFER CALL timestep_sanitize)
