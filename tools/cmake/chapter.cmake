# A chapter is a folder chapters/NN_name with
#   chapter.md  the page          name.cpp    its program: one short file
#   figures.gp  its figures       about.json  title, question and picture
# and, where it needs them,
#   study/      sources that find the page's numbers and checks, with a figures.gp of their own;
#               what the compiler says of the sources in study/does_not_compile, the page can show
#   live/       panels            more.md     a second page for what goes deeper
# A chapter that lacks one of the four is a configure error. about.json may also list figures (if there are more than
# the picture), needs, builds_on (earlier chapters) and claims (of the talks). tests/chapters/NN_name.cpp holds tests.

find_program(GNUPLOT gnuplot)

# Sets `result` to a list of strings from about.json; to nothing if it is not there.
function(timestep_json_list json key result)
  string(JSON count ERROR_VARIABLE none LENGTH "${json}" ${key})
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

# Reads the about.json of a chapter: sets title, question, picture, figures, needs, builds_on and claims.
function(timestep_read_chapter chapter)
  set(file "${PROJECT_SOURCE_DIR}/chapters/${chapter}/about.json")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(READ "${file}" about)
  function(wrong_about words)
    message(FATAL_ERROR "chapters/${chapter}/about.json: ${words}")
  endfunction()
  string(JSON type ERROR_VARIABLE error TYPE "${about}")
  if(error)
    wrong_about("is not JSON (${error})")
  endif()
  foreach(key title question picture)
    string(JSON words ERROR_VARIABLE error GET "${about}" ${key})
    string(JSON type ERROR_VARIABLE error TYPE "${about}" ${key})
    if(NOT type STREQUAL "STRING" OR words STREQUAL "")
      wrong_about("${key} must be words")
    endif()
    set(${key} "${words}")
  endforeach()
  foreach(key figures needs builds_on claims)
    string(JSON type ERROR_VARIABLE error TYPE "${about}" ${key})
    if(NOT error AND NOT type STREQUAL "ARRAY")
      wrong_about("${key} must be a list")
    endif()
    timestep_json_list("${about}" ${key} ${key})
  endforeach()
  if(NOT figures)
    set(figures "${picture}")
  endif()
  foreach(figure IN LISTS figures)
    if(NOT figure MATCHES "^[a-z0-9_]+\\.(svg|gif)$")
      wrong_about("figures names ${figure}, must be name.svg or name.gif in small letters")
    endif()
  endforeach()
  if(NOT picture IN_LIST figures)
    wrong_about("picture is ${picture}, must be one of figures")
  endif()
  foreach(need IN LISTS needs)
    if(NOT need MATCHES "^(eigen|peers|contest|extremes|advise)$")
      wrong_about("needs names ${need}, and knows eigen, peers, contest, extremes and advise only")
    endif()
  endforeach()
  foreach(earlier IN LISTS builds_on)
    if(NOT EXISTS "${PROJECT_SOURCE_DIR}/chapters/${earlier}/about.json")
      wrong_about("builds_on names ${earlier}, which is no chapter")
    endif()
  endforeach()
  foreach(key title question picture figures needs builds_on claims)
    set(${key} "${${key}}" PARENT_SCOPE)
  endforeach()
endfunction()

# Declares the chapter in the folder chapters/${chapter}: its program `name`, its study `name_study`, if it has one, and
# the run of both, which leaves data, numbers and figures in ${build}/chapters/NN_name/run.
function(timestep_chapter chapter)
  if(NOT chapter MATCHES "^[0-9][0-9]_[a-z][a-z0-9_]*$")
    message(FATAL_ERROR "chapters/${chapter}: a chapter's folder is named NN_name: two digits and a name in small letters")
  endif()
  string(REGEX REPLACE "^[0-9]+_" "" name "${chapter}")
  set(folder "${PROJECT_SOURCE_DIR}/chapters/${chapter}")
  set(parts about.json chapter.md ${name}.cpp figures.gp)
  file(GLOB sources CONFIGURE_DEPENDS "${folder}/study/*.cpp")
  if(sources)
    list(APPEND parts study/figures.gp)
  endif()
  foreach(part IN LISTS parts)
    if(NOT EXISTS "${folder}/${part}")
      message(FATAL_ERROR "chapter ${chapter}: chapters/${chapter}/${part} is missing (tools/cmake/chapter.cmake lists "
                          "the files of a chapter)")
    endif()
  endforeach()
  timestep_read_chapter(${chapter})

  # The program needs the library alone: one line compiles it, too.
  set(library timestep_headers)
  if("eigen" IN_LIST needs)
    set(library timestep)
  endif()
  add_executable(${name} "${folder}/${name}.cpp")
  target_link_libraries(${name} PRIVATE ${library} timestep_warnings)

  set(study "")
  set(study_program "")
  if(sources)
    set(study ${name}_study)
    set(study_program "$<TARGET_FILE:${study}>")
    add_executable(${study} ${sources})
    target_link_libraries(${study} PRIVATE ${library} timestep_lab timestep_warnings)
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
  endif()

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
      COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:${name}>" "-DSTUDY=${study_program}"
              "-DOUT=${run}" "-DROOM=${folder}" "-DSTYLE=${PROJECT_SOURCE_DIR}/tools/figures/style.gp"
              "-DGNUPLOT=${GNUPLOT}" -DQUIET=ON
              "-DMISUSES=${misuses}" "-DROOT=${PROJECT_SOURCE_DIR}" "-DCOMPILER=${CMAKE_CXX_COMPILER}"
              -P "${PROJECT_SOURCE_DIR}/tools/cmake/run.cmake"
      DEPENDS ${name} ${study} ${scripts} "${folder}/about.json"
              "${PROJECT_SOURCE_DIR}/tools/figures/style.gp"
              "${PROJECT_SOURCE_DIR}/tools/cmake/run.cmake"
              ${misuse_paths}
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
