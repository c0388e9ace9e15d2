# A chapter is a folder chapters/NN_name with
#   chapter.md  the page          name.cpp    the program
#   figures.gp  the pictures      about.json  title, question, ledger rows, figures
# and the test tests/chapters/NN_name.cpp. One that lacks any of them is a configure error.

find_program(GNUPLOT gnuplot)

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

# Declares the chapter in the folder chapters/${chapter}: its program, and its run, which leaves
# data, numbers and figures in ${build}/chapters/NN_name/run.
function(timestep_chapter chapter)
  string(REGEX REPLACE "^[0-9]+_" "" name "${chapter}")
  set(folder "${PROJECT_SOURCE_DIR}/chapters/${chapter}")
  foreach(file chapters/${chapter}/about.json chapters/${chapter}/chapter.md
               chapters/${chapter}/${name}.cpp chapters/${chapter}/figures.gp
               tests/chapters/${chapter}.cpp)
    if(NOT EXISTS "${PROJECT_SOURCE_DIR}/${file}")
      message(FATAL_ERROR "chapter ${chapter}: ${file} is missing. Every chapter has a page, a "
                          "program, figures, about.json and a test.")
    endif()
  endforeach()

  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/about.json")
  file(READ "${folder}/about.json" about)
  foreach(key title question needs builds_on rows figures)
    string(JSON value ERROR_VARIABLE error GET "${about}" ${key})
    if(error)
      message(FATAL_ERROR "chapters/${chapter}/about.json: ${key} is missing (${error})")
    endif()
  endforeach()
  timestep_json_list("${about}" figures figures)
  timestep_json_list("${about}" needs needs)
  timestep_json_list("${about}" builds_on builds_on)
  if(NOT figures)
    message(FATAL_ERROR "chapters/${chapter}/about.json: figures is empty. A chapter has a figure.")
  endif()
  foreach(earlier IN LISTS builds_on)
    if(NOT EXISTS "${PROJECT_SOURCE_DIR}/chapters/${earlier}/about.json")
      message(FATAL_ERROR "chapters/${chapter}/about.json: builds_on names ${earlier}, which is no chapter")
    endif()
  endforeach()

  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE timestep_headers timestep_lab timestep_warnings)
  if("eigen" IN_LIST needs)
    target_link_libraries(${name} PRIVATE timestep)
  endif()

  set(run "${PROJECT_BINARY_DIR}/chapters/${chapter}/run")
  if(TIMESTEP_DOCS AND GNUPLOT)
    add_custom_command(OUTPUT "${run}/done"
      COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:${name}>" "-DOUT=${run}"
              "-DSCRIPT=${folder}/figures.gp" "-DSTYLE=${PROJECT_SOURCE_DIR}/tools/figures/style.gp"
              "-DGNUPLOT=${GNUPLOT}" "-DABOUT=${folder}/about.json" -DQUIET=ON
              -P "${PROJECT_SOURCE_DIR}/tools/cmake/run.cmake"
      DEPENDS ${name} "${folder}/figures.gp" "${folder}/about.json"
              "${PROJECT_SOURCE_DIR}/tools/figures/style.gp"
              "${PROJECT_SOURCE_DIR}/tools/cmake/run.cmake"
      COMMENT "Running chapter ${chapter}" VERBATIM)
    add_custom_target(run_${name} DEPENDS "${run}/done")
    set_property(GLOBAL APPEND PROPERTY TIMESTEP_RUNS run_${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY TIMESTEP_CHAPTERS "${chapter}")
endfunction()
