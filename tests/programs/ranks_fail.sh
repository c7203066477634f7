#!/usr/bin/env bash
# Several ranks that cannot go on end, all of them, and say why:
#   ranks_fail.sh <field-bake> <mpiexec> <ranks>
set -u
bake="$1" mpiexec="$2" ranks="$3"
folder="$(mktemp -d)"
"$mpiexec" --allow-run-as-root --oversubscribe -n "$ranks" "$bake" nowhere.txt >"$folder/output" 2>"$folder/errors"
status=$?
grep -m 1 '^field-bake: ' "$folder/errors" >&2
rm -r "$folder"
exit "$status"
