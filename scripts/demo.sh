#!/usr/bin/env bash
# Builds hvl-render and renders a scene with Harmonics Virtual Lights and without, into out/; installs what it needs.
# Further arguments go to hvl-render.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

zonal_setup ZONAL_REQUIRE_EXAMPLES
zonal_say "building hvl-render ($zonal_jobs at a time)"
cmake --build "$zonal_build" --target hvl-render -j "$zonal_jobs"
zonal_say "rendering into out/"
cd "$zonal_root"
"$zonal_build/examples/hvl-render/hvl-render" --compare out "$@"
