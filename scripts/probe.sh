#!/usr/bin/env bash
# Builds zonal-probe, after installing what it needs, and runs it with the arguments:
#   scripts/probe.sh sky.exr --convention unity
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

{
  zonal_setup ZONAL_REQUIRE_EXAMPLES
  program="$zonal_build/tools/zonal-probe/zonal-probe"
  [ -x "$program" ] || zonal_say "building zonal-probe ($zonal_jobs at a time)"
  cmake --build "$zonal_build" --target zonal-probe -j "$zonal_jobs" -- --quiet
} >&2
exec "$program" "$@"
