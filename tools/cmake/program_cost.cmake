# What a chapter's program costs to make, as a line of a table:
#   cmake -DCHAPTER=03_… -DPROGRAM=binary -DSOURCE=name.cpp -DABOUT=about.json -DCOMMANDS=compile_commands.json
#         -DOUT=file -P program_cost.cmake
# With -DLINES=a;b -DTABLE=file the lines are put together instead.
cmake_minimum_required(VERSION 3.25)

if(LINES)
  set(table "chapter\tits study needs Eigen\tits program does\tbinary (KB)\tlines that the compiler reads\n")
  foreach(line IN LISTS LINES)
    file(READ "${line}" text)
    string(APPEND table "${text}")
  endforeach()
  file(WRITE "${TABLE}" "${table}")
  cmake_path(GET TABLE PARENT_PATH run)
  file(WRITE "${run}/places.tsv"  # for ./course where
    "name\tkind\tplace\nprograms.tsv\tdata\ttools/cmake/program_cost.cmake:${CMAKE_CURRENT_LIST_LINE}\n")
  return()
endif()

file(READ "${ABOUT}" about)
string(JSON needs GET "${about}" needs)
set(eigen "no")
if(needs MATCHES "eigen")
  set(eigen "yes")
endif()
file(SIZE "${PROGRAM}" bytes)
math(EXPR kilobytes "(${bytes} + 500) / 1000")

# The build's own command for that source, where the build has left it.
set(command "")
if(EXISTS "${COMMANDS}")
  file(READ "${COMMANDS}" commands)
  string(JSON count LENGTH "${commands}")
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON file GET "${commands}" ${i} file)
    if(file STREQUAL SOURCE)
      string(JSON command GET "${commands}" ${i} command)
      string(JSON directory GET "${commands}" ${i} directory)
      break()
    endif()
  endforeach()
endif()
set(lines "–")
set(includes "–")
find_program(SHELL sh)
if(command AND SHELL)
  string(REGEX REPLACE " -o .* -c " " -E " preprocess "${command}")
  execute_process(
    COMMAND "${SHELL}" -c "${preprocess} | awk '/^#/ { if (/[/]Eigen[/]/) eigen = 1; next } NF { ++n } END { print n \" \" (eigen ? \"yes\" : \"no\") }'"
    WORKING_DIRECTORY "${directory}" OUTPUT_VARIABLE words OUTPUT_STRIP_TRAILING_WHITESPACE)
  separate_arguments(words)
  list(GET words 0 lines)
  list(GET words 1 includes)
endif()

file(WRITE "${OUT}" "${CHAPTER}\t${eigen}\t${includes}\t${kilobytes}\t${lines}\n")
