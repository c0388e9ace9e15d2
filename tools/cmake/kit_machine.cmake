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

function(timestep_machine_words machine result)
  foreach(key system processor compiler compiler_version glibc libstdcxx)
    string(JSON ${key} ERROR_VARIABLE error GET "${machine}" ${key})
    if(error)
      set(${key} "?")
    endif()
    set(${key} "${${key}}" PARENT_SCOPE)
  endforeach()
  set(${result} "${system} on ${processor}, ${compiler} ${compiler_version}, glibc ${glibc}, libstdc++ ${libstdcxx}"
      PARENT_SCOPE)
endfunction()

# Stops where what was built on the machine of `file` does not fit this one: another system, processor
# or compiler (its first number), or older libraries.
function(timestep_require_machine file)
  file(READ "${file}" there)
  timestep_machine(here)
  timestep_machine_words("${there}" made_on)
  foreach(key system processor compiler compiler_version glibc libstdcxx)
    set(made_${key} "${${key}}")
  endforeach()
  timestep_machine_words("${here}" this_is)
  string(REGEX MATCH "^[0-9]+" made_major "${made_compiler_version}")
  string(REGEX MATCH "^[0-9]+" major "${compiler_version}")
  if(system STREQUAL made_system AND processor STREQUAL made_processor AND compiler STREQUAL made_compiler
     AND major STREQUAL made_major AND NOT glibc VERSION_LESS made_glibc
     AND NOT libstdcxx VERSION_LESS made_libstdcxx)
    return()
  endif()
  # CMake breaks the lines of its errors; ./course shows this one alone.
  message(NOTICE "course: this learner's edition was made for ${made_on}; here is ${this_is}: "
                 "ask whoever gave it to you for one made on a machine like yours")
  message(FATAL_ERROR "The learner's edition does not fit this machine.")
endfunction()
