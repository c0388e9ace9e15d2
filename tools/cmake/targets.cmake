# The names of all that can be built, one a line, for ./course new: no chapter and no exercise may make one of them
# a second time. To be called at the end.
function(timestep_targets_below folder result)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  get_property(folders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    timestep_targets_below("${inner}" more)
    list(APPEND targets ${more})
  endforeach()
  set(${result} ${targets} PARENT_SCOPE)
endfunction()

function(timestep_list_targets)
  timestep_targets_below("${PROJECT_SOURCE_DIR}" targets)
  list(SORT targets)
  list(JOIN targets "\n" lines)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/targets.txt" CONTENT "@lines@\n" @ONLY)
endfunction()
