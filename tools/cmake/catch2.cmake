find_package(Catch2 3 QUIET)
if(Catch2_FOUND)
  list(APPEND CMAKE_MODULE_PATH "${Catch2_DIR}")
endif()
