#!/usr/bin/env bash
# shaders/ is what the generator writes, file by file, and its C++ compiles as it stands:
# same_shaders.sh <zonal-glsl> <source folder> <c++> <folder>
set -eu
rm -rf "$4"
"$2/scripts/write_shaders.sh" "$1" "$4/shaders"
cp "$2/shaders/README.md" "$4/shaders"
diff -rq "$2/shaders" "$4/shaders" || { echo "run scripts/write_shaders.sh anew"; exit 1; }
for file in "$4"/shaders/zonal*; do
  name="$(basename "$file")"
  grep -qF "\`$name\`" "$2/shaders/README.md" || { echo "shaders/README.md does not name $name"; exit 1; }
done
cat >"$4/use.cpp" <<'EOF'
#include "shaders/zonal_functions.hpp"
// Of a constant radiance 1 the irradiance over pi is 1, for any normal.
int main() {
  float radiance[9] = {3.5449077f};
  const float normal[3] = {0.6f, 0.0f, 0.8f};
  const float irradiance = zonal_reconstruct_lambert_3(radiance, normal);
  return irradiance > 0.99999f && irradiance < 1.00001f ? 0 : 1;
}
EOF
"$3" -std=c++17 -O0 "$4/use.cpp" -o "$4/use"
"$4/use" || { echo "zonal_functions.hpp gives other numbers"; exit 1; }
