#!/bin/sh
# Runs a program of Windows: wine.sh program. Wine keeps what it calls a drive in a folder of its own, beside the program.
folder=$(cd "$(dirname "$1")" && pwd) || exit
WINEPREFIX=$folder/wine WINEDEBUG=-all exec wine "$@"
