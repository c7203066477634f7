#!/usr/bin/env bash
# Dropping outputs drops work: operation_counts.sh <zonal-glsl>
set -eu
table="$("$1" --bands 5 --count \
  --functions evaluate,evaluate:even,evaluate:degree2,reconstruct,reconstruct_lambert,cap,cap_up_to_hemisphere)"
echo "$table"
operations() { awk -v name="zonal_$1" '$1 == name { print $2 }' <<<"$table"; }
fail() { echo "$1"; exit 1; }

all="$(operations evaluate_5)"
# Sloan's scheme with constants folded, counted by hand: tests/scalar/recorder_test.cpp.
[ "$all" -le 58 ] || fail "evaluate takes more than Sloan's 58"
[ "$(operations evaluate_5_even)" -lt "$all" ] || fail "half of the coefficients takes no less than all"
[ "$(operations evaluate_5_degree2)" -lt "$(operations evaluate_5_even)" ] || fail "a degree takes no less than half"
[ "$(operations reconstruct_lambert_5)" -lt "$(operations reconstruct_5)" ] || fail "Lambert's zeros save nothing"
# HVL Eq. 14 by recurrence takes 25: the row cap_legendre of docs/benchmarks.md.
[ "$(operations cap_up_to_hemisphere_5)" -le 25 ] || fail "the cap takes more than HVL Eq. 14"

# A colour, and its derivatives by coefficients and by a unit vector; 24 more and it is any vector.
adjoints="$("$1" --count --functions reconstruct_with_adjoint@3,reconstruct_with_adjoint@4 \
  --adjoint reconstruct_colour@3,reconstruct_colour@4,splat_colour@4)"
pruned="$("$1" --count --adjoint splat_colour@4 --by position)"
echo "$adjoints"
operations() { awk -v name="zonal_$1" '$1 == name { print $2 }' <<<"$adjoints"; }
[ "$(operations reconstruct_colour_3_adjoint)" -le 170 ] || fail "a colour and its derivatives at 3 bands"
[ "$(operations reconstruct_colour_4_adjoint)" -le 330 ] || fail "a colour and its derivatives at 4 bands"
[ "$(operations reconstruct_with_adjoint_3)" -le $((170 + 24)) ] || fail "along a vector at 3 bands"
[ "$(operations reconstruct_with_adjoint_4)" -le $((330 + 24)) ] || fail "along a vector at 4 bands"
[ "$(operations splat_colour_4_adjoint)" -gt "$(awk '/splat/ { print $2 }' <<<"$pruned")" ] ||
  fail "what is not asked for is computed"
