# How the site is made: from pages that are filled from the runs, by Doxygen, with a theme. Included before
# the chapters, which show themselves on the growing site as soon as each has run.
find_program(DOXYGEN doxygen)
set(site "${PROJECT_BINARY_DIR}/site")
set(theme "${PROJECT_SOURCE_DIR}/docs/theme")

# Two packages make the site pretty; without them it has Doxygen's looks and formulas in TeX.
find_path(KATEX katex.min.css PATHS /usr/share/javascript/katex /usr/share/nodejs/katex/dist)
find_path(AWESOME doxygen-awesome.css PATHS /usr/share/doxygen-awesome-css)
if(NOT KATEX)
  message(STATUS "KaTeX not found: formulas stand as TeX source (package libjs-katex)")
endif()
find_path(LUNR lunr.min.js PATHS /usr/share/javascript/lunr)
if(NOT LUNR)
  message(STATUS "lunr not found: the search knows names alone (package libjs-lunr)")
endif()
if(NOT AWESOME)
  message(STATUS "doxygen-awesome-css not found: Doxygen's own theme (package doxygen-awesome-css)")
endif()

set(heads "${theme}/head.html")
set(styles "")
# A reader's browser needs no comments, and no blanks before a line or round an operator (none of our words holds these).
set(scripts "${theme}/logo.svg" "${PROJECT_BINARY_DIR}/docs/LICENSE.txt")
configure_file("${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_BINARY_DIR}/docs/LICENSE.txt" COPYONLY)
set(own_scripts timestep live film)
if(LUNR)
  list(APPEND own_scripts search)
