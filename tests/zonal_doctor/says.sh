#!/usr/bin/env bash
# says.sh <exit status> <words> <command>...: whether the command ends so, and prints a line with these words.
status="$1" words="$2"
shift 2
said="$("$@")"
given=$?
[ "$given" -eq "$status" ] && grep -q -- "$words" <<<"$said" && exit 0
echo "exit status $given, not $status; or no '$words' in: $said"
exit 1
