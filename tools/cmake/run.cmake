# Runs one chapter: its program, its study if there is one and it is asked for, then gnuplot on what they left. Called as
#   cmake -DPROGRAM=… [-DSTUDY=…] -DOUT=… -DROOM=chapters/NN_name -DSTYLE=style.gp -DGNUPLOT=…
#         [-DQUIET=ON] [-DARGUMENTS=--omega;2] [-DCOMPLAINT=file]
#         [-DMISUSES=chapters/…/x.cpp;… -DROOT=… -DCOMPILER=c++] -P run.cmake
# Leaves in OUT: the program's data (*.dat), its output (program.txt), how long it took (seconds.txt) and its
# picture; of the study data (*.tsv), numbers.tsv, checks.tsv, the output (run.txt) and all other figures; of the
# site's own run the figures for phones (narrow/), too. All of it is made in a folder of its own and moved in, file by
# file, when it is whole: a full disk changes nothing, a kill during the moves can leave old files beside new ones.
# ARGUMENTS are the study's.
# MISUSES are sources that must not compile: what the compiler says of x.cpp becomes x.txt.
# COMPLAINT gets an exit status in its first line, and below it what there is to complain of, in the
# complainer's own words: CMake breaks the lines of its error messages.

cmake_minimum_required(VERSION 3.25)

function(complain status text)
  if(DEFINED COMPLAINT)
    file(WRITE "${COMPLAINT}" "${status}\n${text}")
  endif()
endfunction()

function(fail status text)
  file(REMOVE_RECURSE "${work}")
  complain("${status}" "${text}")
  message(FATAL_ERROR "${text}")
endfunction()

# Stops unless the figures in `work` are exactly those that about.json names (`all`), or the program's picture alone, and
# each of them is whole.
function(check_figures all)
  set(about "${ROOM}/about.json")
  file(READ "${about}" json)
  string(JSON named GET "${json}" picture)
  string(JSON figures ERROR_VARIABLE none GET "${json}" figures)
  if(all AND NOT none)
    string(REGEX MATCHALL "[a-z0-9_]+[.](svg|gif)" named "${figures}")
  endif()
  file(GLOB drawn RELATIVE "${work}" "${work}/*.svg" "${work}/*.gif")
  foreach(figure IN LISTS named)
    if(NOT figure IN_LIST drawn)
      fail(2 "${about}: figure ${figure} was not drawn by figures.gp")
    endif()
    # A whole SVG ends with its closing tag, a whole GIF with the byte 3b.
    file(SIZE "${work}/${figure}" size)
    set(tail 0)
    if(size GREATER 8)
      math(EXPR tail "${size} - 8")
    endif()
    file(READ "${work}/${figure}" ending OFFSET ${tail} HEX)
    if(NOT ending MATCHES "(3c2f7376673e(0a)*|3b)$")
      fail(2 "${figure}: was not written to its end (is the disk full?)")
    endif()
  endforeach()
  list(REMOVE_ITEM drawn ${named})
  if(drawn)
    fail(2 "${about}: figures.gp draws ${drawn}, which is not in the list of figures")
  endif()
endfunction()

