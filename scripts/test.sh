#!/usr/bin/env bash
# Builds everything and runs every test, in build/test; installs what it needs. Further arguments go to ctest.
set -euo pipefail
zonal_preset=test
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

zonal_setup ZONAL_REQUIRE_TESTS "${zonal_test_packages[@]}"
zonal_say "building ($zonal_jobs at a time)"
cmake --build "$zonal_build" -j "$zonal_jobs"
zonal_say "testing"
ctest --test-dir "$zonal_build" --output-on-failure -j "$zonal_jobs" "$@"
