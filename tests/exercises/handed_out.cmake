# The course is handed out unsolved: every file of exercises/ is what the build makes of its solution. Who learns
# has answers there; so this is for whoever hands it out. Expects ROOT, GENERATED.
cmake_minimum_required(VERSION 3.25)

file(GLOB rooms RELATIVE "${ROOT}/tests/exercises" "${ROOT}/tests/exercises/*/*/about.json")
foreach(room IN LISTS rooms)
  cmake_path(GET room PARENT_PATH exercise)
  cmake_path(GET exercise FILENAME name)
  set(file "${ROOT}/exercises/${exercise}.cpp")
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files "${GENERATED}/${name}_stub.cpp" "${file}"
    RESULT_VARIABLE differs OUTPUT_QUIET ERROR_QUIET)
  if(differs)
    message(SEND_ERROR "exercises/${exercise}.cpp is not what the build makes of solutions/${exercise}.cpp; "
      "./course reset --all makes it so, and keeps an answer that is in it")
  endif()
endforeach()
