# A copy of the course with a single chapter, 01_small, to try things on. Expects ROOT, WORK,
# COMPILER, GENERATOR, MAKE and EIGEN.
cmake_minimum_required(VERSION 3.25)

set(fixture "${WORK}/course")

# Copies the course without its chapters.
function(set_fixture)
  file(REMOVE_RECURSE "${WORK}")
  foreach(part CMakeLists.txt include tools engines chapters/CMakeLists.txt)
    get_filename_component(folder "${fixture}/${part}" DIRECTORY)
    file(COPY "${ROOT}/${part}" DESTINATION "${folder}")
  endforeach()
endfunction()

# Configures the fixture; sets `status` and `output`, which has its lines joined.
macro(configure)
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${fixture}" -B "${WORK}/build"
            "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_MAKE_PROGRAM=${MAKE}"
            "-DEigen3_DIR=${EIGEN}" -DTIMESTEP_COURSE=OFF ${ARGN}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
endmacro()
