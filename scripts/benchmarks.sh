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
