#!/usr/bin/env bash
# The papers' tables with what this machine makes of them, as Markdown on standard output: docs/benchmarks.md. Installs
# and builds what it needs; progress goes to standard error.
#   benchmarks.sh [--full]
# About nine minutes on two cores with nothing else to do. --full renders 1920x1080, and Table 4 at the same size.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

size=640x512 shapes_size=320x256  # Table 4 has no times, and exact triangles are slow
case "${1-}" in
  "") ;;
  --full) size=1920x1080 shapes_size=1920x1080 ;;
  *) zonal_fail "usage: benchmarks.sh [--full]" ;;
esac

{
  zonal_setup ZONAL_REQUIRE_TESTS "${zonal_test_packages[@]}" python3
  zonal_say "building zonal-bench and grid-render ($zonal_jobs at a time)"
  limits=(zonal-limits)
  if ninja -C "$zonal_build" -t query zonal-limits-avx2 >/dev/null 2>&1; then limits+=(zonal-limits-avx2); fi
  cmake --build "$zonal_build" --target zonal-bench "${limits[@]}" grid-render -j "$zonal_jobs"
} >&2

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
print_tables="$zonal_root/scripts/benchmark_tables.py"

# report <name> <argument>...: grid-render's JSON
report() {
  zonal_say "rendering $1" >&2
  "$zonal_build/examples/grid-render/grid-render" --quiet --antialias 1 --report "$folder/$1.json" "${@:2}"
}

cat <<TEXT
# Benchmarks

Written by \`scripts/benchmarks.sh\`$([ "$size" = 640x512 ] || echo ' --full'). Where two numbers stand side by side, the left
one is what the paper prints.

TEXT
zonal_say "running zonal-bench" >&2
printf '```\n'
"$zonal_build/bench/zonal-bench" --table
for program in "${limits[@]}"; do
  printf '\n'
  "$zonal_build/bench/limits/$program"
done
printf '```\n\n'
cat <<'TEXT'
The limits are lower bounds of the time, from rates that were measured in the same run: multiplications, each with an addition
fused or without; all operations, what can be fused counted once; divisions and roots, which one unit does; registers of inputs
and of results, each read or written once. Constants and what registers have no room for are not counted.

What falls short of 85 % (results stored in the first-level cache), 80 % (`reconstruct`: the basis fused with a dot product) or
70 % (`gather`), and why, as far as it is known:

- `gather` with 8 lanes. The chain from a light's place to its share (four roots, three divisions, two polynomials) is about as
  long as all else that a packet takes, and 16 registers leave no room to run two packets side by side. Tried, and no faster:
  packets of two registers, the lights' part in a loop of its own, the next light's direction ahead of time; the polynomial of
  the arc sine in two halves gains 3 %.
- `evaluate planes`: 512 kB of results, so each store is to a line of the second-level cache, as many lines at once as there are
  planes; a fill goes through one after the other. Where planes crowd each other out of the first-level cache (their stride a
  multiple of 1 kB at 5 bands, of 256 bytes at 10) they are staged, at twice the time. `evaluate rows`: each number is stored
  twice, with shuffles in between.
- `evaluate_with_gradient`, 16 lanes, 10 bands: its results are more than the first-level cache holds beside the inputs.
- `convolve`, `rotate`, and much of the registry: its form, which is timed, copies inputs and results through memory, and a kernel
  that is called so keeps a receiver's numbers as whole registers. The others were not looked into.

TEXT

python3 "$print_tables" picture "$folder/waves.ppm"
for lights in 1793 578 512 242 800 722; do
  report "lights_$lights" --size "$size" --lights "$lights" --compare "$folder/out"
done
for texels in 60:900 100:2500; do
  report "lights_${texels#*:}" --size "$size" --texture "$folder/waves.ppm" --texture-size "${texels%:*}" \
    --compare "$folder/out"
done
python3 "$print_tables" table_3 "$folder"

for lights in 288 512 800 722; do
  report "shapes_$lights" --size "$shapes_size" --lights "$lights" --compare-shapes "$folder/out"
done
python3 "$print_tables" table_4 "$folder"

for bands in 5 7 9; do
  report "bands_$bands" --size "$size" --lights 512 --bands "$bands" --compare "$folder/out"
done
python3 "$print_tables" table_5 "$folder"

zonal_say "compiling a unit of each room" >&2
printf '\n'
python3 "$zonal_root/bench/compile/table.py"
cat <<'TEXT'

`zonal.hpp` takes 1.3 times as long as its standard headers. None of it is compiled before it is used: what takes the time is
parsing 3600 lines, all headers alike; `basis/evaluate.hpp` and what it includes take 1.1 times as long.
TEXT
