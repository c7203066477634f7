#!/usr/bin/env bash
# A grid that was saved gives the same picture when loaded, to the byte, and another interpolation finds its gradients.
#   save_and_load.sh <program> <arguments of the lights and the grid>...
set -eu
program="$1"
shift
render() { "$program" --quiet --scene box.obj --size 16x12 "$@"; }
render "$@" --interpolation trilinear --save-grid x.grid --out a.exr
render --load-grid x.grid --interpolation trilinear --out b.exr
cmp a.exr b.exr
render "$@" --out a.exr
render --load-grid x.grid --out b.exr
cmp a.exr b.exr
