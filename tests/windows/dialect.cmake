# What is built for Windows, read with the words and rules of Microsoft's compiler switched on, and what only others know
# forbidden: words, and extensions of g++. (Its standard library is not here: it is g++'s that is read, beforehand.)
# Called with COMPILER, ROOT, EIGEN, CATCH2 (the folders of its headers) and WORK.
cmake_minimum_required(VERSION 3.25)

# g++'s standard library asks for these, which no compiler of Microsoft's kind has.
set(dialect -std=c++20 -Wno-everything -Werror=gnu -Werror=vla-extension -Werror=c99-extensions -D__STRICT_ANSI__
  -D__GCC_ATOMIC_TEST_AND_SET_TRUEVAL=1)
foreach(type IN ITEMS BOOL CHAR CHAR8_T CHAR16_T CHAR32_T WCHAR_T SHORT INT LONG LLONG POINTER)
  list(APPEND dialect -D__GCC_ATOMIC_${type}_LOCK_FREE=2)
endforeach()
list(APPEND dialect -fms-compatibility -fms-compatibility-version=19.30 -fms-extensions)
list(REMOVE_ITEM CATCH2 /usr/include)
foreach(folder IN LISTS EIGEN CATCH2)
  list(APPEND dialect -isystem "${folder}")
endforeach()
foreach(folder IN ITEMS include . tools/advise tools/lab tools/bench engines tests/support tools/live)
  list(APPEND dialect "-I${ROOT}/${folder}")
endforeach()
function(read)
  execute_process(COMMAND "${COMPILER}" ${dialect} ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${output}")
  endif()
endfunction()

set(include "${ROOT}/include")
set(named tests/advise/*.cpp tests/library/*.cpp tests/chapters/*.cpp engines/tests/*.cpp)
set(sources ${named} chapters/*/*.cpp chapters/*/live/*.cpp chapters/*/study/*.cpp chapters/*/study/*/*.cpp
  docs/library/*.cpp tools/lab/*.cpp tools/bench/contest/*.cpp)
list(TRANSFORM named PREPEND "${ROOT}/")
list(TRANSFORM sources PREPEND "${ROOT}/")
file(GLOB named ${named})
file(GLOB sources ${sources})
list(FILTER sources EXCLUDE REGEX "/does_not_compile/")
list(FILTER sources EXCLUDE REGEX "/tools/lab/options[.]cpp$")  # the one that reads CLI11
list(FILTER sources EXCLUDE REGEX "/engines/tests/(bullet_adapter|ode_adapter|patches|record)[.]cpp$")  # Linux alone has them
file(GLOB_RECURSE headers RELATIVE "${include}" "${include}/*.hpp" "${include}/timestep/*.h")
list(FILTER headers EXCLUDE REGEX "gyroscopic/(rules|flying|lanes)[.]h$")  # which gyroscopic.h includes
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>")
list(JOIN headers "\n" all)
file(WRITE "${WORK}/all.cpp" "${all}\n")
list(APPEND sources "${WORK}/all.cpp")

# CTest calls a test by its name, and Windows hands on no letters but these.
foreach(source IN LISTS named)
  file(READ "${source}" text)
  if(text MATCHES "TEST_CASE\\([ \n]*\"([^\"\n]*[^ -~\n][^\"\n]*)\"")
    message(FATAL_ERROR "${source}: the test's name must be of ASCII's letters: ${CMAKE_MATCH_1}")
  endif()
endforeach()

# What is not ours: the standard library, Eigen and Catch2, as any of the sources or of our headers includes it.
file(GLOB_RECURSE ours "${include}/*.hpp" "${include}/*.h" "${ROOT}/chapters/*.hpp" "${ROOT}/tests/support/*.hpp"
  "${ROOT}/tools/lab/*.hpp" "${ROOT}/tools/bench/contest/*.hpp" "${ROOT}/engines/tests/*.h*" "${ROOT}/tools/live/*.hpp")
set(theirs "")
foreach(file IN LISTS ours sources)
  file(STRINGS "${file}" lines REGEX "^#include <(Eigen/|catch2/|[a-z_]+>)")
  list(APPEND theirs ${lines})
endforeach()
list(REMOVE_DUPLICATES theirs)
list(JOIN theirs "\n" theirs)
# (Linux's headers have a function link, as one of our small programs has.)
file(WRITE "${WORK}/theirs.hpp" "#define link link_of_linux\n${theirs}\n#undef link\n#undef __linux__\n"
  "#pragma GCC poison __attribute__ __extension__ __typeof__ __int128 __asm__ __restrict__ ssize_t M_PI M_PI_2\n")
read(-x c++-header "${WORK}/theirs.hpp" -Xclang -emit-pch -o "${WORK}/theirs.pch")
read(-fsyntax-only -include-pch "${WORK}/theirs.pch" ${sources})
