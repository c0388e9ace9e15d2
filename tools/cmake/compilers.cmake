# The compilers that tests compare: g++ and clang++, one of which is the compiler of this build.
# TIMESTEP_COMPILERS names those that are there; TIMESTEP_GNU and TIMESTEP_CLANG are their paths.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(TIMESTEP_GNU "${CMAKE_CXX_COMPILER}")
elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND NOT MSVC)
  set(TIMESTEP_CLANG "${CMAKE_CXX_COMPILER}")
endif()
if(NOT MSVC)
  find_program(TIMESTEP_GNU g++)
  find_program(TIMESTEP_CLANG clang++)
endif()
set(TIMESTEP_COMPILERS "")
foreach(compiler GNU CLANG)
  if(TIMESTEP_${compiler})
    list(APPEND TIMESTEP_COMPILERS ${compiler})
  endif()
endforeach()
set(TIMESTEP_GNU_NAME g++)
set(TIMESTEP_CLANG_NAME clang++)
# The tests that compile something: with this build's compiler for all who run the long tests, with the other one before
# a release.
foreach(compiler IN LISTS TIMESTEP_COMPILERS)
  set(TIMESTEP_${compiler}_TIER release)
  if(TIMESTEP_${compiler} STREQUAL CMAKE_CXX_COMPILER)
    set(TIMESTEP_${compiler}_TIER long)
  endif()
endforeach()

# A test that cannot run here stands in the summary as skipped, with the reason in its output.
function(timestep_skipped_test name reason)
  add_test(NAME "${name}" COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${reason}")
  set_tests_properties("${name}" PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped: ")
endfunction()

# Declares the skipped test "what (clang++)" where clang++ is missing, and likewise for g++.
function(timestep_skip_missing_compilers what)
  foreach(compiler GNU CLANG)
    set(name "${TIMESTEP_${compiler}_NAME}")
    if(NOT TIMESTEP_${compiler} AND NOT MSVC)
      timestep_skipped_test("${what} (${name})" "${name} is not installed")
    endif()
  endforeach()
endfunction()
