#!/bin/sh
# Makes the picture of the scenes about contact: pictures.sh TAUT FILE.png. It simulates for some minutes; needs ffmpeg.
set -eu
taut=$1
file=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

number=0
while read -r scene frame; do
  number=$((number + 1))
  "$taut" render "$scene" --frames "$frame" --set picture.width=400 --set picture.height=300 \
    --output "$folder/$number.png"
done <<'END'
rotating-sphere 140
rotating-sphere-tenth-percent 220
twisted-cylinder 400
reef-knot 262
funnel 130
needles 92
layers 34
table-cloth-1 96
table-cloth-8 64
END
# Few colours, so that it is small.
ffmpeg -loglevel error -y -start_number 1 -i "$folder/%d.png" -frames:v 1 -filter_complex \
  'tile=3x3:padding=4:color=white,split[a][b];[a]palettegen=max_colors=128[p];[b][p]paletteuse=dither=none' "$file"
