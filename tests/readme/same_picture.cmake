# Runs chapter 3 and holds its portraits.svg to the committed picture, byte for byte. Another gnuplot
# writes other bytes for the same curves: then there is nothing to compare.
cmake_minimum_required(VERSION 3.25)
include("${RUN}")
file(READ "${OUT}/portraits.svg" drawn)
file(READ "${COMMITTED}" committed)
string(REGEX MATCH "GNUPLOT [0-9.]+ patchlevel [0-9a-z]+" by_now "${drawn}")
string(REGEX MATCH "GNUPLOT [0-9.]+ patchlevel [0-9a-z]+" by_then "${committed}")
if(NOT by_now STREQUAL by_then)
  message(NOTICE "not compared: the committed picture was drawn by another gnuplot, ${by_then}")
elseif(NOT drawn STREQUAL committed)
  message(FATAL_ERROR "docs/three_eulers.svg is not what chapter 3 draws now. To renew it: copy "
                      "chapters/03_euler_variants/run/portraits.svg from the build folder over it.")
endif()
