#!/usr/bin/env bash
# Compiles every function in a dialect: compile_dialect.sh <zonal-glsl> <dialect> <c++> <folder>
# First files of several numbers of bands in one, as they may be included or pasted together: they have the functions
# without bands in common. Then the form without arrays, and adjoints beside what they are of.
# Exit status 77 where this machine has no compiler of the dialect; 1 instead where CI=true.
set -eu
here="$(cd "$(dirname "$0")" && pwd)"
program="$1" dialect="$2" cxx="$3" folder="$4"
mkdir -p "$folder"
cd "$folder"

skip() {
  echo "skipped: $1"
  [ "${CI:-}" = true ] && exit 1
  exit 77
}
need() { command -v "$1" >/dev/null || skip "no $1 (Debian package $2)"; }
names() { "$program" --bands "$1" --list | awk '/^Loops/ { exit } /^[a-z]/ { print $1 }' | paste -sd,; }
adjoints() {  # of those that have one
  for name in $(names "$1" | tr , ' '); do
    if "$program" --bands "$1" --adjoint "$name" >/dev/null 2>&1; then echo "$name"; fi
  done | paste -sd,
}
loops="$("$program" --bands 1 --list | awk '/^Loops/ { after = 1; next } after && /^[a-z]/ { print $1 }' | paste -sd,)"

# What the loops read: a buffer, or in WebGL 2 a texture.
buffers='layout(std430, binding = 0) readonly buffer Floats { float floats[]; };
#define ZONAL_LIGHT(i) floats[i]
#define ZONAL_MATERIAL(i) floats[i]
#define ZONAL_GRID(i) floats[i]
#define ZONAL_VISIBILITY(i) floats[i]
#define ZONAL_SURFACE(i) floats[i]
#define ZONAL_PIXEL(i) floats[i]'
texture='uniform highp sampler2D floats;
#define ZONAL_LIGHT(i) texelFetch(floats, ivec2(int(i), 0), 0).x
#define ZONAL_MATERIAL(i) texelFetch(floats, ivec2(int(i), 0), 0).x
#define ZONAL_GRID(i) texelFetch(floats, ivec2(int(i), 0), 0).x
#define ZONAL_VISIBILITY(i) texelFetch(floats, ivec2(int(i), 0), 0).x
#define ZONAL_SURFACE(i) texelFetch(floats, ivec2(int(i), 0), 0).x
#define ZONAL_PIXEL(i) texelFetch(floats, ivec2(int(i), 0), 0).x'

compile() {
  case "$dialect" in
    glsl450)
      { printf '#version 450\nlayout(local_size_x = 1) in;\n%s\n' "$buffers"; cat "$1"; echo 'void main() {}'; } >shader.comp
      glslangValidator --quiet -V --keep-uncalled shader.comp -o shader.spv
      if command -v spirv-val >/dev/null; then spirv-val shader.spv; fi
      ;;
    glsles300)
      # A fragment shader that names no default precision; and one whose default is low, which no function may use.
      { printf '#version 300 es\n%s\n' "$texture"; cat "$1"; echo 'void main() {}'; } >shader.frag
      glslangValidator --quiet shader.frag
      { printf '#version 310 es\nprecision mediump float;\nlayout(binding = 0) %s\n' "$texture"
        cat "$1"; echo 'void main() {}'; } >mediump.frag
      relaxed() { glslangValidator -H --keep-uncalled "$1" -o "$1.spv" | grep -c RelaxedPrecision || true; }
      [ "$(relaxed mediump.frag)" = 0 ] || { echo "$1: something is computed in mediump"; exit 1; }
      sed 's/highp float t0/float t0/' mediump.frag >one_mediump.frag
      [ "$(relaxed one_mediump.frag)" != 0 ] || { echo "$1: a number in mediump goes unseen"; exit 1; }
      ;;
    hlsl)
      { cat "$1"; printf '[numthreads(1, 1, 1)]\nvoid main() {}\n'; } >shader.hlsl
      glslangValidator --quiet -D -V --keep-uncalled -S comp -e main shader.hlsl -o shader.spv
      ;;
    wgsl) node ./compile_wgsl.mjs "$1" ;;
    cpp)
      { cat "$1"; echo 'int main() {}'; } >shader.cpp
      "$cxx" -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow -Werror \
        -Wno-unused-function -Wno-unused-parameter shader.cpp -o shader
      ;;
  esac
}

precise="" with_loops=""
case "$dialect" in
  glsl450) need glslangValidator glslang-tools; precise=--precise; with_loops=",$loops" ;;
  glsles300) need glslangValidator glslang-tools; with_loops=",$loops" ;;
  hlsl) need glslangValidator glslang-tools; precise=--precise ;;
  wgsl)
    # No Debian package has a compiler of WGSL (its `tint` is a game): naga and Dawn, which browsers have, come from npm.
    # They stay in this folder for the next time.
    { command -v npm && command -v node; } >/dev/null || skip "no npm and node, which bring compilers of WGSL (Debian package npm)"
    [ -d node_modules/webgpu ] && [ -d node_modules/naga-wasm ] ||
      npm install --silent --no-save --no-package-lock naga-wasm@30 webgpu@0.6 >npm.log 2>&1 ||
      skip "npm cannot install naga-wasm and webgpu: $(tail -n 1 npm.log)"
    cp "$here/compile_wgsl.mjs" .
    ;;
esac

: >functions
for bands in 1 2 5 10; do
  # Without a preprocessor, names of its own.
  prefix=zonal_
  if [ "$dialect" = wgsl ]; then prefix="bands${bands}_"; fi
  "$program" --bands "$bands" --functions "$(names "$bands")$with_loops" --dialect "$dialect" --prefix "$prefix" $precise -o functions.one
  cat functions.one >>functions
done
compile functions
"$program" --bands 3 --functions "$(names 3)" --dialect "$dialect" --flat -o functions
compile functions
"$program" --bands 4 --functions "$(names 4)" --adjoint "$(adjoints 4)" --dialect "$dialect" $precise -o functions
compile functions
"$program" --bands 2 --adjoint "$(adjoints 2)" --dialect "$dialect" --flat -o functions
compile functions
