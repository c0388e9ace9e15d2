# The kind of machine that this is, as far as what is built here must fit where it is used.

# As JSON. The versions of the system's libraries are the compiler's word, by its macros.
function(timestep_machine result)
  set(probe "${PROJECT_BINARY_DIR}/CMakeFiles/kit_machine.cpp")
  file(WRITE "${probe}" "#include <cstdlib>\n")
  execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -E -dM "${probe}" OUTPUT_VARIABLE macros ERROR_QUIET)
  foreach(macro __GLIBC__ __GLIBC_MINOR__ __GLIBCXX__)
    set(${macro} 0)
    if(macros MATCHES "#define ${macro} ([0-9]+)")
      set(${macro} ${CMAKE_MATCH_1})
    endif()
  endforeach()
  set(${result} "{
  \"system\": \"${CMAKE_SYSTEM_NAME}\",
  \"processor\": \"${CMAKE_SYSTEM_PROCESSOR}\",
  \"compiler\": \"${CMAKE_CXX_COMPILER_ID}\",
  \"compiler_version\": \"${CMAKE_CXX_COMPILER_VERSION}\",
  \"glibc\": \"${__GLIBC__}.${__GLIBC_MINOR__}\",
  \"libstdcxx\": \"${__GLIBCXX__}\"
}" PARENT_SCOPE)
endfunction()

# Stops where what was built on the machine of `file` does not fit this one: another system, processor
# or compiler (its first number), or older libraries.
function(timestep_require_machine file)
  file(READ "${file}" there)
  timestep_machine(here)
  foreach(side there here)
    foreach(key system processor compiler compiler_version glibc libstdcxx)
      string(JSON ${side}_${key} ERROR_VARIABLE error GET "${${side}}" ${key})
      if(error)
        set(${side}_${key} "?")
      endif()
    endforeach()
    string(REGEX MATCH "^[0-9]+" ${side}_major "${${side}_compiler_version}")
    set(${side} "${${side}_system} on ${${side}_processor}, ${${side}_compiler} ${${side}_compiler_version}, \
glibc ${${side}_glibc}, libstdc++ ${${side}_libstdcxx}")
  endforeach()
  if("${here_system};${here_processor};${here_compiler};${here_major}"
       STREQUAL "${there_system};${there_processor};${there_compiler};${there_major}"
     AND NOT here_glibc VERSION_LESS there_glibc AND NOT here_libstdcxx VERSION_LESS there_libstdcxx)
    return()
  endif()
  # CMake breaks the lines of its errors; ./course shows this one alone.
  message(NOTICE "course: this learner's edition was made for ${there}; here is ${here}: "
                 "ask whoever gave it to you for one made on a machine like yours")
  message(FATAL_ERROR "The learner's edition does not fit this machine.")
endfunction()
