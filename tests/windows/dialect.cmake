# Every header of the library, and every chapter's program, with Microsoft's words and rules switched on. (Its standard
# library is not here: it is g++'s that is read.) Called with COMPILER, ROOT, EIGEN and WORK.
cmake_minimum_required(VERSION 3.25)

set(INCLUDE "${ROOT}/include")
file(GLOB programs "${ROOT}/chapters/*/*.cpp")
list(FILTER programs EXCLUDE REGEX "/chapters/support/")
file(GLOB_RECURSE headers RELATIVE "${INCLUDE}" "${INCLUDE}/*.hpp" "${INCLUDE}/timestep/*.h")
list(REMOVE_ITEM headers timestep/gyroscopic/rules.h timestep/gyroscopic/flying.h timestep/gyroscopic/lanes.h)  # which gyroscopic.h includes
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>")
list(JOIN headers "\n" all)
file(MAKE_DIRECTORY "${WORK}")
file(WRITE "${WORK}/all.cpp" "${all}\n")
# g++'s standard library asks for these, which no compiler of Microsoft's kind has.
set(of_gnu -D__STRICT_ANSI__ -D__GCC_ATOMIC_TEST_AND_SET_TRUEVAL=1)
foreach(type IN ITEMS BOOL CHAR CHAR8_T CHAR16_T CHAR32_T WCHAR_T SHORT INT LONG LLONG POINTER)
  list(APPEND of_gnu -D__GCC_ATOMIC_${type}_LOCK_FREE=2)
endforeach()
execute_process(
  COMMAND "${COMPILER}" -std=c++20 -w ${of_gnu} -fms-compatibility -fms-compatibility-version=19.30 -fms-extensions -fsyntax-only
          "-I${INCLUDE}" -isystem "${EIGEN}" "${WORK}/all.cpp" ${programs}
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT status EQUAL 0 OR NOT programs)
  message(FATAL_ERROR "${output}")
endif()