# Compiles a source that must not compile, and writes the command and what the compiler says into `work`: the error, and
# the place in the source that led to it. Everything is called by its path from ROOT, so no path of this machine is in
# the words.
function(compile_misuse source)
  set(command -std=c++20 -fsyntax-only -Iinclude "${source}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env LC_ALL=C.UTF-8 "${COMPILER}" ${command}
    WORKING_DIRECTORY "${ROOT}" RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
  string(REGEX MATCH "[^\n]*: error: timestep: [^\n]*|[^\n]*: error: static[^\n]*timestep: [^\n]*"
         error "${words}")
  if(status EQUAL 0)
    fail(2 "${source}: compiles, and must not")
  elseif(NOT error)
    fail(2 "${source}: does not compile, but for another reason:\n${words}")
  endif()
  # g++ names the line of the source before the error, clang++ after it.
  cmake_path(GET source FILENAME file)
  string(REGEX MATCH "[^\n]*${file}:[0-9:]+ [^\n]*(required from|requested here)[^\n]*" place "${words}")
  string(FIND "${words}" "${error}" error_at)
  string(FIND "${words}" "${place}" place_at)
  set(said "${error}\n${place}")
  if(place_at LESS error_at)
    set(said "${place}\n${error}")
  endif()
  cmake_path(GET COMPILER FILENAME name)
  list(JOIN command " " options)
  cmake_path(GET source STEM stem)
  file(WRITE "${work}/${stem}.txt" "$ ${name} ${options}\n${said}\n")
endfunction()

# The same program and the same script make the same run: nothing is run for a program that was only
# built again, as long as all that the run left is there.
set(made_from "${GNUPLOT}\n")
get_filename_component(styles "${STYLE}" DIRECTORY)
file(GLOB scripts "${ROOM}/*.gp" "${ROOM}/study/*.gp" "${styles}/*.gp" "${CMAKE_CURRENT_LIST_DIR}/run.cmake")
file(REAL_PATH "${GNUPLOT}" gnuplot)
if(NOT EXISTS "${gnuplot}")
  set(gnuplot "")  # the reader's own run finds it by its name
endif()
foreach(file IN ITEMS "${PROGRAM}" ${STUDY} "${ROOM}/about.json" ${scripts} ${gnuplot})
  file(SHA256 "${file}" sum)
  string(APPEND made_from "${sum}\n")
endforeach()
# (What the compiler says of a misuse depends on the library, too; a reader's own run is always made.)
if(EXISTS "${OUT}/made_from.txt" AND NOT MISUSES AND NOT DEFINED COMPLAINT)
  file(READ "${OUT}/made_from.txt" before)
  string(FIND "${before}" "${made_from}" place)
  string(REGEX MATCHALL "left ([^\n]+)" left "${before}")
  set(whole ON)
  foreach(line IN LISTS left)
    string(SUBSTRING "${line}" 5 -1 file)
    if(NOT EXISTS "${OUT}/${file}")
      set(whole OFF)
    endif()
  endforeach()
  if(place EQUAL 0 AND left AND whole)
    file(TOUCH "${OUT}/done")
    return()
  endif()
endif()

# Another run may be at work in OUT: the folder's name is new.
string(RANDOM LENGTH 12 word)
set(work "${OUT}/.unfinished_run_${word}")
file(MAKE_DIRECTORY "${work}")

# Runs a program in `work` and sets `printed` to what it prints. `options` names the list of its options, in which
# a semicolon may be part of one.
function(output_of program options)
  set(out "")
  if(program STREQUAL STUDY)
    set(out --out "${work}")
  endif()
  execute_process(COMMAND "${program}" ${out} ${${options}} WORKING_DIRECTORY "${work}"
    OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE status)
  if(NOT status MATCHES "^[0-9]+$")  # ended by a signal: CMake gives its name
    fail(1 "${program}: ${status}")
  elseif(NOT status EQUAL 0)
    fail(${status} "${complaint}")
  endif()
  complain(0 "${complaint}")
  if(NOT QUIET)
    message(NOTICE "${printed}")
  endif()
  set(printed "${printed}" PARENT_SCOPE)
endfunction()

# -d: as gnuplot is, whatever the reader's ~/.gnuplot makes of it. The site shows every figure in two widths: the narrow
# ones go into the folder narrow.
function(draw script)
  draw_once("${script}" 0)
  if(NOT DEFINED COMPLAINT)
    file(MAKE_DIRECTORY "${work}/narrow")
    draw_once("${script}" 1)
  endif()
endfunction()
function(draw_once script narrow)
  execute_process(COMMAND "${GNUPLOT}" -d -e "narrow = ${narrow}; style = '${STYLE}'" "${script}"
    WORKING_DIRECTORY "${work}" ERROR_VARIABLE complaint OUTPUT_VARIABLE complaint
    RESULT_VARIABLE status)
  string(REGEX REPLACE "[0-9]+ frames in animation sequence" "" complaint "${complaint}")
  string(STRIP "${complaint}" complaint)
  if(NOT status EQUAL 0 OR NOT complaint STREQUAL "")
    fail(2 "${script}: gnuplot says:\n${complaint}")
  endif()
endfunction()

string(TIMESTAMP begin "%s%f")
output_of("${PROGRAM}" none)
string(TIMESTAMP end "%s%f")
math(EXPR milliseconds "(${end} - ${begin}) / 1000")
file(WRITE "${work}/program.txt" "${printed}")
file(WRITE "${work}/seconds.txt" "${milliseconds} ms\n")
draw("${ROOM}/figures.gp")
if(STUDY)
  output_of("${STUDY}" ARGUMENTS)
  file(WRITE "${work}/run.txt" "${printed}")
  draw("${ROOM}/study/figures.gp")
endif()
set(all ON)
if(NOT STUDY AND EXISTS "${ROOM}/study")  # it was not asked for
  set(all OFF)
endif()
check_figures(${all})
foreach(source IN LISTS MISUSES)
  compile_misuse("${source}")
endforeach()

if(NOT DEFINED COMPLAINT)  # a reader's folder may hold files of the reader's own
  file(REMOVE "${OUT}/made_from.txt")  # as long as old and new stand side by side
  file(GLOB old "${OUT}/*.dat" "${OUT}/*.tsv" "${OUT}/*.svg" "${OUT}/*.gif")
  if(old)
    file(REMOVE ${old})
  endif()
  file(REMOVE_RECURSE "${OUT}/narrow")
endif()
file(GLOB made RELATIVE "${work}" "${work}/*")
foreach(file IN LISTS made)  # moving takes no space: a full disk cannot stop it half-way
  file(RENAME "${work}/${file}" "${OUT}/${file}")
  string(APPEND made_from "left ${file}\n")
endforeach()
file(REMOVE_RECURSE "${work}")
if(NOT DEFINED COMPLAINT)
  file(WRITE "${OUT}/made_from.txt" "${made_from}")
  file(TOUCH "${OUT}/done")
endif()
