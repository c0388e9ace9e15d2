# Compiles a source that must not compile, and writes the command and what the compiler says into
# `folder`: the error, and the place in the source that led to it. Everything is called by its path
# from ROOT, so no path of this machine is in the words. Sets `problem` to a sentence, or to nothing.
function(compile_misuse source folder problem)
  set(${problem} "" PARENT_SCOPE)
  set(command -std=c++20 -fsyntax-only -Iinclude "${source}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env LC_ALL=C.UTF-8 "${COMPILER}" ${command}
    WORKING_DIRECTORY "${ROOT}" RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
  string(REGEX MATCH "[^\n]*: error: timestep: [^\n]*|[^\n]*: error: static[^\n]*timestep: [^\n]*"
         error "${words}")
  if(status EQUAL 0)
    set(${problem} "${source}: compiles, and must not" PARENT_SCOPE)
    return()
  elseif(NOT error)
    set(${problem} "${source}: does not compile, but for another reason:\n${words}" PARENT_SCOPE)
    return()
  endif()
  # g++ names the line of the source before the error, clang++ after it.
  get_filename_component(file "${source}" NAME)
  string(REGEX MATCH "[^\n]*${file}:[0-9:]+ [^\n]*(required from|requested here)[^\n]*" place "${words}")
  string(FIND "${words}" "${error}" error_at)
  string(FIND "${words}" "${place}" place_at)
  if(place_at LESS error_at)
    set(said "${place}\n${error}")
  else()
    set(said "${error}\n${place}")
  endif()
  get_filename_component(name "${COMPILER}" NAME)
  list(JOIN command " " options)
  get_filename_component(stem "${source}" NAME_WE)
  file(WRITE "${folder}/${stem}.txt" "$ ${name} ${options}\n${said}\n")
endfunction()
