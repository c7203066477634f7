#!/usr/bin/env bash
# check_gather.sh ZONAL_REPORT_DATA SCRIPTS [HVL_RENDER]: quick renders become data, pictures and a page with a verdict on
# each of the paper's claims.
source "$(dirname "${BASH_SOURCE[0]}")/check_renders.sh"
begin hvl-render "${3-}"

"$python" "$2/report_gather.py" "$3" "$1" "$folder" --quick
"$python" "$2/report.py" plot "$folder"
awk -F, 'NR > 1 && ($18 <= 0 || $18 > 0.5 || $17 <= 0) { print "gather.csv: " $0; bad = 1 } END { exit bad }' \
  "$folder/gather.csv"
verdicts="$(grep -cE '^- Fig[.] 1[01] a and [bce]: [*]{2}(holds|fails|not decided|no comparison)[*]{2}' "$folder/README.md")"
[ "$verdicts" = 6 ] || { echo "$verdicts verdicts instead of 6"; exit 1; }
shown 'pictures/[^)]*' > "$folder/shown"
echo "all of the gather is there"
