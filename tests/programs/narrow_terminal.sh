#!/usr/bin/env bash
# In a terminal of 20 columns, progress must be shown and must not wrap:
#   narrow_terminal.sh <folder> <command>...
set -eu
command -v script >/dev/null || { echo "skipped: no program 'script' to make a terminal"; exit 0; }
script -qec true /dev/null >/dev/null 2>&1 </dev/null || { echo "skipped: no pseudo-terminal can be opened here"; exit 0; }
folder="$1"
shift
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
script -qec "stty cols 20; ${*@Q}" typescript >/dev/null </dev/null
# What is drawn between two returns to the first column, without the codes that clear the rest of the line.
drawn="$(tr '\r' '\n' <typescript | sed 's/\x1b\[K//g' | grep '%')"
echo "$drawn"
[ "$(echo "$drawn" | wc -l)" -ge 2 ]
[ "$(echo "$drawn" | awk '{ print length }' | sort -n | tail -1)" -lt 20 ]
rm -rf "$folder"
