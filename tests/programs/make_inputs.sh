#!/usr/bin/env bash
# What the cases of cases.cmake start from: the scenes, and pictures that the program itself writes.
#   make_inputs.sh <program> <scenes> <folder> <argument that asks for few lights>...
set -eu
program="$1" scenes="$2" folder="$3"
shift 3
rm -rf "$folder"
mkdir -p "$(dirname "$folder")"
cp -r "$scenes" "$folder"
cd "$folder"
mkdir folder.obj folder.png
mkfifo pipe
echo "no material" >scenes.binary
"$program" --quiet --scene box.obj "$@" --size 16x12 --out reference.exr
"$program" --quiet --scene box.obj "$@" --size 12x16 --out other_size.exr
"$program" --quiet --scene box.obj "$@" --size 17x12 --out odd.exr
head -c 600 reference.exr >truncated.exr
"$program" --quiet --scene box.obj "$@" --size 16x12 --exposure -30 --out black.png
[ "$(basename "$program")" != grid-render ] && exit
grid() { "$program" --quiet --lights 4 --grid 3 --size 16x12 --out grid.png "$@"; }
grid --scene box.obj --save-grid box.grid
grid --scene triangle.obj --save-grid triangle.grid
head -c 2000 box.grid >truncated.grid
