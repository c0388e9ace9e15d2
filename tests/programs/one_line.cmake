# A chapter's program does what its first lines say: compiled and run by the line that stands there, word for word apart
# from the compiler's name, it prints its output and leaves one file of data. Where it cannot write, it says so in one
# line, with exit status 2. Called with ROOT, CHAPTER, NAME, COMPILER, EIGEN, WORK.
cmake_minimum_required(VERSION 3.25)

set(program "chapters/${CHAPTER}/${NAME}.cpp")
function(wrong text)
  message(SEND_ERROR "${program}: ${text}")
endfunction()

file(READ "${ROOT}/${program}" source)
if(NOT source MATCHES "^// Chapter [0-9]+: [^\n]+\n//\n//   c[+][+] (-std=[^\n]+)\n")
  wrong("must begin with what it is, and with the line that compiles it")
  return()
endif()
set(line "${COMPILER} ${CMAKE_MATCH_1}")
string(REPLACE "/usr/include/eigen3" "${EIGEN}" line "${line}")  # another machine has it elsewhere

# The checkout is only read: links lead to its programs and the library.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
file(CREATE_LINK "${ROOT}/include" "${WORK}/include" SYMBOLIC)
file(CREATE_LINK "${ROOT}/chapters" "${WORK}/chapters" SYMBOLIC)
execute_process(COMMAND sh -c "${line}" WORKING_DIRECTORY "${WORK}"
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT status EQUAL 0 OR out STREQUAL "" OR NOT err STREQUAL "")
  wrong("${line}\nexits with ${status} and says\n${out}${err}")
  return()
endif()
file(GLOB data "${WORK}/*.dat")
list(LENGTH data count)
if(NOT count EQUAL 1)
  wrong("leaves ${count} files of data (${data}), must leave one")
  return()
endif()

# A folder of that name is in the way, as a full disk would be.
file(REMOVE "${data}")
file(MAKE_DIRECTORY "${data}")
string(REGEX MATCH "&& ([^ ]+)$" run "${line}")
execute_process(COMMAND "${CMAKE_MATCH_1}" WORKING_DIRECTORY "${WORK}"
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE err)
get_filename_component(name "${data}" NAME)
if(NOT status EQUAL 2 OR NOT err STREQUAL "${name}: cannot be written\n")
  wrong("where ${name} cannot be written, it exits with ${status} and says \"${err}\"")
endif()
