# For Windows, from Linux: mingw's g++ compiles (Debian's package g++-mingw-w64-x86-64-posix) and wine runs what it makes.
# The preset `windows` reads this file.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)  # a program is one file
get_property(trying GLOBAL PROPERTY IN_TRY_COMPILE)
if(trying)
  return()
endif()

# One drive of wine for the whole build: it has hundreds of megabytes.
set(drive "${CMAKE_BINARY_DIR}/wine")
if(DEFINED ENV{TIMESTEP_WINE})
  set(drive "$ENV{TIMESTEP_WINE}")
endif()
set(CMAKE_CROSSCOMPILING_EMULATOR "${CMAKE_COMMAND}" -E env "TIMESTEP_WINE=${drive}"
  "${CMAKE_CURRENT_LIST_DIR}/../../tests/same_bits/wine.sh")

# Libraries that are headers alone are the same for every system. They are read from a folder that has nothing else:
# beside them, in /usr/include, stand the C headers of this system.
set(shared "${CMAKE_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${shared}/include" "${shared}/share/cmake")
foreach(place IN ITEMS /usr /usr/local)
  file(GLOB found "${place}/include/eigen3" "${place}/include/CLI" "${place}/include/nlohmann" "${place}/include/boost"
    "${place}/share/eigen3" "${place}/share/cmake/CLI11*" "${place}/share/cmake/nlohmann_json*" "${place}/lib/cmake/CLI11*")
  foreach(folder IN LISTS found)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${place}" OUTPUT_VARIABLE name)
    string(REGEX REPLACE "^lib/" "share/" name "${name}")
    file(CREATE_LINK "${folder}" "${shared}/${name}" SYMBOLIC)
  endforeach()
endforeach()
set(CMAKE_FIND_ROOT_PATH "${shared}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
