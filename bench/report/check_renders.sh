# Sourced by check_gather.sh, check_many_lights.sh, check_screen.sh and check_field.sh.
set -euo pipefail
python=/usr/bin/python3

# begin <program's name> <its path, or nothing>: a folder for what it makes; the test is skipped where something is missing.
begin() {
  [ -n "$2" ] || { echo "skipped: $1 is not part of this build"; exit 0; }
  "$python" -c 'import matplotlib' 2>/dev/null || { echo "skipped: matplotlib of $python is not installed (Debian: python3-matplotlib)"; exit 0; }
  folder="$(mktemp -d)"
  trap 'rm -rf "$folder"' EXIT
}

# shown <pattern>: the page's pictures whose links match; each must be there.
shown() {
  grep -oE "\\($1\\)" "$folder/README.md" | tr -d '()' | while read -r picture; do
    [ -s "$folder/$picture" ] || { echo "no $picture" >&2; exit 1; }
    echo "$picture"
  done
}
