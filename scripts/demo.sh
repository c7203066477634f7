#!/usr/bin/env bash
# Renders a scene with Harmonics Virtual Lights and without, into out/, and lit by hundreds of sphere lights with a grid
# and without, into out/grid/; installs and builds what it needs. Further arguments go to hvl-render.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

zonal_setup ZONAL_REQUIRE_EXAMPLES
zonal_say "building hvl-render and grid-render ($zonal_jobs at a time)"
cmake --build "$zonal_build" --target hvl-render grid-render -j "$zonal_jobs"
cd "$zonal_root"
zonal_say "rendering into out/"
"$zonal_build/examples/hvl-render/hvl-render" --compare out "$@"
zonal_say "rendering into out/grid/"
"$zonal_build/examples/grid-render/grid-render" --compare out/grid
