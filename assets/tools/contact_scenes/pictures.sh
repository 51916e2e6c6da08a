#!/bin/sh
# Makes the picture of the scenes about contact: pictures.sh TAUT FILE.png. It simulates for some minutes; needs ffmpeg.
set -eu
taut=$1
file=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

number=0
# A scene, its frame, and a view that is closer than the whole motion needs.
while read -r scene frame box; do
  number=$((number + 1))
  "$taut" render "$scene" --frames "$frame" --set picture.width=400 --set picture.height=300 \
    ${box:+--set "camera.box=$box"} --output "$folder/$number.png"
done <<'END'
rotating-sphere 140
rotating-sphere-tenth-percent 220
twisted-cylinder 400
reef-knot 262
funnel 130
needles 92 [[-0.85, -0.22, -0.5], [0.5, 0.1, 0.5]]
layers 34
table-cloth-1 96 [[-1.1, -0.4, -0.4], [0.4, 0.0, 0.4]]
table-cloth-8 64 [[-1.1, -0.5, -0.4], [0.4, 0.35, 0.4]]
END
ffmpeg -loglevel error -y -start_number 1 -i "$folder/%d.png" -frames:v 1 -pix_fmt rgb24 -pred mixed \
  -vf tile=3x3:padding=4:color=white "$file"
