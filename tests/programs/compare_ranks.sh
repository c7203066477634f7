#!/usr/bin/env bash
# Several ranks bake what one does, but for the order of additions:
#   compare_ranks.sh <field-bake> <mpiexec> <ranks>
set -eu
bake="$1" mpiexec="$2" ranks="$3"
run() { "$@" --quiet s/sequence.txt --grid 5 --bands 3; }
run "$bake" --out all.grid
run "$mpiexec" --allow-run-as-root --oversubscribe -n "$ranks" "$bake" --out part.grid
# 60 bytes of header, floats, 8 bytes of checksum.
floats() { head -c -8 "$1" | tail -c +61 | od -An -v -tf4 -w4; }
paste <(floats all.grid) <(floats part.grid) |
  awk '{ d = $1 - $2; if (d < 0) d = -d; a = $1 < 0 ? -$1 : $1; if (a > most) most = a; if (d > apart) apart = d }
    END { if (NR != 3375 || !(most > 0) || apart > 2e-6 * most) { print NR, most, apart; exit 1 } }'
cmp <(head -c 60 all.grid) <(head -c 60 part.grid)
