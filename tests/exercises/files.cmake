# Every exercise has its file in exercises/, and every file there its tests: one without would never be
# checked. Hidden files are an editor's. Expects ROOT.
cmake_minimum_required(VERSION 3.25)

file(GLOB rooms RELATIVE "${ROOT}/tests/exercises" "${ROOT}/tests/exercises/*/*/about.json")
list(TRANSFORM rooms REPLACE "/about.json$" ".cpp")
file(GLOB files RELATIVE "${ROOT}/exercises" "${ROOT}/exercises/*/*.cpp")
list(FILTER files EXCLUDE REGEX "/\\.")

foreach(file IN LISTS rooms)
  if(NOT file IN_LIST files)
    message(SEND_ERROR "exercises/${file} is missing")
  endif()
endforeach()
foreach(file IN LISTS files)
  if(NOT file IN_LIST rooms)
    message(SEND_ERROR "exercises/${file}: has no tests in tests/exercises")
  endif()
endforeach()
