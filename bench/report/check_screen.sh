#!/usr/bin/env bash
# check_screen.sh SCRIPTS [IGI_RENDER]: quick renders become data, plots, pictures and a page; and a panel without rows is
# an error.
source "$(dirname "${BASH_SOURCE[0]}")/check_renders.sh"
begin igi-render "${2-}"

"$python" "$1/report_screen.py" "$2" "$folder" --quick 2> "$folder/warnings" || { cat "$folder/warnings"; exit 1; }
"$python" "$1/report.py" plot "$folder"
# Five scenes by six filters and the bands alone, and five pictures by two numbers of sets.
awk -F, '
  function fail(why) { printf "screen.csv: %s: %s\n", why, $0; bad = 1 }
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  { ++lines[$at["part"]] }
  !($at["rmse"] > 0 && $at["rmse"] < 0.6) { fail("error") }
  $1 == "sweep" && $at["filter"] != "bands alone" && !($at["light_s"] > 0 && $at["bytes"] >= 24) { fail("time or memory") }
  END { if (lines["sweep"] != 35 || lines["sets"] != 10) fail("lines"); exit bad }' "$folder/screen.csv"
shown '(pictures/)?screen[^)]*(svg|png)' > "$folder/shown"
[ "$(wc -l < "$folder/shown")" = 5 ] || { echo "not five plots and pictures"; exit 1; }

sed -i '/^sweep,probe,/s/4x4/2x2/' "$folder/screen.csv"  # no panel has both of these
if "$python" "$1/report.py" plot "$folder" 2> "$folder/error" || ! grep -q "no rows to draw" "$folder/error"; then
  echo "a panel without rows is not an error"
  exit 1
fi
echo "all of the screen is there"
