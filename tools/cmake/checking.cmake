# How a learner's file is compiled and checked. The hidden tests are built (tests/exercises) or come built (the
# learner's edition): for each exercise the targets hidden_NAME and worker_NAME, and timestep_worker. What a check of
# it needs is target ready_NAME, and the check, for those who build by CMake alone, target check_NAME. `told` is the
# folder of what is told of each exercise, NN_chapter/NAME/about.json; the build folder has the declarations,
# exercises/generated/NAME_declared.hpp.
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)

# What judges an answer, in a process beside it or (on Windows) in the answer's own.
set(TIMESTEP_JUDGE diagnose generic_mistakes last_comparison random_stream registry property property_eigen session shrink truth wrong_region
  slips/slip slips/diagnose_slip learner/solve_linear)
list(TRANSFORM TIMESTEP_JUDGE REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/tools/checker/\\1.cpp")

function(timestep_check_learners told)
  set(generated "${PROJECT_BINARY_DIR}/exercises/generated")
  set(learner "${PROJECT_SOURCE_DIR}/tools/checker/learner")
  set(flags -std=c++20 -O1 -g1 -Wall -Wextra -Wno-unused-parameter -Werror=return-type
      -ffp-contract=off -D_GLIBCXX_ASSERTIONS)
  # A file that is no C++ would have it say as much of every byte.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags -fmax-errors=20)
  endif()
  # What was never written is no lucky zero.
  check_cxx_compiler_flag(-ftrivial-auto-var-init=pattern TIMESTEP_FILLS_VARIABLES)
  if(TIMESTEP_FILLS_VARIABLES)
    list(APPEND flags -ftrivial-auto-var-init=pattern)
  endif()

  # The course program, which checks. The learner's edition brings it built.
  set(course "")
  if(TIMESTEP_KIT)
    set(course "${PROJECT_SOURCE_DIR}/kit/course")
  elseif(TARGET course)
    set(course "$<TARGET_FILE:course>")
  endif()
  set(checks "")
  set(workers "")
  set(comma "")
  set(all_ready "")
  file(GLOB abouts CONFIGURE_DEPENDS RELATIVE "${told}" "${told}/*/*/about.json")
  foreach(about IN LISTS abouts)
    cmake_path(GET about PARENT_PATH room)
    cmake_path(GET room FILENAME name)
    file(READ "${told}/${about}" json)
    string(JSON eigen GET "${json}" eigen)
    set(header exercise)
    if(eigen)
      set(header exercise_eigen)
    endif()
    add_custom_target(ready_${name})
    add_dependencies(ready_${name} hidden_${name} timestep_worker ready_${header})
    if(NOT TIMESTEP_KIT)
      add_dependencies(ready_${name} worker_${name})
    endif()
    if(course)  # which need not build anything
      add_custom_target(check_${name}
        COMMAND "${CMAKE_COMMAND}" -E env COURSE_IS_BUILT=ON "${course}" check ${name}
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}" USES_TERMINAL VERBATIM)
      add_dependencies(check_${name} ready_${name})
      if(NOT TIMESTEP_KIT)
        add_dependencies(check_${name} course)
      endif()
    else()
      add_custom_target(check_${name} COMMAND "${CMAKE_COMMAND}" -E echo
        "check_${name} needs the course program, which -DTIMESTEP_COURSE=ON builds" COMMAND "${CMAKE_COMMAND}" -E false VERBATIM)
    endif()
    list(APPEND all_ready ready_${name})
    string(APPEND checks "${comma}\n  \"${name}\": \"$<TARGET_FILE:hidden_${name}>\"")
    string(APPEND workers "${comma}\n  \"${name}\": \"$<TARGET_OBJECTS:worker_${name}>\"")
    set(comma ",")
  endforeach()

  # The same for the course program. The headers that the file includes are compiled beforehand, which
  # makes a check three times faster with Eigen.
  set(includes "-I${learner}" "-I${PROJECT_SOURCE_DIR}/include")
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder IN LISTS eigen)
    list(APPEND includes -isystem ${folder})
  endforeach()
  set(ready "${PROJECT_BINARY_DIR}/exercises/ready")
  set(compile_header "${PROJECT_SOURCE_DIR}/tools/cmake/compile_header.sh")
  foreach(header exercise exercise_eigen)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      set(compiled "${ready}/${header}.hpp.gch")
      set(use_${header} "-I${ready};-include;${header}.hpp")
      # It stands beside what is compiled of it, for a file that includes it again.
      configure_file("${learner}/${header}.hpp" "${ready}/${header}.hpp" COPYONLY)
    else()
      set(compiled "${ready}/${header}.hpp.pch")
      set(use_${header} "-include-pch;${compiled}")
    endif()
    add_custom_command(OUTPUT "${compiled}"
      COMMAND "${CMAKE_COMMAND}" -E make_directory "${ready}"
      COMMAND sh "${compile_header}" "${compiled}" "${CMAKE_CXX_COMPILER}" ${flags} ${includes} -x c++-header
              "${learner}/${header}.hpp" -MD -MQ "${compiled}" -MF "${compiled}.d"
      DEPENDS "${learner}/${header}.hpp" "${compile_header}"
      DEPFILE "${compiled}.d" COMMENT "Compiling what the exercises include" VERBATIM)
    add_custom_target(ready_${header} DEPENDS "${compiled}")
  endforeach()
  add_custom_target(exercises ALL)
  add_dependencies(exercises ${all_ready})

  # All that as JSON.
  timestep_json_words(compile "${CMAKE_CXX_COMPILER}" ${use_exercise} ${flags} ${includes})
  timestep_json_words(compile_eigen "${CMAKE_CXX_COMPILER}" ${use_exercise_eigen} ${flags} ${includes})
  # For check --sanitize: without what is compiled beforehand, which was compiled otherwise.
  set(sanitize -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  # The room behind a vector's end. Only where the workers' own vector functions are inlined: shared with
  # the learner's, which mark that room, they would be taken for errors.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_BUILD_TYPE STREQUAL "Release")
    list(APPEND sanitize -D_GLIBCXX_SANITIZE_VECTOR=1)
  endif()
  list(JOIN sanitize " " CMAKE_REQUIRED_FLAGS)
  check_cxx_source_compiles("int main() {}" TIMESTEP_HAS_SANITIZERS)
  unset(CMAKE_REQUIRED_FLAGS)
  timestep_json_words(bare "${CMAKE_CXX_COMPILER}" ${flags} ${includes} -include exercise.hpp)
  timestep_json_words(bare_eigen "${CMAKE_CXX_COMPILER}" ${flags} ${includes} -include exercise_eigen.hpp)
  if(TIMESTEP_HAS_SANITIZERS)
    timestep_json_words(sanitize ${sanitize})
  else()
    set(sanitize "[]")
  endif()
  # The compiler's list of what it has read.
  set(lists -MD -MF @.d)
  timestep_json_words(lists ${lists})
  # What an answer may bring for link-time optimization, with options of its own, is not made use of.
  # The linker that comes to an end first, where it is there.
  set(linker "")
  foreach(name gold lld)
    if(NOT linker)
      set(CMAKE_REQUIRED_LINK_OPTIONS -fuse-ld=${name})
      check_cxx_source_compiles("int main() {}" TIMESTEP_LINKS_BY_${name})
      if(TIMESTEP_LINKS_BY_${name})
        set(linker -fuse-ld=${name})
      endif()
      unset(CMAKE_REQUIRED_LINK_OPTIONS)
    endif()
  endforeach()
  timestep_json_words(link "${CMAKE_CXX_COMPILER}" -no-pie -fno-lto ${linker})
  file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/exercises/commands.json" CONTENT
"{\"compile\": ${compile},
 \"compile_eigen\": ${compile_eigen},
 \"bare\": ${bare},
 \"bare_eigen\": ${bare_eigen},
 \"sanitize\": ${sanitize},
 \"lists\": ${lists},
 \"link\": ${link},
 \"checks\": {${checks}},
 \"worker\": \"$<TARGET_FILE:timestep_worker>\",
 \"workers\": {${workers}}}
")
endfunction()

function(timestep_json_words variable)
  list(JOIN ARGN "\", \"" words)
  set(${variable} "[\"${words}\"]" PARENT_SCOPE)
endfunction()
