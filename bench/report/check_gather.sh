#!/usr/bin/env bash
# check_gather.sh ZONAL_REPORT_DATA SCRIPTS [HVL_RENDER]: quick renders become data, pictures and a page with a verdict on
# each of the paper's claims.
set -euo pipefail

[ -n "${3-}" ] || { echo "skipped: hvl-render is not part of this build"; exit 0; }
python=/usr/bin/python3
"$python" -c 'import matplotlib' 2>/dev/null || { echo "skipped: matplotlib of /usr/bin/python3 is not installed (Debian: python3-matplotlib)"; exit 0; }
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

"$python" "$2/report_gather.py" "$3" "$1" "$folder" --quick
"$python" "$2/report.py" plot "$folder"
awk -F, 'NR > 1 && ($18 <= 0 || $18 > 0.5 || $17 <= 0) { print "gather.csv: " $0; bad = 1 } END { exit bad }' \
  "$folder/gather.csv"
verdicts="$(grep -cE '^- Fig[.] 1[01] a and [bce]: [*]{2}(holds|fails|not decided|no comparison)[*]{2}' "$folder/README.md")"
[ "$verdicts" = 6 ] || { echo "$verdicts verdicts instead of 6"; exit 1; }
grep -oE '\(pictures/[^)]*\)' "$folder/README.md" | tr -d '()' | while read -r picture; do
  [ -s "$folder/$picture" ] || { echo "no $picture"; exit 1; }
done
echo "all of the gather is there"
