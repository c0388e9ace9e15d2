# A run that cannot be written to its end leaves what was there before: nothing, or an older
# result, whole; what is in the folder and not the run's own stays. A full disk is played by the
# shell's limit on the size of files, by /dev/full, and by a folder where a file should go.
#
# All of this is the doing of tools/lab, one for all programs: the sources in ROOM must open no
# file. So every program runs as the page has it, and once into an older result on a full disk; the
# other ways to fail are tried on the programs for which EVERY_WAY is set.
include("${CMAKE_CURRENT_LIST_DIR}/program.cmake")

file(GLOB sources "${ROOM}/*.?pp")
if(NOT sources)
  wrong("${ROOM}: no sources found")
endif()
foreach(source IN LISTS sources)
  file(STRINGS "${source}" opens REGEX "fstream|fopen|<filesystem>|<fcntl.h>|<unistd.h>")
  if(opens)
    wrong("${source}: opens files itself, past tools/lab: ${opens}")
  endif()
endforeach()

# Whole numbers count steps, bodies or frames: with the least of each, runs are short.
read_options()
set(quick "")
foreach(flag IN LISTS flags)
  if(rule_${flag} MATCHES "^a whole number from (-?[0-9]+) ")
    list(APPEND quick ${flag} ${CMAKE_MATCH_1})
  endif()
endforeach()

# Every file below WORK/folder with the hash of what is in it.
function(contents folder result)
  set(files "")
  if(EXISTS "${WORK}/${folder}")
    file(GLOB_RECURSE files LIST_DIRECTORIES true RELATIVE "${WORK}"
         "${WORK}/${folder}/*" "${WORK}/${folder}/.*")
    list(APPEND files "${folder}")
  endif()
  set(list "")
  foreach(file IN LISTS files)
    set(hash folder)
    if(NOT IS_DIRECTORY "${WORK}/${file}")
      file(SHA256 "${WORK}/${file}" hash)
    endif()
    list(APPEND list "${file} ${hash}")
  endforeach()
  set(${result} "${list}" PARENT_SCOPE)
endfunction()

function(must_be folder expected what)
  contents(${folder} now)
  if(NOT now STREQUAL "${expected}")
    wrong("${what}: the folder has changed from\n    ${expected}\n  to\n    ${now}")
  endif()
endfunction()

# The run of the page: no options. It must hold, be quiet, and find nothing but numbers.
run_program(--out older)
if(NOT status EQUAL 0 OR NOT err STREQUAL "")
  wrong("--out older: the exit status is ${status}, must be 0; standard error: ${err}")
endif()
if(NOT IS_DIRECTORY "${WORK}/older")
  report()
endif()
file(GLOB tables RELATIVE "${WORK}/older" "${WORK}/older/*.tsv")
foreach(needed numbers.tsv checks.tsv)
  if(NOT needed IN_LIST tables)
    wrong("--out older: ${needed} is missing")
  endif()
endforeach()
foreach(table IN LISTS tables)
  file(READ "${WORK}/older/${table}" text)
  if(text MATCHES "\t-?(nan|inf)[\t\n]" OR NOT text MATCHES "\n$")
    wrong("older/${table}: holds a NaN or an infinity, or does not end with a whole line")
  endif()
endforeach()
contents(older older)

set(no_space "trap '' XFSZ && ulimit -f 0 &&")
if(NOT CMAKE_HOST_WIN32)
  # No file may grow beyond nothing: the first write of data fails.
  run_limited("${no_space}" /dev/null ${quick} --out older)
  must_refuse("a full disk" "cannot be written (is the disk full?)")
  must_be(older "${older}" "a full disk")
endif()
if(EXISTS /dev/full)
  run_limited("" /dev/full --help)
  must_refuse("--help >/dev/full" "standard output: cannot be written")
endif()
if(NOT EVERY_WAY)
  report()
  return()
endif()

if(EXISTS /dev/full)
  run_limited("" /dev/full ${quick} --out older)
  must_refuse("the output to a full disk" "standard output: cannot be written")
  must_be(older "${older}" "the output to a full disk")
endif()
if(NOT CMAKE_HOST_WIN32)
  run_limited("" "&-" --help)
  must_refuse("--help with standard output closed" "standard output: cannot be written")
endif()

if(NOT CMAKE_HOST_WIN32)
  run_limited("${no_space}" /dev/null ${quick} --out new/folder)
  must_refuse("a full disk" "cannot be written (is the disk full?)")
  must_be(new "" "a full disk and a new folder")

  # Without the trap the system kills the program as it writes.
  run_limited("ulimit -f 0 &&" /dev/null ${quick} --out older)
  if(status MATCHES "^[0-9]+$" AND status LESS 3)
    wrong("killed as it writes: the exit status is ${status}, the test did not kill it")
  endif()
  file(GLOB left "${WORK}/older/.unfinished_*")
  if(left)
    file(REMOVE_RECURSE ${left})
  endif()
  must_be(older "${older}" "killed as it writes")

  # A place that is not for us to write to.
  run_program(${quick} --out /proc/self/timestep)
  must_refuse("--out /proc/self/timestep" "/proc/self/timestep: the folder cannot be made")
endif()

# A folder sits where the last of the files should go.
list(GET tables -1 last)
foreach(blocked numbers.tsv checks.tsv ${last})
  file(REMOVE_RECURSE "${WORK}/blocked")
  file(COPY "${WORK}/older/" DESTINATION "${WORK}/blocked")
  file(REMOVE "${WORK}/blocked/${blocked}")
  file(MAKE_DIRECTORY "${WORK}/blocked/${blocked}")
  contents(blocked before)
  run_program(${quick} --out blocked)
  must_refuse("a folder named ${blocked}" "blocked/${blocked}: must be a file, not a folder")
  must_be(blocked "${before}" "a folder named ${blocked}")
endforeach()

# What is in the folder already stays, whatever its name.
file(WRITE "${WORK}/older/.unfinished/mine" "mine")
run_program(${quick} --out older)
if(NOT status EQUAL 0)
  wrong("a folder named .unfinished: the exit status is ${status}, must be 0: ${err}")
endif()
if(NOT EXISTS "${WORK}/older/.unfinished/mine")
  wrong("a folder named .unfinished: the run has deleted it")
endif()
file(GLOB left "${WORK}/older/.unfinished_*")
if(left)
  wrong("a run into a folder with files has left ${left}")
endif()

# Several runs into one folder at once do not trouble each other.
if(NOT CMAKE_HOST_WIN32)
  set(at_once "for i in 1 2 3 4 5 6; do \"$@\" >/dev/null & all=\"$all $!\"; done")
  execute_process(COMMAND sh -c "${a_minute} ${at_once}; for one in $all; do wait $one || exit; done"
    sh "${PROGRAM}" ${quick} --out together WORKING_DIRECTORY "${WORK}" TIMEOUT ${patience}
    RESULT_VARIABLE status ERROR_VARIABLE err)
  file(GLOB left "${WORK}/together/.*")
  if(NOT status EQUAL 0 OR left)
    wrong("runs into one folder at once: exit status ${status}, left \"${left}\": ${err}")
  endif()
endif()

report()
