# Makes the site: Doxygen on the filled pages, then what Doxygen cannot do. Called as
#   cmake -DDOXYGEN=… -DDOXYFILE=… -DSITE=… -DHEADS="a.html;b.html" -DKATEX=folder
#         -DFIGURES=folder -DFINISH_SITE=program -DLIBRARY=docs/library -DLUNR=folder [-DUNLINKED=tests/] -P make_site.cmake
# All of it happens in SITE/unfinished, which becomes SITE/html when nothing went wrong. There the file
# `made` tells that the site is whole.

cmake_minimum_required(VERSION 3.25)
set(html "${SITE}/unfinished")

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${SITE}"
    RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    message(NOTICE "${words}")
    message(FATAL_ERROR "The site was not made; the reason stands above.")
  endif()
endfunction()

# The header is this Doxygen's own with our lines added, so that it fits every version. MathJax
# gives way to KaTeX.
file(MAKE_DIRECTORY "${SITE}")
if(EXISTS "${SITE}/html.old" AND NOT EXISTS "${SITE}/html")  # somebody was stopped just there
  file(RENAME "${SITE}/html.old" "${SITE}/html")
endif()
file(TOUCH "${SITE}/header.html" "${SITE}/footer.html")  # the Doxyfile names them
run("${DOXYGEN}" -w html header.html footer.html theme.css "${DOXYFILE}")
file(READ "${SITE}/header.html" header)
set(lines "")
foreach(head IN LISTS HEADS)
  file(READ "${head}" more)
  string(APPEND lines "${more}")
endforeach()
string(REPLACE "$mathjax" "" header "${header}")
string(REPLACE "</head>" "${lines}</head>" header "${header}")
if(NOT header MATCHES "<html[^>]* lang=")  # a later Doxygen writes it itself
  string(REPLACE "<html " "<html lang=\"en\" " header "${header}")
endif()
file(WRITE "${SITE}/header.html" "${header}")

file(REMOVE_RECURSE "${html}")
run("${DOXYGEN}" "${DOXYFILE}")

file(COPY "${FIGURES}/" DESTINATION "${html}/figures")
if(KATEX)
  file(COPY "${KATEX}/katex.min.css" DESTINATION "${html}/katex")
  file(COPY "${KATEX}/contrib/auto-render.js" DESTINATION "${html}/katex")
  # Links in Debian's package: copy what they lead to.
  file(REAL_PATH "${KATEX}/katex.min.js" script)
  configure_file("${script}" "${html}/katex/katex.min.js" COPYONLY)
  file(REAL_PATH "${KATEX}/fonts" fonts)
  file(GLOB fonts "${fonts}/*.woff2")
  file(COPY ${fonts} DESTINATION "${html}/katex/fonts")
endif()
if(LUNR)
  configure_file("${LUNR}/lunr.min.js" "${html}/lunr.min.js" COPYONLY)
  # What Doxygen's own search would read.
  file(GLOB unread "${html}/search/*_*.js" "${html}/search/*_*.html")
  if(unread)
    file(REMOVE ${unread})
  endif()
endif()
run("${FINISH_SITE}" "${html}" "${SITE}/names.tag" "${LIBRARY}" ${UNLINKED})

# What a reader takes home, as plain files: each with what it includes, in the folders by which that is included.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
function(take_home file)
  set(from "${root}/include/${file}")
  if(NOT EXISTS "${from}")
    set(from "${root}/engines/${file}")
  endif()
  set(to "${html}/take_home/${file}")
  if(NOT EXISTS "${to}")
    configure_file("${from}" "${to}" COPYONLY)
    file(STRINGS "${from}" lines REGEX "^#include (<timestep/|\")")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include [<\"]([^>\"]+).*" "\\1" included "${line}")
      take_home("${included}")
    endforeach()
  endif()
endfunction()
foreach(file timestep/gyroscopic.h bullet_adapter.hpp ode_adapter.hpp box3d_half_step.patch box3d_after_contacts.patch
    jolt_after_contacts.patch jolt_halves.patch passive_in_unity.cs)
  take_home("${file}")
endforeach()
configure_file("${root}/LICENSE" "${html}/take_home/LICENSE.txt" COPYONLY)
run("${CMAKE_COMMAND}" -E chdir "${html}" "${CMAKE_COMMAND}" -E tar cf take_home.zip --format=zip "--mtime=2020-01-01 00:00:00" take_home)

file(WRITE "${html}/made" "")
# Whoever is stopped here leaves a site.
function(put_in_place from to)
  file(REMOVE_RECURSE "${to}.old")
  if(EXISTS "${to}")
    file(RENAME "${to}" "${to}.old")
  endif()
  file(RENAME "${from}" "${to}")
  file(REMOVE_RECURSE "${to}.old")
endfunction()
put_in_place("${html}" "${SITE}/html")
