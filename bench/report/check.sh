#!/usr/bin/env bash
# check.sh ZONAL_REPORT_DATA REPORT_PY: quick data of every part has its columns, numbers that can be true, and, where
# matplotlib is there, becomes a page.
set -euo pipefail

program="$1" script="$2"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

# part <name> <header> <awk program>: each line, after the header, must be true of the program's `ok`, and all fields
# from the first number on be finite numbers; a BEGIN or END block may set `bad`.
part() {
  local file="$folder/$1.csv"
  "$program" "$1" --quick > "$file"
  [ "$(head -n 1 "$file")" = "$2" ] || { echo "$1: the columns are $(head -n 1 "$file")"; exit 1; }
  awk -F, -v part="$1" -v columns="$(tr -cd , <<< "$2" | wc -c)" '
    function fail(why) { printf "%s: %s: %s\n", part, why, $0; bad = 1 }
    NR == 1 { next }
    NF != columns + 1 { fail("columns") }
    /nan|inf/ { fail("not a number") }
    '"$3"'
    END { if (NR < 5) fail("too few lines"); exit bad }' "$file"
}

part evaluation quantity,form,scalar,lanes,bands,ns,error '
  $6 <= 0 || $6 > 1e5 { fail("time") }
  $2 ~ /^(evaluate|orient|evaluate_with_gradient|cap)$/ && $7 > ($3 == "double" ? 1e-13 : 2e-5) { fail("error") }
  $2 == "cap_closed_form" && $3 == "float" && $5 > 1 && $7 < 0.01 { fail("accurate for small caps") }'
part interpolation \
  method,bands,lights,resolution,kibibytes,build_ms,lookup_ns,lookup_with_gradient_ns,value_error,gradient_error '
  $7 <= 0 || $8 <= 0 { fail("time") }
  { error[$1, $4] = $9 }
  END { if (!(error["hermite", 6] < 0.2 * error["trilinear", 6])) fail("Hermite is no better") }'
part triangles method,bands,triangles,nodes,ns,value_error,gradient_error '
  $5 <= 0 { fail("time") }
  $1 == "quadrature" && $4 == 3 && $6 > 0.01 { fail("error") }
  $1 == "spheres" && ($6 < 1e-4 || $6 > 0.5) { fail("error") }'
part materials material,source,quantity,window,bands,error '
  $6 < 0 || $6 > 1.5 { fail("error") }
  $1 == "Lambert" && $3 == "emitter" && $6 > 1e-6 { fail("a diffuse emitter is one band") }
  $4 == "none" && $3 == "receiver" && $5 > 1 && $6 > 1.02 * last[$1] { fail("more bands, more error") }
  $4 == "none" && $3 == "receiver" { last[$1] = $6 }'
part furnace method,material,degrees,bands,lights,relative_energy '
  $1 == "vpl" && $2 == "Lambert" && ($6 < 0.999 || $6 > 1.001) { fail("energy") }
  $1 == "vpl" && $2 == "GGX 0.6" && ($6 < 0.98 || $6 > 1.02) { fail("energy") }
  $1 == "hvl" && $2 == "Lambert" && $4 >= 5 && ($6 < 0.9 || $6 > 1.1) { fail("energy") }'
part stiff plot,form,x,y '
  $1 == "cap" && $2 == "differences" && $4 > 1e-6 { fail("error") }
  $1 == "gradient" && $2 == "ladder" && $4 > 1e-5 { fail("error") }
  $1 == "solid_angle" && $2 == "edges" && $4 > 1e-5 { fail("error") }
  $1 == "solid_angle" && $2 == "corners" { corners = $4 > corners ? $4 : corners }
  $2 == "cap" && $1 == "degree" && $4 > 1e-6 { fail("error") }
  END { if (corners < 0.1) fail("from its corners a far triangle is as exact") }'
part probe environment,source,form,bytes,rmse,greatest,least '
  $6 < $5 { fail("the greatest error is below their mean") }
  $3 == "3 bands; floats" && $5 > 0.08 { fail("error") }
  $3 ~ /non-linear/ && $7 < 0 { fail("negative") }
  { error[$1, $3] = $5 }
  $3 == "ZH3; projected" && error[$1, "ZH3; solved"] > 1.05 * $5 { fail("no better when solved") }
  $3 == "3 bands; halves" && $5 > 1.01 * error[$1, "3 bands; floats"] + 1e-3 { fail("halves") }'
"$program" machine | grep -q '^processor,..*' || { echo "machine: no processor"; exit 1; }

if /usr/bin/python3 -c 'import matplotlib' 2>/dev/null; then
  /usr/bin/python3 "$script" plot "$folder"
  for name in evaluation interpolation triangles stiff materials furnace probe; do
    grep -q "($name.svg)" "$folder/README.md" && grep -q '</svg>' "$folder/$name.svg" || { echo "no $name.svg"; exit 1; }
  done
fi
echo "all parts are there"
