# The functions for engines that have no C++20, Eigen or exceptions. They are compiled as C99, and again in the test
# itself as C++.
include(CheckLanguage)
check_language(C)
if(NOT CMAKE_C_COMPILER OR MSVC)
  timestep_skipped_test("gyroscopic.h as C99" "there is no C compiler")
  return()
endif()
enable_language(C)

# As compilers make it that have no vectors of four numbers.
add_library(c_one_by_one OBJECT calls.c)
target_compile_definitions(c_one_by_one PRIVATE TIMESTEP_ONE_BY_ONE calls=calls_one_by_one callsf=callsf_one_by_one)
add_executable(c_tests $<TARGET_OBJECTS:c_one_by_one> calls.c ../taken_home.c taken_home.cpp creep.cpp unity.cpp bits.cpp extremes.cpp limits.cpp)
set_target_properties(c_tests c_one_by_one PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
# Eigen adds four numbers, and multiplies quaternions, in another order where it has vectors of the processor: here
# it shall do as the formulas stand. So the bits can be the same.
target_compile_definitions(c_tests PRIVATE EIGEN_DONT_VECTORIZE)
foreach(target c_tests c_one_by_one)
  target_compile_options(${target} PRIVATE -O1
    $<$<COMPILE_LANGUAGE:C>:-Wconversion -Wsign-conversion -Wshadow -Wfloat-conversion>)
endforeach()
target_include_directories(c_tests PRIVATE "${PROJECT_SOURCE_DIR}/tests/support" ..)
target_link_libraries(c_one_by_one PRIVATE timestep_headers timestep_warnings)
target_link_libraries(c_tests PRIVATE timestep timestep_shared timestep_warnings Catch2::Catch2WithMain m)
target_precompile_headers(c_tests PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:Eigen/Dense$<SEMICOLON>catch2/catch_test_macros.hpp>")
add_test(NAME "gyroscopic.h: the rules in C" COMMAND c_tests)
set_tests_properties("gyroscopic.h: the rules in C" PROPERTIES LABELS long)
