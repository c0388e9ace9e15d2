# The library: headers only. Two targets, so that a scene with one degree of freedom need not have
# Eigen:
#   timestep::headers   the include path, nothing else
#   timestep::timestep  the same and Eigen, for vectors and rigid bodies
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Inside somebody else's project nothing is installed unless they ask for it, and who needs no vectors needs no Eigen.
option(TIMESTEP_INSTALL "Install the library with the project" ${PROJECT_IS_TOP_LEVEL})
if(PROJECT_IS_TOP_LEVEL)
  find_package(Eigen3 3.4 REQUIRED NO_MODULE)
elseif(NOT TARGET Eigen3::Eigen)
  find_package(Eigen3 3.4 QUIET NO_MODULE)
endif()

add_library(timestep_headers INTERFACE)
add_library(timestep::headers ALIAS timestep_headers)
set_target_properties(timestep_headers PROPERTIES EXPORT_NAME headers)
target_compile_features(timestep_headers INTERFACE cxx_std_20)
target_include_directories(timestep_headers INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

# Plain IEEE arithmetic: clang, and g++ where the processor has it, contract a product and a sum to one operation
# otherwise, and a run ends on other bits than elsewhere. (MSVC does not, with /fp:precise, its default, from Visual
# Studio 2022 on; an older one needs /fp:strict from its user.)
target_compile_options(timestep_headers INTERFACE
  $<$<AND:$<COMPILE_LANGUAGE:C,CXX>,$<NOT:$<CXX_COMPILER_ID:MSVC>>>:-ffp-contract=off>)

add_library(timestep INTERFACE)
add_library(timestep::timestep ALIAS timestep)
target_link_libraries(timestep INTERFACE timestep_headers Eigen3::Eigen)  # an error where it is used and Eigen is not there

if(NOT TIMESTEP_INSTALL)
  return()
endif()
install(TARGETS timestep timestep_headers EXPORT timestep_targets)
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/timestep)
set(package_folder ${CMAKE_INSTALL_DATADIR}/cmake/timestep)
install(EXPORT timestep_targets NAMESPACE timestep:: DESTINATION ${package_folder})
file(WRITE ${PROJECT_BINARY_DIR}/timestep-config.cmake
"# timestep::headers does without Eigen; timestep::timestep needs it.
find_package(Eigen3 3.4 QUIET NO_MODULE)
include(\${CMAKE_CURRENT_LIST_DIR}/timestep_targets.cmake)
")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/timestep-config-version.cmake
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/timestep-config.cmake
  ${PROJECT_BINARY_DIR}/timestep-config-version.cmake DESTINATION ${package_folder})
