#!/usr/bin/env bash
# Compiles every function in a dialect at some numbers of bands: compile_dialect.sh <zonal-glsl> <dialect> <c++> <folder>
# Exit status 77 where this machine has no compiler of the dialect; 1 instead where CI=true.
set -eu
program="$1" dialect="$2" cxx="$3" folder="$4"
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

skip() {
  echo "skipped: $1"
  [ "${CI:-}" = true ] && exit 1
  exit 77
}
need() { command -v "$1" >/dev/null || skip "no $1 (Debian package $2)"; }
names="$("$program" --list | awk '/^Loops/ { exit } NF { print $1 }' | paste -sd,)"

for bands in 1 2 5 10; do
  "$program" --bands "$bands" --functions "$names" --dialect "$dialect" -o functions
  case "$dialect" in
    glsl450)
      need glslangValidator glslang-tools
      { printf '#version 450\nlayout(local_size_x = 1) in;\n'; cat functions; echo 'void main() {}'; } >shader.comp
      glslangValidator -V shader.comp -o shader.spv
      if command -v spirv-val >/dev/null; then spirv-val shader.spv; fi
      ;;
    glsles300)
      need glslangValidator glslang-tools
      { printf '#version 300 es\nprecision highp float;\n'; cat functions; echo 'void main() {}'; } >shader.frag
      glslangValidator shader.frag
      ;;
    hlsl)
      need glslangValidator glslang-tools
      { cat functions; printf '[numthreads(1, 1, 1)]\nvoid main() {}\n'; } >shader.hlsl
      glslangValidator -D -V -S comp -e main shader.hlsl -o shader.spv
      ;;
    wgsl)
      # No Debian package has a compiler of WGSL: naga (cargo) or tint where there is one, else naga from npm.
      if command -v naga >/dev/null; then
        cp functions shader.wgsl
        naga shader.wgsl
      elif command -v tint >/dev/null; then
        tint --format wgsl functions >/dev/null
      elif command -v npm >/dev/null && { [ -d node_modules ] || npm install --silent naga-wasm@30 >/dev/null 2>&1; }; then
        node --input-type=module -e '
          import { readFileSync } from "fs";
          import { parseWgsl, validate } from "naga-wasm";
          validate(parseWgsl(readFileSync("functions", "utf8")));'
      else
        echo "skipped: neither naga nor tint, nor npm and its naga-wasm"
        exit 77
      fi
      ;;
    cpp)
      { cat functions; echo 'int main() {}'; } >shader.cpp
      "$cxx" -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Werror \
        -Wno-unused-function -Wno-unused-parameter shader.cpp -o shader
      ;;
  esac
done
