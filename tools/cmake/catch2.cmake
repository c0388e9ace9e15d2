# Catch2 3: the distribution's where it has one, else this very version, held to its hash.
find_package(Catch2 3 QUIET)
if(Catch2_FOUND)
  list(APPEND CMAKE_MODULE_PATH "${Catch2_DIR}")
else()
  include(FetchContent)
  message(STATUS "Catch2 3 not found: fetching version 3.7.1")
  FetchContent_Declare(Catch2
    URL https://github.com/catchorg/Catch2/archive/refs/tags/v3.7.1.tar.gz
        https://deb.debian.org/debian/pool/main/c/catch2/catch2_3.7.1.orig.tar.gz  # Debian's source package: the same file
    URL_HASH SHA256=c991b247a1a0d7bb9c39aa35faf0fe9e19764213f28ffba3109388e62ee0269c
    DOWNLOAD_EXTRACT_TIMESTAMP ON)
  FetchContent_MakeAvailable(Catch2)
  list(APPEND CMAKE_MODULE_PATH "${catch2_SOURCE_DIR}/extras")
endif()
