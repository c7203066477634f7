#!/usr/bin/env bash
# A bake that is killed twenty times, each time a little later in what is left of it, has the bytes of one that is not:
#   kill_and_go_on.sh <field-bake> <sequence> <folder>
set -u
bake="$1" sequence="$2" folder="$3"
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1
bake=("$bake" --quiet "$sequence" --grid 20 --bands 5 --gradients --memory 1)  # no function: it is to be killed itself

begin="$(date +%s%N)"
"${bake[@]}" --out whole.grid || exit 1
length=$(( $(date +%s%N) - begin ))

RANDOM=14
kills=0
while [ "$kills" -lt 20 ]; do
  delay="$(( length * (RANDOM % 100) / 100 ))"
  "${bake[@]}" --out killed.grid &
  sleep "$(printf '%d.%09d' $((delay / 1000000000)) $((delay % 1000000000)))"
  if ! kill -KILL $! 2>/dev/null; then  # it was done: begin anew
    wait $! || exit 1
    cmp whole.grid killed.grid || exit 1
    rm killed.grid
  fi
  wait $! 2>/dev/null
  kills=$((kills + 1))
done
"${bake[@]}" --out killed.grid || exit 1
cmp whole.grid killed.grid || exit 1
[ ! -e killed.grid.work ] || { find .; exit 1; }
