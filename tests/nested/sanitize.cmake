# Included by project() of the nested build: what is compiled from the library alone, its tests and the
# chapters' programs, is compiled with the flags in SANITIZE. Eigen's own checks are on.
function(timestep_sanitize)
  get_property(programs GLOBAL PROPERTY TIMESTEP_CHAPTERS)
  list(TRANSFORM programs REPLACE "^[0-9]+_" "")
  separate_arguments(flags UNIX_COMMAND "${SANITIZE}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags -Wno-error)  # g++ warns of paths that only its sanitizers' own code makes
  endif()
  foreach(target timestep_lab timestep_eigen_ready timestep_tests ${programs})
    target_compile_options(${target} PRIVATE -UNDEBUG ${flags})
    target_link_options(${target} PRIVATE ${flags})
  endforeach()
  # Some sources are hundreds of functions that are called once: optimised, they take two or three times as
  # long to compile. (What is compiled beforehand is optimised, and not for them.) None of them computes much
  # with Eigen's small vectors: of a function that several sources have the linker takes any copy, and so
  # one that is not optimised could slow down all tests.
  if(TARGET stability)
    file(GLOB extremes "${PROJECT_SOURCE_DIR}/chapters/06_stability/extreme_*.cpp")
    set_source_files_properties(${extremes}
      TARGET_DIRECTORY stability PROPERTIES COMPILE_OPTIONS -O0
      SKIP_PRECOMPILE_HEADERS ON)
  endif()
  set(once chapters/02_arrays chapters/06_cloth library/extremes library/lanes library/linear_solve
    library/models)
  list(TRANSFORM once PREPEND "${PROJECT_SOURCE_DIR}/tests/")
  list(TRANSFORM once APPEND .cpp)
  set_source_files_properties(${once} TARGET_DIRECTORY timestep_tests PROPERTIES COMPILE_OPTIONS -O0
    SKIP_PRECOMPILE_HEADERS ON)
  # The exercises are compiled, and tested in the build around this one.
  target_compile_options(exercise_checks PUBLIC -O0)
  set_target_properties(self_test PROPERTIES EXCLUDE_FROM_ALL ON)
endfunction()
cmake_language(DEFER CALL timestep_sanitize)
