# Live panels: each chapters/NN_name/live/panel.cpp becomes a program (its steps are tested, and it draws the still
# picture) and, where there is a compiler for it, a module of WebAssembly. Both are left in
# ${build}/chapters/NN_name/live.

# Clang, its linker, and a C and C++ library for WebAssembly: asked for by compiling something, whenever CMake runs.
find_program(WASM_CXX NAMES clang++ clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14)
set(wasm_options --target=wasm32-wasi -mexec-model=reactor -std=c++20)
set(TIMESTEP_WASM OFF)
if(WASM_CXX)
  set(probe "${PROJECT_BINARY_DIR}/live_probe")
  file(WRITE "${probe}.cpp" "#include <cmath>\n#include <string>\nstd::string s;\nextern \"C\" double f(double x) { s += 'x'; return std::sin(x); }\n")
  execute_process(COMMAND "${WASM_CXX}" ${wasm_options} "${probe}.cpp" -o "${probe}.wasm"
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    set(TIMESTEP_WASM ON)
  endif()
endif()
if(NOT TIMESTEP_WASM)
  message(STATUS "No compiler for WebAssembly: the panels stand still (packages clang, lld, wasi-libc, "
                 "libc++-…-dev-wasm32, libclang-rt-…-dev-wasm32)")
endif()

# Declares the panels of a chapter; `needs` is what its about.json says. Their files are appended to the global
# property TIMESTEP_LIVE_${chapter}, and to TIMESTEP_LIVE.
function(timestep_live chapter needs)
  file(GLOB panels CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/chapters/${chapter}/live/*.cpp")
  # What their lines `// still:` say is read here.
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${panels})
  set(folder "${PROJECT_BINARY_DIR}/chapters/${chapter}/live")
  foreach(panel IN LISTS panels)
    cmake_path(GET panel STEM name)
    if(NOT name MATCHES "^[a-z][a-z0-9_]*$")
      message(FATAL_ERROR "chapters/${chapter}/live/${name}.cpp: a panel's name has small letters, digits and _")
    endif()
    set(native live_${name})
    add_executable(${native} EXCLUDE_FROM_ALL "${panel}")
    target_include_directories(${native} PRIVATE "${PROJECT_SOURCE_DIR}/tools/live")
    set(includes "-I${PROJECT_SOURCE_DIR}/include" "-I${PROJECT_SOURCE_DIR}/tools/live")
    set(library timestep_headers)
    if("eigen" IN_LIST needs)
      set(library timestep)
      list(APPEND includes -isystem "$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>")
    endif()
    target_link_libraries(${native} PRIVATE ${library} timestep_warnings)
    # The same bits as in the page: no sum in another order, and nothing contracted.
    set(same_bits -DEIGEN_DONT_VECTORIZE)
    if(NOT MSVC)
      list(APPEND same_bits -ffp-contract=off)
    endif()
    target_compile_options(${native} PRIVATE ${same_bits} $<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-O1>)

    # A module that the library refuses something stops. To throw, and to put words together, would be a third of it.
    set(small -fno-exceptions -fno-rtti "-DTIMESTEP_REFUSED(line)=__builtin_trap()" -DTIMESTEP_REFUSED_BRIEFLY)

    set(still "${folder}/${name}.svg")
    file(STRINGS "${panel}" words REGEX "^// still: ")
    string(REGEX REPLACE "^// still: " "" words "${words}")
    separate_arguments(words UNIX_COMMAND "${words}")
    add_custom_command(OUTPUT "${still}"
      COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
      COMMAND ${native} ${words} --still "${still}" > "${folder}/${name}.txt"
      DEPENDS ${native} COMMENT "Drawing the panel ${name}" VERBATIM)
    set(made "${still}")
    if(TIMESTEP_WASM)
      add_custom_command(OUTPUT "${folder}/${name}.wasm"
        COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
        COMMAND "${WASM_CXX}" ${wasm_options} -O2 ${same_bits} ${small} ${includes} -MD -MF "${folder}/${name}.d"
                -MT "${folder}/${name}.wasm" "${panel}" -o "${folder}/${name}.wasm" -Wl,--strip-all
        DEPENDS "${panel}" DEPFILE "${folder}/${name}.d"
        COMMENT "Compiling the panel ${name} for the page" VERBATIM)
      list(APPEND made "${folder}/${name}.wasm")
    else()  # one that was made before would stay as it is, whatever becomes of the panel
      file(REMOVE "${folder}/${name}.wasm")
    endif()
    set_property(GLOBAL APPEND PROPERTY TIMESTEP_LIVE_${chapter} ${made})
    set_property(GLOBAL APPEND PROPERTY TIMESTEP_LIVE ${made})
    set_property(GLOBAL APPEND PROPERTY TIMESTEP_LIVE_PROGRAMS ${native})
  endforeach()
  get_property(all GLOBAL PROPERTY TIMESTEP_LIVE_${chapter})
  if(all)
    add_custom_target(live_of_${chapter} DEPENDS ${all})
  endif()
endfunction()
