# Sourced by demo.sh, test.sh, benchmarks.sh and report.sh: installs what is missing, and configures build/release, or
# build/$zonal_preset where that is set.
#   zonal_setup <ZONAL_REQUIRE_...> <package>...
#   zonal_jobs, a number: how many compilations may run at once
# Works on Debian 12 and its like; a second run finds all in place and does nothing.

zonal_root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
zonal_preset="${zonal_preset:-release}"
zonal_build="$zonal_root/build/$zonal_preset"
zonal_packages=(
  g++ cmake ninja-build libeigen3-dev libglm-dev libembree-dev libtbb-dev libcli11-dev nlohmann-json3-dev
  libstb-dev libopenexr-dev
)
# For tests and benchmarks; the second line is for shaders: a driver, and compilers.
zonal_test_packages=(
  catch2 libbenchmark-dev clang libboost-dev
  libegl1 libgl1-mesa-dri libegl-dev libgl-dev libvulkan-dev mesa-vulkan-drivers glslang-tools spirv-tools
)

zonal_say() { printf '[zonal] %s\n' "$*"; }
zonal_fail() { printf '[zonal] %s\n' "$*" >&2; exit 1; }

# One compilation takes up to 1.8 GiB.
zonal_jobs="$(awk -v cores="$(nproc)" '/^MemAvailable:/ { jobs = int($2 / 1887437) }
  END { if (jobs < 1) jobs = 1; print (jobs < cores ? jobs : cores) }' /proc/meminfo)"

zonal_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

zonal_install() {
  local package missing=() sudo=()
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    zonal_fail "not a Debian system; needed are the equivalents of: $*"
  fi
  for package in "$@"; do
    zonal_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return

  if [ "$(id -u)" -ne 0 ]; then
    # Without a terminal sudo cannot ask for a password.
    if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
      sudo=(sudo)
    else
      zonal_fail "cannot install packages without root or sudo; missing: ${missing[*]}"
    fi
  fi
  zonal_say "installing ${missing[*]}"
  "${sudo[@]}" apt-get -q -o DPkg::Lock::Timeout=120 update
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y -o DPkg::Lock::Timeout=120 install --no-install-recommends "${missing[@]}"
}

zonal_setup() {
  local require="$1" cache="$zonal_build/CMakeCache.txt"
  shift
  zonal_install "${zonal_packages[@]}" "$@"

  # CMake refuses a build folder that came along with a copied tree, or that another generator has filled.
  if [ -f "$cache" ] && ! { grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$zonal_root" "$cache" &&
      grep -qxF "CMAKE_GENERATOR:INTERNAL=Ninja" "$cache"; }; then
    rm -rf "$zonal_build"
  fi
  # Later changes to CMakeLists.txt are the build's own business: it configures again by itself.
  if [ ! -f "$zonal_build/build.ninja" ] || ! grep -qx "$require:BOOL=ON" "$cache"; then
    zonal_say "configuring build/$zonal_preset"
    (cd "$zonal_root" && cmake --preset "$zonal_preset" -DZONAL_REQUIRE_EXAMPLES=ON "-D$require=ON")
  fi
}
