#!/usr/bin/env bash
# check_field.sh SCRIPTS [FIELD_CAPTURE FIELD_BAKE FIELD_RENDER]: quick captures, bakes and renders become data, plots,
# pictures and a page.
source "$(dirname "${BASH_SOURCE[0]}")/check_renders.sh"
begin "field-capture, field-bake or field-render" "${4-}"

"$python" "$1/report_field.py" "$2" "$3" "$4" "$folder" --quick
"$python" "$1/report.py" plot "$folder"
# Two set-ups: of two numbers of probes two grids, and of most probes seven more; and ten pictures.
awk -F, '
  function fail(why) { printf "field.csv: %s: %s\n", why, $0; bad = 1 }
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  { ++lines[$1] }
  $1 == "error" && !($at["error"] > 0.05 && $at["error"] < 1) { fail("error") }
  $1 == "error" && !($at["bake_s"] > 0) { fail("time") }
  $1 == "picture" && !($at["rmse"] > 0 && $at["rmse"] < 0.4) { fail("picture") }
  END { if (lines["error"] != 22 || lines["picture"] != 10) fail("lines"); exit bad }' "$folder/field.csv"
shown '(pictures/)?field[^)]*(svg|png)' > "$folder/shown"
[ "$(wc -l < "$folder/shown")" = 5 ] || { echo "not five plots and pictures"; exit 1; }
echo "all of the field is there"
