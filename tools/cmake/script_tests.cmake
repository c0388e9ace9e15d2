# Every function test_… of a shell script in the current folder is a test. It is called as
#   sh SCRIPT FUNCTION FOLDER SOURCE …
# and is skipped where it ends with 77. Those in a script that TIMESTEP_LONG_SCRIPTS names are for
# `./course test --all`.
set(TIMESTEP_LONG_SCRIPTS bench.sh kit.sh)
function(timestep_script_tests script label)
  file(STRINGS ${script} lines REGEX "^test_[a-z0-9_]+\\(\\)")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script})
  foreach(line IN LISTS lines)
    string(REGEX MATCH "^test_[a-z0-9_]+" function "${line}")
    string(REGEX REPLACE "^test_" "" words "${function}")
    string(REPLACE "_" " " words "${words}")
    add_test(NAME "${label} ${words}"
      COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${function}
              "${CMAKE_CURRENT_BINARY_DIR}/${function}" "${PROJECT_SOURCE_DIR}" ${ARGN})
    set_tests_properties("${label} ${words}" PROPERTIES SKIP_RETURN_CODE 77)
    if(script IN_LIST TIMESTEP_LONG_SCRIPTS)
      set_tests_properties("${label} ${words}" PROPERTIES LABELS long)
    endif()
  endforeach()
endfunction()
