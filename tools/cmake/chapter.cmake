# A chapter is a folder chapters/NN_name with
#   chapter.md  the page          name.cpp    THE program: one short file
#   figures.gp  its picture       about.json  title, question, claims, figures
#   study/      what measures the rest: study.cpp and more, with a figures.gp of its own
# and the test tests/chapters/NN_name.cpp. One that lacks any of them is a configure error. A study may have
# a folder does_not_compile: what the compiler says of the sources there, the page can show. What goes deeper may have a
# second page, more.md.

find_program(GNUPLOT gnuplot)

# Compiles the target's sources only where more than a comment has changed in what they read.
find_program(SHELL sh)
function(timestep_compiles_what_changed target)
  if(SHELL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_CXX_COMPILER_LAUNCHER
     AND CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT TIMESTEP_STRICT)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER
      "${SHELL};${PROJECT_SOURCE_DIR}/tools/cmake/compile_what_changed.sh")
  endif()
endfunction()

# Reads a list of strings from about.json.
function(timestep_json_list json key result)
  string(JSON count LENGTH "${json}" ${key})
  set(list "")
  if(count GREATER 0)
    math(EXPR last "${count} - 1")
    foreach(i RANGE ${last})
      string(JSON item GET "${json}" ${key} ${i})
      list(APPEND list "${item}")
    endforeach()
  endif()
  set(${result} "${list}" PARENT_SCOPE)
endfunction()

