#!/usr/bin/env bash
# libFuzzer, with the sanitizers, on every reader of files and every program's command line, one after the other, each
# for so many seconds; or on those that are named.   scripts/fuzz.sh [<seconds> [<target>,... [<folder to build in>]]]
#   scripts/fuzz.sh 30             half a minute each
#   scripts/fuzz.sh 600 obj,exr    ten minutes each of these
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
exec cmake "-Dcompiler=$(command -v clang++)" "-Dsource_dir=$root" "-Dwork_dir=${3:-$root/build/fuzz}" \
  "-Dsystem_dirs=|/usr/include/eigen3" "-Dlimit=-max_total_time=${1:-600}" "-Dtargets=${2:-all}" \
  -P "$root/tests/support/fuzz.cmake"
