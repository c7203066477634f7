#!/usr/bin/env bash
# What somebody's code might return: make_inputs.sh <zonal-doctor> <folder>. awk is their code.
set -eu
doctor="$1" folder="$2"
mkdir -p "$folder"
cd "$folder"
"$doctor" --directions --bands 3 >directions.txt
# three.js' nine functions, by code of its own.
basis='{ x = $1; y = $2; z = $3; CONVFMT = OFMT = "%.9g"
  b[0] = 0.282095; b[1] = 0.488603 * y; b[2] = 0.488603 * z; b[3] = 0.488603 * x
  b[4] = 1.092548 * x * y; b[5] = 1.092548 * y * z; b[6] = 0.315392 * (3 * z * z - 1)
  b[7] = 1.092548 * x * z; b[8] = 0.546274 * (x * x - y * y);'
print=' s = b[0]; for (i = 1; i < 9; ++i) s = s " " b[i]; print (alone ? s : x " " y " " z " " s) }'
awk "$basis $print" directions.txt >threejs.txt
awk -v alone=1 "$basis $print" directions.txt >alone.txt
{ echo "x,y,z,b0,b1,b2,b3,b4,b5,b6,b7,b8"; tr ' ' ',' <threejs.txt; } >heading.csv
sed 's/$/\r/' heading.csv >windows.csv
awk "$basis b[7] = -b[7]; $print" directions.txt >sign.txt
awk "$basis t = b[5]; b[5] = b[7]; b[7] = t; $print" directions.txt >exchanged.txt
{ cat threejs.txt; echo "0 0 1 0.28 0"; } >short_line.txt
sed '7s/.*/0 0 one/' threejs.txt >word.txt
sed '4s/^[^ ]*/3/' threejs.txt >long_direction.txt
sed '9s/[^ ]*$/nan/' threejs.txt >no_number.txt
head -5 threejs.txt >few.txt
head -50 alone.txt >part.txt
cut -d' ' -f1-7 threejs.txt >two_bands.txt
cut -d' ' -f1-8 threejs.txt >no_square.txt
: >empty.txt
echo '# nothing' >remarks.txt
head -c 3000 /dev/zero >zeros.bin
