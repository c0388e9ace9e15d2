# Installs the library into a scratch folder, then configures, builds and runs the projects beside
# this file against it. Called with BUILD, COMPILER, GENERATOR, MAKE, EIGEN, VERSION, INCLUDE, WORK.
cmake_minimum_required(VERSION 3.25)

function(execute result)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
set(prefix "${WORK}/prefix")
execute(_ "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")

# The headers, all of them, their licence, and a package: nothing else.
file(GLOB_RECURSE headers RELATIVE "${INCLUDE}" "${INCLUDE}/*")
file(GLOB_RECURSE installed RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT headers STREQUAL installed)
  message(FATAL_ERROR "installed are\n${installed}\nmust be\n${headers}")
endif()
file(GLOB_RECURSE others RELATIVE "${prefix}" "${prefix}/*")
list(FILTER others EXCLUDE REGEX "^include/|^share/cmake/timestep/timestep[-_][a-z-]+\\.cmake$|^share/licenses/timestep/LICENSE$")
if(others OR NOT EXISTS "${prefix}/share/licenses/timestep/LICENSE")
  message(FATAL_ERROR "no licence is installed, or besides it, the headers and the package: ${others}")
endif()

# The package names no folder of this machine, so it may be moved.
file(RENAME "${prefix}" "${WORK}/moved")
file(GLOB_RECURSE package "${WORK}/moved/share/*.cmake")
foreach(file IN LISTS package)
  file(READ "${file}" text)
  foreach(folder "${BUILD}" "${INCLUDE}" "${prefix}")
    string(FIND "${text}" "${folder}" place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${file} names the folder ${folder}")
    endif()
  endforeach()
endforeach()

# The answers by hand. Explicit Euler, h = 1/2, from (0, 0) with v = (1, 4) and gravity −8:
#   y: 0 → 2 (v: 4 → 0) → 2 (v: −4); x: 0 → 1/2 → 1.
# Semi-implicit Euler from 0 with v = 4: v = 0, x = 0; v = −4, x = −2.
set(answer_with_eigen "1 1 2\n")
set(answer_headers_only "1 -2\n")
foreach(project with_eigen headers_only)
  set(build "${WORK}/${project}")
  set(options "-DCMAKE_PREFIX_PATH=${WORK}/moved" "-DCMAKE_CXX_COMPILER=${COMPILER}"
              "-DCMAKE_MAKE_PROGRAM=${MAKE}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
  if(project STREQUAL "with_eigen")
    list(APPEND options "-DEigen3_DIR=${EIGEN}")
  else()
    list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
  endif()
  execute(_ "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${CMAKE_CURRENT_LIST_DIR}/${project}"
          -B "${build}" ${options})
  execute(_ "${CMAKE_COMMAND}" --build "${build}")
  # With the library comes plain arithmetic: no product and sum in one operation.
  if(EXISTS "${build}/compile_commands.json" AND NOT COMPILER MATCHES "cl(\\.exe)?$")
    file(READ "${build}/compile_commands.json" commands)
    if(NOT commands MATCHES " -ffp-contract=off ")
      message(FATAL_ERROR "${project}: whoever uses the package contracts products and sums:\n${commands}")
    endif()
  endif()
  find_program(ball_${project} ball PATHS "${build}" "${build}/Debug" "${build}/Release"
               NO_DEFAULT_PATH REQUIRED)
  execute(answer "${ball_${project}}")
  if(NOT answer STREQUAL answer_${project})
    message(FATAL_ERROR "${project}: the answer is ${answer}, must be ${answer_${project}}")
  endif()
endforeach()

# The same with the library's source inside a project, on a machine without Eigen: it settles nothing for its host, and
# installs nothing.
set(build "${WORK}/subproject")
execute(_ "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${CMAKE_CURRENT_LIST_DIR}/subproject" -B "${build}"
        "-DLIBRARY=${INCLUDE}/.." "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_MAKE_PROGRAM=${MAKE}"
        -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
execute(_ "${CMAKE_COMMAND}" --build "${build}")
find_program(ball_subproject ball PATHS "${build}" "${build}/Debug" NO_DEFAULT_PATH REQUIRED)
execute(answer "${ball_subproject}")
if(NOT answer STREQUAL answer_headers_only)
  message(FATAL_ERROR "subproject: the answer is ${answer}, must be ${answer_headers_only}")
endif()
execute(_ "${CMAKE_COMMAND}" --install "${build}" --prefix "${build}/installed")
file(GLOB_RECURSE installed "${build}/installed/*")
if(installed)
  message(FATAL_ERROR "as a subproject timestep installs ${installed}")
endif()

# The version that the headers say is the package's.
file(WRITE "${WORK}/version/version.cpp" "#include <timestep/version.h>
#include <cstdio>
int main() { std::printf(\"%d.%d.%d\", TIMESTEP_VERSION_MAJOR, TIMESTEP_VERSION_MINOR, TIMESTEP_VERSION_PATCH); }
")
execute(_ "${COMPILER}" "-I${WORK}/moved/include" "${WORK}/version/version.cpp" -o "${WORK}/version/version")
execute(answer "${WORK}/version/version")
if(NOT answer STREQUAL VERSION)
  message(FATAL_ERROR "the headers say version ${answer}, CMake ${VERSION}")
endif()

# A version that is too new is refused.
file(WRITE "${WORK}/newer/CMakeLists.txt"
  "cmake_minimum_required(VERSION 3.25)\nproject(newer LANGUAGES NONE)\n"
  "find_package(timestep 99 REQUIRED)\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${WORK}/newer" -B "${WORK}/newer/build"
    "-DCMAKE_MAKE_PROGRAM=${MAKE}" "-DCMAKE_PREFIX_PATH=${WORK}/moved"
  RESULT_VARIABLE status ERROR_VARIABLE output OUTPUT_QUIET)
if(status EQUAL 0 OR NOT output MATCHES "version: ${VERSION}")
  message(FATAL_ERROR "version 99 was asked for, ${VERSION} is installed, and CMake says:\n${output}")
endif()
