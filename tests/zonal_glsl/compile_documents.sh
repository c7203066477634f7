#!/usr/bin/env bash
# Compiles the shaders of docs/examples as they stand, by the commands that they name:
# compile_documents.sh <zonal-glsl> <docs/examples> <folder>
set -eu
program="$1" examples="$2" folder="$3"
mkdir -p "$folder"
cd "$folder"

# What is pasted is what the program writes.
awk '/^\/\/ zonal [0-9]/ { on = 1 } on { print } on && /^#endif/ { exit }' "$examples/irradiance.frag" >pasted
options="$(sed -n 's/^\/\/ zonal [0-9.]*, GLSL ES 3.00. //p' pasted)"
[ -n "$options" ] || { echo "irradiance.frag: no functions are pasted"; exit 1; }
# shellcheck disable=SC2086 # options are words
"$program" $options --dialect glsles300 -o written
diff pasted written || { echo "irradiance.frag: run scripts/paste_shaders.sh <zonal-glsl>"; exit 1; }

if ! command -v glslangValidator >/dev/null; then
  echo "skipped: no glslangValidator (Debian package glslang-tools)"
  [ "${CI:-}" = true ] && exit 1
  exit 77
fi
glslangValidator --quiet "$examples/irradiance.frag"
for name in gather grid screen; do
  cp "$examples/$name.comp" .
  options="$(sed -n 's/.*: zonal-glsl //p' "$name.comp")"
  # shellcheck disable=SC2086
  "$program" $options
  for target in vulkan1.0 vulkan1.2 opengl; do
    glslangValidator --quiet --target-env "$target" "$name.comp" -o "$name.spv"
    if command -v spirv-val >/dev/null; then spirv-val "$name.spv"; fi
  done
done
glslangValidator --quiet -DPASS=1 --target-env vulkan1.0 screen.comp -o screen_across.spv
