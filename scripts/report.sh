#!/usr/bin/env bash
# Writes docs/report: data as CSV, plots, and a page that shows them. Installs and builds what it needs.
#   report.sh [--full] [PART...]
# PART: gather, evaluation, interpolation, triangles, stiff, materials, furnace, probe, many_lights, screen, field; all of them where none
# is named.
# On two cores with nothing else to do three minutes for the screen, five for the field, ten for many lights, under five for all others; --full
# takes hours. Files of measured materials in $ZONAL_DATA/merl and $ZONAL_DATA/rgl are part of it, and pictures of
# surroundings in $ZONAL_DATA, EXR and HDR. To draw all anew from
# the CSV files: report.py plot docs/report.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

all_parts=(evaluation interpolation triangles stiff materials furnace probe gather many_lights screen field)
full=() parts=()
for argument in "$@"; do
  if [ "$argument" = --full ]; then
    full=(--full)
  elif [[ " ${all_parts[*]} " == *" $argument "* ]]; then
    parts+=("$argument")
  else
    zonal_fail "usage: report.sh [--full] [PART...]; a part is one of ${all_parts[*]}"
  fi
done
[ ${#parts[@]} -gt 0 ] || parts=("${all_parts[@]}")

zonal_setup ZONAL_REQUIRE_TESTS "${zonal_test_packages[@]}" python3 python3-matplotlib
zonal_say "building zonal-report-data and the examples' programs ($zonal_jobs at a time)"
cmake --build "$zonal_build" --target zonal-report-data hvl-render igi-render field-capture \
  field-bake field-render -j "$zonal_jobs"

python=/usr/bin/python3  # the one that python3-matplotlib is for
data="$zonal_build/bench/report/zonal-report-data" folder="$zonal_root/docs/report"
unfinished="$(mktemp)"
trap 'rm -f "$unfinished"' EXIT
mkdir -p "$folder"

# run <name> <command...>: a CSV file, replaced when it is whole
run() {
  "${@:2}" > "$unfinished"
  install -m 644 "$unfinished" "$folder/$1.csv"
}

# describe <load>: how each part was made; a later run of single parts leaves the others as they are.
describe() {
  "$data" machine
  printf 'threads,%s\n' "$(nproc)"
  printf 'load,%s\n' "$1"  # what others did: times of stages are of the wall's clock
  printf 'commit,%s\n' "$(git -C "$zonal_root" rev-parse --short HEAD 2>/dev/null || echo unknown)"
  printf 'changed,%s\n' "$(git -C "$zonal_root" status --porcelain -- include bench examples | grep -c . || true)"
  printf 'date,%s\n' "$(date -u +%Y-%m-%d)"
  printf 'run,%s\n' "${full[0]-short}"
}

for part in "${parts[@]}"; do
  zonal_say "measuring: $part"
  load="$(cut -d ' ' -f 1 /proc/loadavg)"
  case "$part" in
    gather) "$python" "$zonal_root/scripts/report_gather.py" "$zonal_build/examples/hvl-render/hvl-render" "$data" \
      "$folder" "${full[@]}" ;;
    many_lights) "$python" "$zonal_root/scripts/report_many_lights.py" \
      "$zonal_build/examples/hvl-render/hvl-render" "$data" "$folder" "${full[@]}" ;;
    screen) "$python" "$zonal_root/scripts/report_screen.py" "$zonal_build/examples/igi-render/igi-render" "$folder" \
      "${full[@]}" ;;
    field) "$python" "$zonal_root/scripts/report_field.py" "$zonal_build/examples/field-capture/field-capture" \
      "$zonal_build/examples/field-bake/field-bake" "$zonal_build/examples/field-render/field-render" "$folder" \
      "${full[@]}" ;;
    *) run "$part" "$data" "$part" "${full[@]}" ;;
  esac
  run "$part.machine" describe "$load"
done

zonal_say "drawing docs/report"
"$python" "$zonal_root/scripts/report.py" plot "$folder"