endif()
foreach(script IN LISTS own_scripts)
  file(READ "${theme}/${script}.js" text)
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${theme}/${script}.js")
  string(REGEX REPLACE "\n +" "\n" text "\n${text}")
  string(REGEX REPLACE "\n//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "  // [^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n\n+" "\n" text "${text}")
  string(REGEX REPLACE " (=>|=|===|!==|<|<=|>=|[|][|]|[?]|:|[*]|[|][|]=|[*]=|[-]=|[+]=) " "\\1" text "${text}")
  string(REGEX REPLACE " ?([{]) ?" "\\1" text "${text}")
  string(REGEX REPLACE " ([}])" "\\1" text "${text}")
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/docs/${script}.js" CONTENT "${text}" @ONLY)
  list(APPEND scripts "${PROJECT_BINARY_DIR}/docs/${script}.js")
endforeach()
if(AWESOME)
  foreach(part "" -sidebar-only -sidebar-only-darkmode-toggle)
    list(APPEND styles "${AWESOME}/doxygen-awesome${part}.css")
  endforeach()
  foreach(part darkmode-toggle fragment-copy-button interactive-toc)
    list(APPEND scripts "${AWESOME}/doxygen-awesome-${part}.js")
  endforeach()
  list(APPEND heads "${theme}/head_awesome.html")
endif()
list(APPEND styles "${theme}/timestep.css")
if(KATEX)
  list(APPEND heads "${theme}/head_katex.html")
endif()
if(LUNR)
  list(APPEND heads "${theme}/head_lunr.html")
endif()

foreach(file "${LUNR}/lunr.min.js" "${KATEX}/katex.min.css" "${AWESOME}/doxygen-awesome.css")
  if(EXISTS "${file}")  # once it is gone we look again
    set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endif()
endforeach()

# Doxygen's lists are words between quotes.
function(doxygen_list variable)
  list(JOIN ARGN "\" \"" words)
  set(${variable} "\"${words}\"" PARENT_SCOPE)
endfunction()
doxygen_list(stylesheets ${styles})
doxygen_list(extra_files ${scripts})
set(filter "$<TARGET_FILE:source_filter>")
set(library "${PROJECT_SOURCE_DIR}/docs/library")
set(colour_style "")
if(DOXYGEN)
  # From 1.9.5 on Doxygen has a dark mode of its own, which the theme's replaces.
  execute_process(COMMAND "${DOXYGEN}" --version OUTPUT_VARIABLE version)
  if(AWESOME AND version VERSION_GREATER_EQUAL 1.9.5)
    set(colour_style "HTML_COLORSTYLE = LIGHT")
  endif()
  # From 1.9.8 on "modules" are those of C++20.
  set(groups_tab modules)
  if(version VERSION_GREATER_EQUAL 1.9.8)
    set(groups_tab topics)
  endif()
  configure_file("${theme}/layout.xml" "${PROJECT_BINARY_DIR}/docs/layout.xml" @ONLY)
endif()

# Writes a Doxyfile for the pages in the folder `pages`, and sets `make` to what make_site.cmake must know
# to make the site ${site}/html from it, with the figures in `figures`. `tests` is the folder of the tests, or nothing.
# A gap in the documentation is an error, or with OFF none.
function(timestep_doxyfile name site pages figures tests strict make)
  doxygen_list(inputs "${pages}" "${PROJECT_SOURCE_DIR}/include" "${library}" "${PROJECT_SOURCE_DIR}/engines" "${PROJECT_SOURCE_DIR}/chapters"
    "${PROJECT_SOURCE_DIR}/tools/lab" "${PROJECT_SOURCE_DIR}/tools/bench/contest" ${tests})
  set(unlinked "")
  if(NOT tests)
    set(unlinked tests/)
  endif()
  set(as_error NO)
  if(strict)
    set(as_error FAIL_ON_WARNINGS)
  endif()
  set(configured "${PROJECT_BINARY_DIR}/docs/Doxyfile_${name}")
  configure_file("${PROJECT_SOURCE_DIR}/docs/Doxyfile.in" "${configured}" @ONLY)
  set(doxyfile "${PROJECT_BINARY_DIR}/docs/${name}.doxyfile")
  file(GENERATE OUTPUT "${doxyfile}" INPUT "${configured}")
  string(REPLACE ";" "\\;" all_heads "${heads}")
  set(${make} "-DDOXYGEN=${DOXYGEN}" "-DDOXYFILE=${doxyfile}" "-DSITE=${site}"
    "-DFIGURES=${figures}" "-DHEADS=${all_heads}" "-DKATEX=${KATEX}"
    "-DFINISH_SITE=$<TARGET_FILE:finish_site>" "-DLIBRARY=${library}" "-DLUNR=${LUNR}" "-DUNLINKED=${unlinked}" PARENT_SCOPE)
endfunction()

# Which chapters, second pages and exercises there are: pages name them all, and a new one changes this file.
file(GLOB rooms CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/*/about.json" "${PROJECT_SOURCE_DIR}/chapters/*/more.md" "${PROJECT_SOURCE_DIR}/tests/exercises/*/*/about.json")
list(JOIN rooms "\n" rooms)
set(list_of_rooms "${PROJECT_BINARY_DIR}/docs/rooms.txt")
file(CONFIGURE OUTPUT "${list_of_rooms}" CONTENT "${rooms}\n" @ONLY)

# How a page is filled.
set(fill page --source "${PROJECT_SOURCE_DIR}" --runs "${PROJECT_BINARY_DIR}/chapters")

# The runs that a page names besides its own: {{03_euler_variants/amplitude}}.
function(timestep_runs_named_in page result)
  file(STRINGS "${page}" lines REGEX "{{")
  string(REGEX MATCHALL "(instructions|programs|exercises|in_engines|library|[0-9][0-9]_[a-z0-9_]+)/[a-z0-9_]+[^a-z0-9_/]" named "${lines}")
  list(TRANSFORM named REPLACE "/.*" "")
  list(REMOVE_DUPLICATES named)
  set(${result} ${named} PARENT_SCOPE)
endfunction()

# The page of the chapter in chapters/${chapter}, and its second one where there is a more.md, each filled from the chapter's
# run and from those that it names. The numbers of its figures make each depend on the other's source (DEPFILE).
function(timestep_page chapter)
  get_property(live GLOBAL PROPERTY TIMESTEP_LIVE_${chapter})
  set(runs_of_pages ${chapter})
  set(outputs "")
  foreach(page chapter more)
    set(input "${PROJECT_SOURCE_DIR}/chapters/${chapter}/${page}.md")
    if(page STREQUAL "chapter")
      set(name "${chapter}")
    elseif(EXISTS "${input}")
      set(name "${chapter}_more")
    else()  # nor is one left from when there was
      file(REMOVE "${site}/pages/${chapter}_more.md" "${site}/index/${chapter}_more.tsv"
        "${site}/growing/pages/${chapter}_more.md" "${site}/growing/index/${chapter}_more.tsv")
      continue()
    endif()
    set(output "${site}/pages/${name}.md")
    set(index "${site}/index/${name}.tsv")
    timestep_runs_named_in("${input}" named)
    list(TRANSFORM named REPLACE "(.+)" "${PROJECT_BINARY_DIR}/chapters/\\1/run/done" OUTPUT_VARIABLE runs)
    add_custom_command(
      OUTPUT "${output}" "${index}"
      COMMAND ${fill} --figures "${site}/figures" --chapter ${chapter} --input "${input}"
              --output "${output}" --index "${index}" --depfile "${output}.d"
      DEPENDS page "${input}" "${list_of_rooms}" ${runs} "${PROJECT_BINARY_DIR}/chapters/${chapter}/run/done" ${live}
      DEPFILE "${output}.d" COMMENT "Filling the page of ${name}" VERBATIM)
    list(APPEND runs_of_pages ${named})
    list(APPEND outputs "${output}")
    set_property(GLOBAL APPEND PROPERTY TIMESTEP_INDEXES "${index}")
  endforeach()
  add_custom_target(page_${chapter} DEPENDS ${outputs})
  foreach(run IN LISTS runs_of_pages)
    string(REGEX REPLACE "^[0-9]+_" "" run "${run}")
    add_dependencies(page_${chapter} run_${run})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY TIMESTEP_PAGES ${outputs})
  set_property(GLOBAL APPEND PROPERTY TIMESTEP_PAGE_TARGETS page_${chapter})
endfunction()

# ---- The growing site ------------------------------------------------------------------------------

# As long as there is no whole site, each chapter that has run makes one of what is there so far: drafts of
# all pages, with gaps. Targets grow_NN_name; `./course tour` asks for them.
timestep_doxyfile(growing "${site}/growing" "${site}/growing/pages" "${site}/growing/figures" "" OFF make_draft)
set_property(GLOBAL APPEND PROPERTY JOB_POOLS growing_site=1)

function(timestep_grows chapter)
  string(REGEX REPLACE "^0*([0-9]+)_.*" "\\1" number "${chapter}")
  set(shown "${site}/growing/shown_${chapter}")
  get_property(live GLOBAL PROPERTY TIMESTEP_LIVE_${chapter})
  add_custom_command(OUTPUT "${shown}"
    COMMAND "${CMAKE_COMMAND}" "-DWHOLE=${site}" "-DROOT=${PROJECT_SOURCE_DIR}" "-DRUNS=${PROJECT_BINARY_DIR}/chapters"
            "-DPAGE=$<TARGET_FILE:page>" "-DSHOWN=${shown}" ${make_draft}
            -P "${PROJECT_SOURCE_DIR}/docs/grow_site.cmake"
    DEPENDS "${PROJECT_BINARY_DIR}/chapters/${chapter}/run/done" ${live} page source_filter finish_site
    JOB_POOL growing_site COMMENT "Chapter ${number} can be read" VERBATIM)
  add_custom_target(grow_${chapter} DEPENDS "${shown}")
  string(REGEX REPLACE "^[0-9]+_" "run_" run "${chapter}")
  add_dependencies(grow_${chapter} ${run})
  if(NOT TARGET first_chapter)
    add_custom_target(first_chapter)
    add_dependencies(first_chapter grow_${chapter})
  endif()
endfunction()
