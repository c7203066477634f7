#!/usr/bin/env bash
# Sequences of light probes for field-bake's cases, in the folder s of the inputs:
#   make_sequences.sh <field-capture> <inputs>
set -eu
capture="$1"
cd "$2"
rm -rf s
"$capture" --quiet --setup spots --probes 8 --size 16 --samples 1 --out s
cd s
rm settings.txt
probe() { grep -m "$1" probe sequence.txt | tail -n 1; }
head_of() { grep -v probe sequence.txt; }
: >empty.txt
: >empty.exr
printf 'mapping mirror sphere\nprobe probe-00000.exr 0 nan 0\n' >nan.txt
printf 'mapping mirror sphere\nprobe probe-00000.exr 0 0\n' >short.txt
{ head_of; for i in 0 1 2; do echo "probe probe-0000$i.exr 0 0 0"; done; } >one-place.txt
{ head_of; echo "probe probe-00000.exr 0 0 0"; } >one.txt
{ head_of; echo "probe nowhere.exr 0 0 0"; } >missing.txt
{ head_of; echo "probe empty.exr 0 0 0"; } >empty-picture.txt
echo "probe ../odd.exr 0 0 0" >odd.txt
{ head_of; probe 1; echo "probe nowhere.exr 1 1 1"; } >later-missing.txt
{ head_of; probe 1; echo "probe ../truncated.exr 1 1 1"; } >later-damaged.txt
{ grep orientation sequence.txt; echo "mapping octahedral"; probe 1; echo "probe probe-00001.exr 1 1 1 1 0 0 0"; } >mixed.txt
# Three hundred probes of eight pictures, for what takes some time.
{
  head_of
  for i in $(seq 300); do echo "probe probe-0000$((i % 8)).exr 0.$((i % 7)) 0.$((i % 9)) 0.$((i % 5))"; done
} >many.txt
