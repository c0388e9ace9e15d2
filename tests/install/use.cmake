# Installs the library into a scratch folder, then configures, builds and runs a game that finds it there: with Eigen, and
# on a machine that has none. Then the same with the library's source inside the game.
# Called with BUILD, COMPILER, GENERATOR, MAKE, EIGEN, VERSION, INCLUDE, WORK.
cmake_minimum_required(VERSION 3.25)

function(execute result)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

# The headers, all of them, their licence, and a package: nothing else.
file(REMOVE_RECURSE "${WORK}")
set(prefix "${WORK}/prefix")
execute(_ "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")
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
file(RENAME "${prefix}" "${WORK}/moved")  # the package names no folder of this machine

# The answers by hand. Explicit Euler, h = 1/2, from (0, 0) with v = (1, 4) and gravity −8:
#   y: 0 → 2 (v: 4 → 0) → 2 (v: −4); x: 0 → 1/2 → 1.
# Semi-implicit Euler from 0 with v = 4: v = 0, x = 0; v = −4, x = −2.
set(answer_ball_in_space "1 1 2\n")
set(answer_ball "1 -2\n")
function(build_game name programs)
  set(build "${WORK}/${name}")
  execute(_ "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${CMAKE_CURRENT_LIST_DIR}/game" -B "${build}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_MAKE_PROGRAM=${MAKE}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF ${ARGN})
  execute(_ "${CMAKE_COMMAND}" --build "${build}")
  foreach(program IN LISTS programs)
    find_program(path_${name}_${program} ${program} PATHS "${build}" "${build}/Debug" NO_DEFAULT_PATH REQUIRED)
    execute(answer "${path_${name}_${program}}")
    if(NOT answer STREQUAL answer_${program})
      message(FATAL_ERROR "${name}: ${program} says ${answer}, must say ${answer_${program}}")
    endif()
  endforeach()
endfunction()
build_game(with_eigen "ball;ball_in_space" "-DCMAKE_PREFIX_PATH=${WORK}/moved" "-DEigen3_DIR=${EIGEN}"
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
build_game(without_eigen ball "-DCMAKE_PREFIX_PATH=${WORK}/moved" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
build_game(subproject ball "-DLIBRARY=${INCLUDE}/.." -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)

# With the library comes plain arithmetic: no product and sum in one operation.
file(READ "${WORK}/with_eigen/compile_commands.json" commands)
if(NOT commands MATCHES " -ffp-contract=off ")
  message(FATAL_ERROR "whoever uses the package contracts products and sums:\n${commands}")
endif()
# A subproject installs nothing.
execute(_ "${CMAKE_COMMAND}" --install "${WORK}/subproject" --prefix "${WORK}/installed")
file(GLOB_RECURSE installed "${WORK}/installed/*")
if(installed)
  message(FATAL_ERROR "as a subproject timestep installs ${installed}")
endif()
# The version that the headers say is the package's.
file(READ "${WORK}/moved/share/cmake/timestep/timestep-config-version.cmake" package)
file(STRINGS "${WORK}/moved/include/timestep/version.h" numbers REGEX "^#define TIMESTEP_VERSION_")
string(REGEX REPLACE "[^0-9;]*([0-9]+)[^;]*" "\\1" numbers "${numbers}")
list(JOIN numbers . version)
if(NOT version STREQUAL VERSION OR NOT package MATCHES "PACKAGE_VERSION \"${VERSION}\"")
  message(FATAL_ERROR "the headers say version ${version}, CMake ${VERSION}, and the package\n${package}")
endif()
