#!/bin/sh
# Runs a program of Windows: wine.sh program. Wine keeps what it calls a drive in the folder TIMESTEP_WINE, or in one beside
# the program.
folder=$(cd "$(dirname "$1")" && pwd) || exit
WINEPREFIX=${TIMESTEP_WINE:-$folder/wine} WINEDEBUG=-all exec wine "$@"
