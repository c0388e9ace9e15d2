# The learner's edition: the hidden tests come built, in kit/, and the site is ready, in site/.
include(checking)
include(kit_machine)
set(kit "${PROJECT_SOURCE_DIR}/kit")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${kit}/kit.json")
timestep_require_machine("${kit}/kit.json")

add_library(timestep_worker STATIC IMPORTED)
set_target_properties(timestep_worker PROPERTIES IMPORTED_LOCATION "${kit}/libtimestep_worker.a")
file(GLOB workers "${kit}/workers/*")
foreach(worker IN LISTS workers)
  cmake_path(GET worker FILENAME name)
  string(REGEX REPLACE "_worker[.].*" "" name "${name}")
  add_library(worker_${name} OBJECT IMPORTED)
  set_target_properties(worker_${name} PROPERTIES IMPORTED_OBJECTS "${worker}")
  add_executable(hidden_${name} IMPORTED)  # one program for all
  set_target_properties(hidden_${name} PROPERTIES IMPORTED_LOCATION "${kit}/check")
endforeach()

# Where the course program looks for the stubs and the compiler for the declarations.
file(GLOB generated RELATIVE "${kit}" "${kit}/generated/*")
foreach(file IN LISTS generated)
  configure_file("${kit}/${file}" "${PROJECT_BINARY_DIR}/exercises/${file}" COPYONLY)
endforeach()
timestep_check_learners("${kit}/about")

# Every chapter runs and draws; there is no site to make.
get_property(runs GLOBAL PROPERTY TIMESTEP_RUNS)
add_custom_target(figures DEPENDS ${runs})
add_custom_target(docs DEPENDS figures)
