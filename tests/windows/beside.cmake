# Every public header after <windows.h>, for mingw's g++: no name in it may be one of that header's macros. Without NOMINMAX
# one line says what is missing. Called with COMPILER, INCLUDE, EIGEN and WORK.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE "${INCLUDE}" "${INCLUDE}/*.hpp" "${INCLUDE}/timestep/gyroscopic.h")
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>")
list(JOIN headers "\n" all)
file(WRITE "${WORK}/beside.cpp" "#include <windows.h>\n${all}\n")
# mingw's own headers do without these macros in C++, Microsoft's do not.
file(WRITE "${WORK}/no_nominmax.cpp"
  "#include <algorithm>\n#include <cmath>\n#include <string>\n#define min(a, b) 0\n#define max(a, b) 0\n#include <timestep/models/spring.hpp>\n")
set(compile "${COMPILER}" -std=c++20 -fsyntax-only -Wfatal-errors "-I${INCLUDE}" -isystem "${EIGEN}")
execute_process(COMMAND ${compile} -DNOMINMAX "${WORK}/beside.cpp" RESULT_VARIABLE status ERROR_VARIABLE said)
if(NOT status EQUAL 0)
  message(SEND_ERROR "beside windows.h:\n${said}")
endif()
execute_process(COMMAND ${compile} "${WORK}/no_nominmax.cpp" RESULT_VARIABLE status ERROR_VARIABLE said)
if(status EQUAL 0 OR NOT said MATCHES "define NOMINMAX before <windows.h>")
  message(SEND_ERROR "without NOMINMAX:\n${said}")
endif()
