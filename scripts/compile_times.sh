#!/usr/bin/env bash
# How long each function takes to compile, by numbers of bands, as a Markdown table on standard output: processor seconds
# of a unit that uses the function once, less those of its headers alone.
#   compile_times.sh [BANDS...]        21 where none is given; CXX and CXXFLAGS as usual, g++ -O2 where they are not set
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
[ $# -gt 0 ] || set -- 21
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
read -ra compile <<< "${CXX:-g++} -std=c++17 ${CXXFLAGS:--O2} -I$root/include -idirafter /usr/include/eigen3"

# seconds <header> <statement>
seconds() {
  printf '#include <array>\n#include <glm/vec3.hpp>\n#include <zonal/zonal.hpp>\n#include <zonal/%s>\n%s\n' "$1" "$2" \
    > "$folder/unit.cpp"
  { TIMEFORMAT='%U'; time "${compile[@]}" -c "$folder/unit.cpp" -o "$folder/unit.o"; } 2>&1
}

# row <name> <header> <type of the result> <parameters> <call>; N stands for the bands.
row() {
  local bands empty line="| $1 |"
  empty="$(seconds "$2" "")"
  for bands in "${all_bands[@]}"; do
    line+=" $(seconds "$2" "constexpr int N = $bands; $3 f($4) { return $5; }" |
      awk -v empty="$empty" '{ printf("%.1f", ($1 > empty) ? $1 - empty : 0) }') |"
  done
  echo "$line"
}

all_bands=("$@")
printf 'Compile time in processor seconds, `%s`, by bands:\n\n| function |' "${CXX:-g++} ${CXXFLAGS:--O2}"
printf ' %s |' "${all_bands[@]}"
printf '\n| --- |'
printf ' --: |%.0s' "${all_bands[@]}"
printf '\n'
vector='const std::array<float, 3>& v'
row evaluate basis/evaluate.hpp 'zonal::Sh<N, float>' "$vector" 'zonal::evaluate<N>(v)'
row evaluate_with_gradient basis/gradient.hpp 'zonal::ShGradient<N, float>' "$vector" 'zonal::evaluate_with_gradient<N>(v)'
row evaluate_with_hessian basis/gradient.hpp 'zonal::ShHessian<N, float>' "$vector" 'zonal::evaluate_with_hessian<N>(v)'
row orient transform/orient.hpp 'zonal::Sh<N, float>' "const zonal::Zh<N, float>& z, $vector" 'zonal::orient(z, v)'
at='const glm::vec3& x'
row 'sphere light' light/sphere.hpp 'zonal::Sh<N, float>' "const zonal::SphereLight<float>& l, $at" 'zonal::project<N>(l, x)'
row 'sphere light, gradient' light/sphere.hpp 'zonal::ShGradient<N, float>' "const zonal::SphereLight<float>& l, $at" \
  'zonal::project_with_gradient<N>(l, x)'
row 'triangle light' light/triangle.hpp 'zonal::Sh<N, float>' "const zonal::TriangleLight<float>& l, $at" \
  'zonal::project<N>(l, x)'
row 'triangle light, gradient' light/triangle.hpp 'zonal::ShGradient<N, float>' \
  "const zonal::TriangleLight<float>& l, $at" 'zonal::project_with_gradient<N>(l, x)'
