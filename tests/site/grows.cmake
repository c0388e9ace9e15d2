# A site of what is there so far: with the run of the first chapter alone, with the second's, and when the
# whole one is there. Called as
#   cmake -DWORK=folder -DCHAPTERS=folder of the runs -DGROW=grow_site.cmake -DLINKS=links.py -DPYTHON=…
#         and what GROW takes, -P grows.cmake
cmake_minimum_required(VERSION 3.25)
set(RUNS "${WORK}/runs")
set(html "${WORK}/html")
file(REMOVE_RECURSE "${html}" "${RUNS}" "${WORK}/growing/drawn.txt")

function(says page words)
  file(READ "${html}/${page}.html" text)
  string(FIND "${text}" "${words}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${page}.html does not say: ${words}")
  endif()
endfunction()
function(silent_on page words)
  file(READ "${html}/${page}.html" text)
  string(FIND "${text}" "${words}" place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "${page}.html says: ${words}")
  endif()
endfunction()
function(grow)
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DWHOLE=${WORK}" "-DROOT=${ROOT}" "-DRUNS=${RUNS}" "-DPAGE=${PAGE}"
    "-DSHOWN=${WORK}/shown" "-DDOXYGEN=${DOXYGEN}" "-DDOXYFILE=${DOXYFILE}" "-DSITE=${SITE}" "-DFIGURES=${FIGURES}"
    "-DHEADS=${HEADS}" "-DKATEX=${KATEX}" "-DFINISH_SITE=${FINISH_SITE}"
    "-DLIBRARY=${LIBRARY}" "-DUNLINKED=${UNLINKED}" -P "${GROW}"
    RESULT_VARIABLE status ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${words}")
  endif()
  if(NOT EXISTS "${WORK}/shown")
    message(FATAL_ERROR "nothing says that it was shown")
  endif()
  file(REMOVE "${WORK}/shown")
endfunction()
function(links_lead_somewhere)
  execute_process(COMMAND "${PYTHON}" "${LINKS}" "${html}" RESULT_VARIABLE status OUTPUT_VARIABLE words
    ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${words}")
  endif()
endfunction()

file(GLOB chapters RELATIVE "${CHAPTERS}" "${CHAPTERS}/0*")
list(GET chapters 0 first)
list(GET chapters 1 second)
set(draft "<b>This page is being made.</b>")
file(MAKE_DIRECTORY "${RUNS}")
file(CREATE_LINK "${CHAPTERS}/${first}" "${RUNS}/${first}" SYMBOLIC)
grow()
silent_on(chapter_01 "${draft}")
says(chapter_02 "${draft}")
says(chapter_02 "Not there yet")
says(index "${draft}")
says(index "being made")
links_lead_somewhere()

# With nothing new it is left as it is.
function(grows_not words)
  file(TIMESTAMP "${html}/index.html" before "%s%f")
  grow()
  file(TIMESTAMP "${html}/index.html" after "%s%f")
  if(NOT before STREQUAL after)
    message(FATAL_ERROR "${words}")
  endif()
endfunction()
grows_not("made again with nothing new")

file(CREATE_LINK "${CHAPTERS}/${second}" "${RUNS}/${second}" SYMBOLIC)
grow()
silent_on(chapter_01 "${draft}")
says(chapter_03 "${draft}")
says(chapter_02 "fig-")
links_lead_somewhere()

# A whole site stays.
file(WRITE "${html}/made" "")
file(REMOVE "${WORK}/growing/drawn.txt")
grows_not("a draft has taken the place of the whole site")