# Declares the chapter in the folder chapters/${chapter}: its program `name`, its study `name_study`, and
# the run of both, which leaves data, numbers and figures in ${build}/chapters/NN_name/run.
function(timestep_chapter chapter)
  string(REGEX REPLACE "^[0-9]+_" "" name "${chapter}")
  set(folder "${PROJECT_SOURCE_DIR}/chapters/${chapter}")
  set(test "tests/chapters/${chapter}.cpp")
  if(TIMESTEP_KIT)  # which has no tests
    set(test "")
  endif()
  foreach(file chapters/${chapter}/about.json chapters/${chapter}/chapter.md
               chapters/${chapter}/${name}.cpp chapters/${chapter}/figures.gp
               chapters/${chapter}/study/study.cpp chapters/${chapter}/study/figures.gp ${test})
    if(NOT EXISTS "${PROJECT_SOURCE_DIR}/${file}")
      message(FATAL_ERROR "chapter ${chapter}: ${file} is missing. Every chapter has a page, a "
                          "program, a study, figures, about.json and a test.")
    endif()
  endforeach()

  if(test)
    file(STRINGS "${PROJECT_SOURCE_DIR}/${test}" cases REGEX "TEST_CASE")
    if(NOT cases)
      message(FATAL_ERROR "chapter ${chapter}: ${test} holds no TEST_CASE")
    endif()
  endif()

  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/about.json")
  file(READ "${folder}/about.json" about)
  string(JSON type ERROR_VARIABLE error TYPE "${about}")
  if(error)
    message(FATAL_ERROR "chapters/${chapter}/about.json: is not JSON (${error})")
  endif()
  foreach(key title question needs builds_on claims figures picture)
    string(JSON type ERROR_VARIABLE error TYPE "${about}" ${key})
    if(error)
      message(FATAL_ERROR "chapters/${chapter}/about.json: ${key} is missing")
    elseif(key MATCHES "^(title|question|picture)$")
      string(JSON words GET "${about}" ${key})
      if(NOT type STREQUAL "STRING" OR words STREQUAL "")
        message(FATAL_ERROR "chapters/${chapter}/about.json: ${key} must be words")
      endif()
    elseif(NOT type STREQUAL "ARRAY")
      message(FATAL_ERROR "chapters/${chapter}/about.json: ${key} must be a list")
    else()
      timestep_json_list("${about}" ${key} ${key})
    endif()
  endforeach()
  if(NOT figures)
    message(FATAL_ERROR "chapters/${chapter}/about.json: figures is empty. A chapter has a figure.")
  endif()
  foreach(figure IN LISTS figures)
    if(NOT figure MATCHES "^[a-z0-9_]+\\.(svg|gif)$")
      message(FATAL_ERROR "chapters/${chapter}/about.json: figures names ${figure}, must be "
                          "name.svg or name.gif in small letters")
    endif()
  endforeach()
  string(JSON picture GET "${about}" picture)
  if(NOT picture IN_LIST figures)
    message(FATAL_ERROR "chapters/${chapter}/about.json: picture is ${picture}, must be one of figures")
  endif()
  foreach(need IN LISTS needs)
    if(NOT need MATCHES "^(eigen|peers|contest|extremes|advise)$")
      message(FATAL_ERROR "chapters/${chapter}/about.json: needs names ${need}, and knows eigen, peers, contest, extremes and advise only")
    endif()
  endforeach()
  foreach(row IN LISTS claims)
    get_property(claimed GLOBAL PROPERTY TIMESTEP_CLAIMED_${row})
    if(claimed)
      message(FATAL_ERROR "chapters/${chapter}/about.json: claims names ${row}, which chapters/${claimed} claims")
    endif()
    set_property(GLOBAL PROPERTY TIMESTEP_CLAIMED_${row} ${chapter})
  endforeach()
  foreach(earlier IN LISTS builds_on)
    if(NOT EXISTS "${PROJECT_SOURCE_DIR}/chapters/${earlier}/about.json")
      message(FATAL_ERROR "chapters/${chapter}/about.json: builds_on names ${earlier}, which is no chapter")
    endif()
  endforeach()

  # The program needs the library alone: one line compiles it, too.
  set(library timestep_headers)
  if("eigen" IN_LIST needs)
    set(library timestep)
  endif()
  add_executable(${name} "${folder}/${name}.cpp")
  target_link_libraries(${name} PRIVATE ${library} timestep_warnings)
  timestep_compiles_what_changed(${name})

  set(study ${name}_study)
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/study/*.cpp")
  add_executable(${study} ${sources})
  target_link_libraries(${study} PRIVATE ${library} timestep_lab timestep_warnings)
  timestep_compiles_what_changed(${study})
  # Where nothing is timed, what counts is how soon it can be run. (A source that is timed and one that is
  # not would share functions: so it is all of a study or nothing.)
  file(GLOB all CONFIGURE_DEPENDS "${folder}/study/*.cpp" "${folder}/study/*.hpp")
  set(clocks "")
  foreach(source IN LISTS all)
    file(STRINGS "${source}" lines REGEX "#include (<chrono>|\"timing.hpp\")")
    list(APPEND clocks ${lines})
  endforeach()
  if(NOT clocks AND NOT "eigen" IN_LIST needs AND NOT MSVC)  # g++ would go on as Eigen was compiled beforehand
    target_compile_options(${study} PRIVATE -O1)
  endif()
  if("eigen" IN_LIST needs)
    timestep_reads_eigen(${study} "${needs}")
  else()
    target_precompile_headers(${study} PRIVATE ${TIMESTEP_STUDIES_READ})
  endif()
  foreach(need IN LISTS needs)  # "advise": a study that holds the adviser's verdicts to runs, for its page (chapter 6)
    if(NOT need STREQUAL "eigen")
      target_link_libraries(${study} PRIVATE timestep_${need})
    endif()
  endforeach()

  timestep_live(${chapter} "${needs}")

  set(run "${PROJECT_BINARY_DIR}/chapters/${chapter}/run")
  file(GLOB misuses CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" "${folder}/study/does_not_compile/*.cpp")
  set(misuse_paths ${misuses})
  list(TRANSFORM misuse_paths PREPEND "${PROJECT_SOURCE_DIR}/")
  if(misuses)  # what the compiler says of them depends on the library
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/*.hpp")
    list(APPEND misuse_paths ${headers})
  endif()
  list(TRANSFORM figures PREPEND "${run}/" OUTPUT_VARIABLE drawn)
  file(GLOB scripts CONFIGURE_DEPENDS "${folder}/*.gp" "${folder}/study/*.gp")  # and what they load
  if(TIMESTEP_DOCS AND GNUPLOT)
    add_custom_command(OUTPUT "${run}/done" BYPRODUCTS ${drawn}
      COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:${name}>" "-DSTUDY=$<TARGET_FILE:${study}>"
              "-DOUT=${run}" "-DROOM=${folder}" "-DSTYLE=${PROJECT_SOURCE_DIR}/tools/figures/style.gp"
              "-DGNUPLOT=${GNUPLOT}" -DQUIET=ON
              "-DMISUSES=${misuses}" "-DROOT=${PROJECT_SOURCE_DIR}" "-DCOMPILER=${CMAKE_CXX_COMPILER}"
              -P "${PROJECT_SOURCE_DIR}/tools/cmake/run.cmake"
      DEPENDS ${name} ${study} ${scripts} "${folder}/about.json"
              "${PROJECT_SOURCE_DIR}/tools/figures/style.gp"
              "${PROJECT_SOURCE_DIR}/tools/cmake/run.cmake"
              "${PROJECT_SOURCE_DIR}/tools/cmake/misuse.cmake" ${misuse_paths}
      COMMENT "Running chapter ${chapter}" VERBATIM)
    add_custom_target(run_${name} DEPENDS "${run}/done")
    set_property(GLOBAL APPEND PROPERTY TIMESTEP_RUNS run_${name})
    if(COMMAND timestep_grows AND DOXYGEN)
      timestep_page(${chapter})
      timestep_grows(${chapter})
    endif()
  endif()
  set_property(GLOBAL APPEND PROPERTY TIMESTEP_CHAPTERS "${chapter}")
endfunction()
