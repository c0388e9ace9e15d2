# What each chapter's program costs to make, as a table:
#   cmake -DCHAPTERS=03_…;… -DPROGRAMS=binary;… -DROOT=course -DCOMMANDS=compile_commands.json -DRUN=folder -P …
cmake_minimum_required(VERSION 3.25)

set(commands "[]")
if(EXISTS "${COMMANDS}")  # the build's own commands, where it has left them
  file(READ "${COMMANDS}" commands)
endif()
string(JSON count LENGTH "${commands}")
find_program(SHELL sh)

# Sets `lines` that the compiler reads of the source, and whether Eigen `includes` are among them.
function(preprocess source)
  set(lines "–" PARENT_SCOPE)
  set(includes "–" PARENT_SCOPE)
  foreach(i RANGE ${count})
    string(JSON file ERROR_VARIABLE none GET "${commands}" ${i} file)
    if(file STREQUAL source AND SHELL)
      string(JSON command GET "${commands}" ${i} command)
      string(JSON directory GET "${commands}" ${i} directory)
      string(REGEX REPLACE " -o .* -c " " -E " command "${command}")
      execute_process(
        COMMAND "${SHELL}" -c "${command} | awk '/^#/ { if (/[/]Eigen[/]/) eigen = 1; next } NF { ++n } END { print n \";\" (eigen ? \"yes\" : \"no\") }'"
        WORKING_DIRECTORY "${directory}" OUTPUT_VARIABLE words OUTPUT_STRIP_TRAILING_WHITESPACE)
      list(GET words 0 read)
      list(GET words 1 eigen)
      set(lines ${read} PARENT_SCOPE)
      set(includes ${eigen} PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

set(table "chapter\tits study needs Eigen\tits program does\tbinary (KB)\tlines that the compiler reads\n")
foreach(chapter program IN ZIP_LISTS CHAPTERS PROGRAMS)
  string(REGEX REPLACE "^[0-9]+_" "" name "${chapter}")
  file(READ "${ROOT}/chapters/${chapter}/about.json" about)
  string(JSON needs ERROR_VARIABLE none GET "${about}" needs)
  set(eigen "no")
  if(needs MATCHES "eigen")
    set(eigen "yes")
  endif()
  file(SIZE "${program}" bytes)
  math(EXPR kilobytes "(${bytes} + 500) / 1000")
  preprocess("${ROOT}/chapters/${chapter}/${name}.cpp")
  string(APPEND table "${chapter}\t${eigen}\t${includes}\t${kilobytes}\t${lines}\n")
endforeach()
file(WRITE "${RUN}/programs.tsv" "${table}")
file(WRITE "${RUN}/places.tsv"  # for ./course where
  "name\tkind\tplace\nprograms.tsv\tdata\ttools/cmake/program_cost.cmake:${CMAKE_CURRENT_LIST_LINE}\n")
file(TOUCH "${RUN}/done")
