#!/usr/bin/env bash
# libFuzzer on every reader of files, with the sanitizers, for so many seconds in all (10 minutes for each of nine
# readers).   scripts/fuzz.sh [<seconds> [<folder to build in>]]
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
exec cmake "-Dcompiler=$(command -v clang++)" "-Dsource_dir=$root" "-Dwork_dir=${2:-$root/build/fuzz}" \
  "-Dsystem_dirs=|/usr/include/eigen3" "-Dlimit=-max_total_time=${1:-5400}" -P "$root/tests/support/fuzz.cmake"
