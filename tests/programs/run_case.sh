#!/usr/bin/env bash
# One case of cases.cmake, in a folder of its own that starts as a copy of the inputs:
#   run_case.sh <inputs> <folder> <exit status> <new files> <pattern> <command>...
# All of standard error must match the pattern, on one line where there is any; a command that fails must print
# nothing else. New files are those in the folder afterwards, in alphabetical order.
set -u
inputs="$1" folder="$2" status="$3" new_files="$4" pattern="$5"
shift 5

rm -rf "$folder"
mkdir -p "$(dirname "$folder")"
cp -r "$inputs" "$folder"
cd "$folder" || exit 1
checksums() { find . -type f -exec cksum {} + | sort; }
before="$(checksums)"
output="$folder.output" errors="$folder.errors"
"$@" >"$output" 2>"$errors" </dev/null
given=$?

failed=0
grep -qiwE -- "-?(nan|inf)" "$output" && not_numbers="standard output"
for file in *.json out/*.json; do
  [ -f "$file" ] && grep -qiwE -- "-?(nan|inf)" "$file" && not_numbers="$file"
done
complain() { echo "$1"; failed=1; }
[ -z "${not_numbers:-}" ] || complain "nan or inf in $not_numbers"
[ "$given" -eq "$status" ] || complain "exit status $given, not $status"
[ "$(wc -l <"$errors")" -le 1 ] || complain "more than one line on standard error"
grep -qxE -- "$pattern" "$errors" || { [ -z "$pattern" ] && [ ! -s "$errors" ]; } || complain "not '$pattern'"
[ "$status" -eq 0 ] || [ ! -s "$output" ] || complain "a failure that prints on standard output"
! grep -q $'[\033\r]' "$output" "$errors" || complain "control characters where there is no terminal"
found="$(comm -13 <(find "$inputs" -printf '%P\n' | sort) <(find . -printf '%P\n' | sort) | xargs)"
[ "$found" = "$new_files" ] || complain "new files: '$found', not '$new_files'"
[ -z "$(comm -23 <(echo "$before") <(checksums))" ] || complain "an input has changed"

[ "$failed" -eq 0 ] || head -c 2000 "$output" "$errors"
rm -rf "$folder" "$output" "$errors"
exit "$failed"
