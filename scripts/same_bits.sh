#!/usr/bin/env bash
# Compiles tests/same_bits by every compiler, level of optimisation and target that this machine has, runs it, for other
# processors under qemu-user, and compares the hashes with those kept. A table to standard output. Takes an hour of one
# core; of some targets alone (sse2, avx2, avx2-fma, avx512, aarch64), less.
#   scripts/same_bits.sh [<folder to build in> [<target>...]]
set -uo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
build="${1:-$root/build/same_bits}"
wanted=" ${*:2} "
for name in $wanted; do
  case "$name" in
    sse2 | avx2 | avx2-fma | avx512 | aarch64) ;;
    *) echo "same_bits.sh: no target $name" >&2 && exit 2 ;;
  esac
done
mkdir -p "$build/include"
ln -sfn /usr/include/glm "$build/include/glm"  # for cross-compilers, which do not look there
launcher="$(command -v ccache || true)"
failures=0

# target <name> <processor flag> <how to run> <flag>...
target() {
  local name="$1" processor="$2" run="$3" compiler level flags objects file result
  shift 3
  if [ "$wanted" != "  " ] && [[ "$wanted" != *" $name "* ]]; then return; fi
  if [ -n "$processor" ] && ! grep -qw "$processor" /proc/cpuinfo; then
    printf '%-44s skipped: no such processor\n' "$name"
    return
  fi
  for compiler in $compilers; do
    if ! command -v "$compiler" >/dev/null || { [ -n "$run" ] && ! command -v "${run%% *}" >/dev/null; }; then
      printf '%-44s skipped: no %s\n' "$name, $compiler" "$compiler, or no ${run%% *}"
      continue
    fi
    for level in -O0 -O1 -O2 -O3; do
      # GCC 12 fuses what its vectoriser of straight lines takes for multiply-add-subtract, whatever -ffp-contract says.
      case "$compiler $*" in *g++*mfma*) flags="-fno-tree-slp-vectorize" ;; *) flags="" ;; esac
      objects="$build/$name-$compiler$level"
      mkdir -p "$objects"
      result=same
      for file in main basis scene unwritten; do
        $launcher "$compiler" -std=c++17 "$level" "$@" $flags -ffp-contract=off -DNDEBUG -DZONAL_INLINE= -I"$root/include" \
          -isystem "$build/include" -c "$root/tests/same_bits/$file.cpp" -o "$objects/$file.o" || result="does not compile"
      done
      [ "$result" = same ] && { "$compiler" $static "$objects"/*.o -o "$objects/same_bits" || result="does not link"; }
      if [ "$result" = same ]; then
        $run "$objects/same_bits" >"$objects/bits.txt" 2>&1
        diff "$root/tests/data/same_bits.txt" "$objects/bits.txt" >"$objects/difference.txt" ||
          result="$(grep -c '^>' "$objects/difference.txt") kernels differ: $objects/difference.txt"
      fi
      [ "$result" = same ] || failures=$((failures + 1))
      printf '%-44s %s\n' "$name, $compiler $level $flags" "$result"
    done
  done
}

static=""
compilers="g++ clang++"
target sse2 "" ""
target avx2 avx2 "" -mavx2
target avx2-fma fma "" -mavx2 -mfma
target avx512 avx512f "" -mavx512f -mavx512dq -mavx512bw -mavx512vl -mfma
static="-static"
compilers="aarch64-linux-gnu-g++"
target aarch64 "" qemu-aarch64
exit $((failures > 0))
