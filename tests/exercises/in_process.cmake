# The exercises on Windows, by mingw's g++: `check_NAME` links the learner's file with the hidden tests, and runs both in
# one process.
include(checking)
include(exercise)
set(generated "${PROJECT_BINARY_DIR}/exercises/generated")
set(checker "${PROJECT_SOURCE_DIR}/tools/checker")
set(course "${PROJECT_SOURCE_DIR}/tools/course")

add_library(checks_in_process OBJECT EXCLUDE_FROM_ALL ${TIMESTEP_JUDGE} ${checker}/check_in_process.cpp ${checker}/reporter.cpp
  ${course}/exercises.cpp ${course}/files.cpp ${course}/misconception.cpp
  ${course}/paths.cpp ${course}/answer_lint.cpp ${course}/verdict_text.cpp ${course}/terminal.cpp)
target_link_libraries(checks_in_process PUBLIC timestep Catch2::Catch2 PRIVATE nlohmann_json::nlohmann_json timestep_warnings)
target_include_directories(checks_in_process PUBLIC ${checker} ${checker}/learner ${checker}/slips "${generated}" PRIVATE ${course})
target_compile_definitions(checks_in_process PUBLIC CATCH_CONFIG_DISABLE_STRINGIFICATION PRIVATE
  TIMESTEP_SOURCE="${PROJECT_SOURCE_DIR}" TIMESTEP_BUILD="${PROJECT_BINARY_DIR}" TIMESTEP_CMAKE="" TIMESTEP_CTEST="")
target_compile_options(checks_in_process PUBLIC -O1)

timestep_answer_writers()

file(GLOB rooms CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "*/*/about.json")
foreach(room IN LISTS rooms)
  string(REGEX MATCH "^([^/]+)/([^/]+)/" room "${room}")
  set(chapter ${CMAKE_MATCH_1})
  set(name ${CMAKE_MATCH_2})
  timestep_read_exercise(${chapter} ${name} "${generated}")
  timestep_write_answers(${chapter} ${name} "${generated}")
  # As the course program compiles it: what the exercise gives, and its declaration, are read before.
  set(header exercise.hpp)
  file(READ "${CMAKE_CURRENT_SOURCE_DIR}/${chapter}/${name}/about.json" json)
  string(JSON eigen GET "${json}" eigen)
  if(eigen)
    set(header exercise_eigen.hpp)
  endif()
  set(ANSWER_${name} "${PROJECT_SOURCE_DIR}/exercises/${chapter}/${name}.cpp" CACHE FILEPATH "The answer that check_${name} checks")
  mark_as_advanced(ANSWER_${name})
  if(NOT EXISTS "${ANSWER_${name}}")
    continue()  # nothing that a learner does to exercises/ may break the build
  endif()
  set_source_files_properties("${ANSWER_${name}}" PROPERTIES COMPILE_OPTIONS
    "-include;${header};-include;${name}_declared.hpp;-Wall;-Wextra;-Wno-unused-parameter;-Werror=return-type;-D_GLIBCXX_ASSERTIONS")
  set_source_files_properties("${generated}/${name}_hidden.cpp" PROPERTIES COMPILE_OPTIONS -Wno-unused-parameter
    OBJECT_DEPENDS "${generated}/${name}_slips.hpp;${generated}/${name}_mistakes.hpp")
  add_executable(in_process_${name} EXCLUDE_FROM_ALL "${ANSWER_${name}}" "${generated}/${name}_check_in_process.cpp"
    "${generated}/${name}_hidden.cpp" "${generated}/${name}_slips.hpp" "${generated}/${name}_mistakes.hpp")
  target_link_libraries(in_process_${name} PRIVATE checks_in_process)
  add_custom_target(check_${name} COMMAND in_process_${name} USES_TERMINAL VERBATIM)
endforeach()
