# Included by project() of the nested build: what is compiled from the library alone, its tests and the chapters' programs
# and studies, is compiled with the flags in SANITIZE. Eigen's own checks are on. All programs are linked with them.
separate_arguments(flags UNIX_COMMAND "${SANITIZE}")
add_link_options(${flags})
function(timestep_sanitize)
  get_property(programs GLOBAL PROPERTY TIMESTEP_CHAPTERS)
  list(TRANSFORM programs REPLACE "^[0-9]+_" "")
  list(TRANSFORM programs APPEND "_study" OUTPUT_VARIABLE studies)
  separate_arguments(flags UNIX_COMMAND "${SANITIZE}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags -Wno-error)  # g++ warns of paths that only its sanitizers' own code makes
  endif()
  foreach(target timestep_lab timestep_eigen_ready timestep_eigen_timed timestep_contest timestep_extremes timestep_choices
          timestep_tests instruction_counts sample_study ${programs} ${studies})
    if(TARGET ${target})  # a chapter may have no study
      target_compile_options(${target} PRIVATE -UNDEBUG ${flags})
    endif()
  endforeach()
  # The exercises are compiled, and tested in the build around this one.
  target_compile_options(exercise_checks PUBLIC -O0)
  set_target_properties(self_test PROPERTIES EXCLUDE_FROM_ALL ON)
endfunction()
cmake_language(DEFER CALL timestep_sanitize)
