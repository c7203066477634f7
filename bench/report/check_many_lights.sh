#!/usr/bin/env bash
# check_many_lights.sh REPORT_DATA SCRIPTS [HVL_RENDER]: quick renders within a tolerance become data, a plot and a page.
source "$(dirname "${BASH_SOURCE[0]}")/check_renders.sh"
begin hvl-render "${3-}"

"$python" "$2/report_many_lights.py" "$3" "$1" "$folder" --quick
"$python" "$2/report.py" plot "$folder"
# Two numbers of lights and one of most, two tolerances, one run in full.
awk -F, '
  function fail(why) { printf "many_lights.csv: %s: %s\n", why, $0; bad = 1 }
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  { ++lines[$1] }
  $1 != "full" && !($at["measured"] <= $at["tolerance"]) { fail("measured") }
  $1 != "full" && !($at["proved"] <= 1.1 * $at["tolerance"]) { fail("proved") }
  # Of few lights each may be taken, which leaves nothing but rounding.
  $1 != "full" && $at["lights"] > 100 && !($at["proved"] > $at["measured"] && $at["measured"] > 0) { fail("errors") }
  $1 != "full" && !($at["lights_per_hit"] > 0 && $at["lights_per_hit"] <= $at["lights"]) { fail("lights") }
  END { if (lines["lights"] != 3 || lines["tolerance"] != 2 || lines["full"] != 1) fail("lines"); exit bad }' \
  "$folder/many_lights.csv"
shown 'many_lights[.]svg' > "$folder/shown"
[ "$(wc -l < "$folder/shown")" = 1 ] || { echo "no plot"; exit 1; }
echo "all of the many lights is there"
