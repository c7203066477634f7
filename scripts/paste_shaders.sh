#!/usr/bin/env bash
# Writes anew the functions that are pasted into docs/examples/irradiance.frag and docs/shaders.md, when a kernel changes:
# scripts/paste_shaders.sh <zonal-glsl>
set -eu
program="$(realpath "$1")"
cd "$(dirname "$0")/.."
functions="$(mktemp)"
trap 'rm -f "$functions"' EXIT
"$program" --bands 3 --functions reconstruct_lambert_colour --dialect glsles300 >"$functions"
for file in docs/examples/irradiance.frag docs/shaders.md; do
  awk -v functions="$functions" '
    /^\/\/ zonal [0-9].*GLSL ES/ { while ((getline line <functions) > 0) print line; skips = 1 }
    !skips { print }
    /^#endif/ { skips = 0 }' "$file" >"$file.new"
  mv "$file.new" "$file"
done
