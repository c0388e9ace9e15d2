# Makes a site of what is there so far, in place of the whole one that is still to come. Called as
#   cmake -DWHOLE=folder -DROOT=… -DRUNS=… -DPAGE=program -DSHOWN=file, and what make_site.cmake
#         takes, with SITE for the site in the making, -P grow_site.cmake
# Every page is drafted, with gaps where something comes from a run that is still to be made. A whole
# site is left alone: it has the file `made`.
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY "${SITE}")
file(LOCK "${WHOLE}/growing.lock" GUARD PROCESS)

file(GLOB runs RELATIVE "${RUNS}" "${RUNS}/*/run/done")
set(there "")
file(GLOB sources "${ROOT}/chapters/*/chapter.md" "${ROOT}/chapters/*/more.md" "${ROOT}/docs/*.md" "${ROOT}/engines/*.md" "${ROOT}/docs/*/*.dox")
list(TRANSFORM runs PREPEND "${RUNS}/" OUTPUT_VARIABLE marks)
foreach(file IN LISTS marks sources)
  file(TIMESTAMP "${file}" time "%s%f")
  string(APPEND there "${file} ${time}\n")
endforeach()
set(drawn "")
if(EXISTS "${WHOLE}/html/index.html" AND EXISTS "${SITE}/drawn.txt")
  file(READ "${SITE}/drawn.txt" drawn)
endif()
if(EXISTS "${WHOLE}/html/made" OR drawn STREQUAL there)
  file(TOUCH "${SHOWN}")
  return()
endif()

function(draft)
  execute_process(COMMAND "${PAGE}" --source "${ROOT}" --runs "${RUNS}" --draft yes
    --figures "${SITE}/figures" ${ARGN} RESULT_VARIABLE status ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${words}")
  endif()
endfunction()
file(GLOB chapters RELATIVE "${ROOT}/chapters" "${ROOT}/chapters/*/chapter.md" "${ROOT}/chapters/*/more.md")
foreach(page IN LISTS chapters)
  cmake_path(GET page PARENT_PATH chapter)
  set(name "${chapter}")
  if(page MATCHES "/more.md$")
    string(APPEND name "_more")
  endif()
  draft(--chapter ${chapter} --input "${ROOT}/chapters/${page}" --output "${SITE}/pages/${name}.md"
    --index "${SITE}/index/${name}.tsv")
endforeach()
file(GLOB pages "${ROOT}/docs/*.md" "${ROOT}/engines/*.md" "${ROOT}/docs/*/*.dox")
foreach(page IN LISTS pages)
  cmake_path(GET page FILENAME name)
  draft(--input "${page}" --output "${SITE}/pages/${name}" --indexes "${SITE}/index")
endforeach()

include("${CMAKE_CURRENT_LIST_DIR}/make_site.cmake")
file(REMOVE "${SITE}/html/made")  # it is not the whole site
if(NOT EXISTS "${WHOLE}/html/made")  # which may have been made meanwhile
  put_in_place("${SITE}/html" "${WHOLE}/html")
endif()
file(WRITE "${SITE}/drawn.txt" "${there}")
file(TOUCH "${SHOWN}")
