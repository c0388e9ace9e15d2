# The headers and the chapters' programs, read with the words and rules of Microsoft's compiler switched on, and with what
# only others know forbidden: words, and extensions of g++. (Its standard library is not here: g++'s is read, beforehand.)
# Called with COMPILER, ROOT, EIGEN and WORK.
cmake_minimum_required(VERSION 3.25)

# g++'s standard library asks for these, which no compiler of Microsoft's kind has.
set(dialect -std=c++20 -Wno-everything -Werror=gnu -Werror=vla-extension -Werror=c99-extensions -D__STRICT_ANSI__
  -D__GCC_ATOMIC_TEST_AND_SET_TRUEVAL=1)
foreach(type IN ITEMS BOOL CHAR CHAR8_T CHAR16_T CHAR32_T WCHAR_T SHORT INT LONG LLONG POINTER)
  list(APPEND dialect -D__GCC_ATOMIC_${type}_LOCK_FREE=2)
endforeach()
list(APPEND dialect -fms-compatibility -fms-compatibility-version=19.30 -fms-extensions -isystem "${EIGEN}"
  "-I${ROOT}/include")
function(read)
  execute_process(COMMAND "${COMPILER}" ${dialect} ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
endfunction()

set(include "${ROOT}/include")
file(GLOB sources "${ROOT}/chapters/*/*.cpp")
file(GLOB_RECURSE headers RELATIVE "${include}" "${include}/*.hpp" "${include}/timestep/*.h")
list(FILTER headers EXCLUDE REGEX "gyroscopic/(rules|flying|lanes)[.]h$")  # which gyroscopic.h includes
set(theirs "")  # the standard library and Eigen, as any of the sources or headers includes them
foreach(file IN LISTS headers sources)
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${include}")
  file(STRINGS "${file}" lines REGEX "^#include <(Eigen/|[a-z_]+>)")
  list(APPEND theirs ${lines})
endforeach()
list(REMOVE_DUPLICATES theirs)
list(JOIN theirs "\n" theirs)
# (Linux's headers have a function link, as one of our small programs has.)
file(WRITE "${WORK}/theirs.hpp" "#define link link_of_linux\n${theirs}\n#undef link\n#undef __linux__\n"
  "#pragma GCC poison __attribute__ __extension__ __typeof__ __int128 __asm__ __restrict__ ssize_t M_PI M_PI_2\n")
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
file(WRITE "${WORK}/all.cpp" ${headers})
read(-x c++-header "${WORK}/theirs.hpp" -Xclang -emit-pch -o "${WORK}/theirs.pch")
read(-fsyntax-only -include-pch "${WORK}/theirs.pch" ${sources} "${WORK}/all.cpp")
