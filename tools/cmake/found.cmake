# What CMake has found stays in its cache, also when it is gone from the machine, and so does what it has tried in vain,
# also when that would go well now. Here both are forgotten, to be looked for again. That something is gone makes CMake
# configure again, instead of a build that fails in Ninja's words.
function(timestep_for_all_found do)
  get_cmake_property(names CACHE_VARIABLES)
  foreach(name IN LISTS names)
    get_property(type CACHE ${name} PROPERTY TYPE)
    get_property(help CACHE ${name} PROPERTY HELPSTRING)
    set(path "$CACHE{${name}}")
    # What find_program and its like have found; not what somebody has said.
    if(type MATCHES "^(FILEPATH|PATH)$" AND help MATCHES "^Path to a (program|file|library)[.]" AND IS_ABSOLUTE "${path}")
      cmake_language(CALL ${do} ${name} "${path}")
    endif()
  endforeach()
endfunction()

function(timestep_forget_gone)
  function(forget name path)
    if(NOT EXISTS "${path}")
      message(STATUS "${path} is gone; looking for another")
      unset(${name} CACHE)
    endif()
  endfunction()
  timestep_for_all_found(forget)
  # CMake looks again by itself for what it has not found, but does not try again what has failed.
  get_cmake_property(names CACHE_VARIABLES)
  foreach(name IN LISTS names)
    get_property(help CACHE ${name} PROPERTY HELPSTRING)
    if(name MATCHES "^TIMESTEP_" AND help STREQUAL "Test ${name}" AND "$CACHE{${name}}" STREQUAL "")
      unset(${name} CACHE)
    endif()
  endforeach()
endfunction()

# To be called at the end.
function(timestep_watch_found)
  function(watch name path)
    if(NOT IS_DIRECTORY "${path}")
      set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    endif()
  endfunction()
  timestep_for_all_found(watch)
endfunction()
