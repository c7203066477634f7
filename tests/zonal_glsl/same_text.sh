#!/usr/bin/env bash
# Every function twice: the same text, in less than a second each. same_text.sh <zonal-glsl>
set -eu
for name in $("$1" --list | awk '/^[a-z]/ { print $1 }'); do
  start="$(date +%s%N)"
  first="$("$1" --bands 10 --functions "$name")"
  milliseconds="$((($(date +%s%N) - start) / 1000000))"
  [ "$first" = "$("$1" --bands 10 --functions "$name")" ] || { echo "$name: two texts"; exit 1; }
  [ "$milliseconds" -lt 1000 ] || { echo "$name: $milliseconds ms"; exit 1; }
done
